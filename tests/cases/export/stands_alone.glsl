// tests/cases/export/stands_alone.ron: a scene as a shader of its own
// Written by raytoy 0.1.0: raytoy generate tests/cases/export/stands_alone.ron --lang glsl
//
// Paste all of it at shadertoy.com/new, in place of what is there.
//
//   setScene()   the camera, and what the scene says under `render`: numbers to play with
//   shown()      exposure, tone map and transfer curve
//   iTime        is the time of what moves
//   iMouse       is where the pointer was last pressed, for scenes that ask for it
//
// naga has translated it from WGSL. To read it with its comments: raytoy generate --standalone
//
//   objects   floor, ball
//   shapes    Plane, Sphere
//   textures  Checker, Gradient

struct Ray {
    vec3 origin;
    float t_min;
    vec3 direction;
    float t_max;
};
struct Hit {
    float t;
    uint object;
    float slack;
};
struct Surface {
    vec3 position;
    vec3 normal;
    vec3 facet;
    vec2 uv;
    vec3 world;
    float footprint;
    vec4 whole;
    float rise;
};
struct Placed {
    Surface at;
    vec3 normal;
    vec3 facet;
    float scale;
    float gap;
    float rise;
};
struct Material {
    vec3 color;
    float specular;
    vec3 emission;
    float shininess;
    float reflectivity;
    float fresnel;
    float transmission;
    float ior;
};
struct Light {
    vec3 to;
    float reach;
    vec3 arriving;
    float radius;
    vec3 u;
    vec3 v;
};
struct Frame {
    vec3 eye;
    float time;
    vec3 right;
    float pixel_spread;
    vec3 up;
    uint max_bounces;
    vec3 forward;
    uint shadow_samples;
    vec2 resolution;
    vec2 mouse;
    vec2 jitter;
    uint sample_;
    uint view;
    uint casters;
    uint beside;
    float divider;
    float reach;
};
struct Seen {
    vec3 radiance;
    float depth;
    vec3 value;
    uint object;
    uint bounces;
};
struct Branch {
    vec3 origin;
    float weight;
    vec3 direction;
    float width;
    vec4 media;
    uint depth;
};
struct Looked {
    vec3 point;
    Placed met;
    Material material;
};
struct Shade {
    vec3 light;
    float visibility;
};
const uint OBJECT_FLOOR = 0u;
const uint OBJECT_BALL = 1u;
const uint LIGHTS = 1u;
const bool TRANSMITS = false;
const uint NO_OBJECT = 4294967295u;
const float SAME_PLACE = 4e-6;
const float NO_HIT = 1e30;
const float NO_FRESNEL = -1.0;
const mat3x3 OCTAVE_TURN = mat3x3(vec3(0.48, 0.8, -0.36), vec3(-0.64, 0.6, 0.48), vec3(0.6, 0.0, 0.8));
const vec3 OCTAVE_SHIFT = vec3(7.31, -3.57, 5.83);
const uint MAX_WAITING = 9u;
const vec4 AIR = vec4(1.0);
const uint MAX_RAYS = 1024u;
const uint HIGH_HALF = 4294963200u;
const float MOST_SLIP = 1e-6;
const uint MOST_LOOKS = 9u;
const float SPAWN_ERROR = 1e-5;
const float MIN_WEIGHT = 0.001953125;

uint work = 0u;

Frame frame = Frame(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0u, vec3(0.0), 0u, vec2(0.0), vec2(0.0), vec2(0.0), 0u, 0u, 0u, 0u, 0.0, 0.0);

uint zero = 0u;

uint seed = 0u;

float slackOf(Ray ray) {
    vec3 origin_3 = abs(ray.origin);
    vec3 direction_4 = abs(ray.direction);
    float size = max(max(origin_3.x, origin_3.y), origin_3.z);
    return ((SAME_PLACE * size) / max(max(direction_4.x, direction_4.y), direction_4.z));
}

Hit noHit(Ray ray_1) {
    float _e3 = slackOf(ray_1);
    return Hit(ray_1.t_max, NO_OBJECT, _e3);
}

Hit nearer(Hit hit, float t, uint object) {
    uint _e5 = work;
    work = (_e5 + 1u);
    if ((t < ((hit.t * 0.999996) - hit.slack))) {
        return Hit(t, object, hit.slack);
    }
    return hit;
}

float onRay(Ray ray_2, float t_1) {
    bool local = false;
    if ((t_1 > ray_2.t_min)) {
        local = (t_1 < ray_2.t_max);
    } else {
        local = false;
    }
    bool _e10 = local;
    return (_e10 ? t_1 : NO_HIT);
}

float plane(Ray ray_3, vec3 normal, float offset) {
    float approach = dot(normal, ray_3.direction);
    if ((abs(approach) < 1e-20)) {
        return NO_HIT;
    }
    float _e13 = onRay(ray_3, ((offset - dot(normal, ray_3.origin)) / approach));
    return _e13;
}

float nearestApproach(Ray ray_4, vec3 center) {
    return (dot((center - ray_4.origin), ray_4.direction) * (1.0 / dot(ray_4.direction, ray_4.direction)));
}

float firstOnRay(Ray ray_5, float near, float far) {
    float _e6 = onRay(ray_5, ((near > ray_5.t_min) ? near : far));
    return _e6;
}

float sphere(Ray ray_6, vec3 center_1, float radius) {
    float _e3 = nearestApproach(ray_6, center_1);
    vec3 nearest = ((ray_6.origin - center_1) + (_e3 * ray_6.direction));
    float inside = ((radius * radius) - dot(nearest, nearest));
    if ((inside < 0.0)) {
        return NO_HIT;
    }
    float reach = sqrt((inside / dot(ray_6.direction, ray_6.direction)));
    float _e22 = firstOnRay(ray_6, (_e3 - reach), (_e3 + reach));
    return _e22;
}

Hit rayTraceScene(Ray ray_7) {
    Hit hit_1 = Hit(0.0, 0u, 0.0);
    Hit _e1 = noHit(ray_7);
    hit_1 = _e1;
    Hit _e3 = hit_1;
    float _e9 = plane(ray_7, vec3(0.0, 1.0, 0.0), 0.0);
    Hit _e11 = nearer(_e3, _e9, OBJECT_FLOOR);
    hit_1 = _e11;
    Hit _e12 = hit_1;
    float _e18 = sphere(ray_7, vec3(0.0, 1.0, 0.0), 1.0);
    Hit _e20 = nearer(_e12, _e18, OBJECT_BALL);
    hit_1 = _e20;
    Hit _e21 = hit_1;
    return _e21;
}

bool sceneBlocks(Ray ray_8) {
    float _e6 = plane(ray_8, vec3(0.0, 1.0, 0.0), 0.0);
    if ((_e6 < NO_HIT)) {
        return true;
    }
    float _e15 = sphere(ray_8, vec3(0.0, 1.0, 0.0), 1.0);
    if ((_e15 < NO_HIT)) {
        return true;
    }
    return false;
}

Placed placed(Surface at, vec3 p) {
    return Placed(at, at.normal, at.facet, 1.0, dot((at.position - p), at.facet), at.rise);
}

Surface surface(vec3 position, vec3 normal_1, vec2 uv) {
    return Surface(position, normal_1, normal_1, uv, position, 0.0, vec4(0.0), 0.0);
}

mat2x3 flatTangents(vec3 n) {
    bool local_1 = false;
    vec3 a_1 = abs(n);
    bool level = (a_1.y >= max(a_1.x, a_1.z));
    if (!(level)) {
        local_1 = (a_1.x > a_1.z);
    } else {
        local_1 = false;
    }
    bool _e22 = local_1;
    vec3 first = (_e22 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0));
    vec3 second = (level ? vec3(0.0, 0.0, 1.0) : vec3(0.0, 1.0, 0.0));
    vec3 u = normalize((first - (dot(first, n) * n)));
    vec3 v_2 = cross(n, u);
    return mat2x3(u, ((dot(v_2, second) < 0.0) ? -(v_2) : v_2));
}

Surface planeSurface(vec3 p_1, vec3 normal_2, float offset_1) {
    float size_1 = length(normal_2);
    vec3 n_4 = (normal_2 / vec3(size_1));
    vec3 snapped = (p_1 - ((dot(n_4, p_1) - (offset_1 / size_1)) * n_4));
    mat2x3 _e11 = flatTangents(n_4);
    Surface _e13 = surface(snapped, n_4, (snapped * _e11));
    return _e13;
}

Surface sphereSurface(vec3 p_2, vec3 center_2, float radius_1) {
    Surface at_1 = Surface(vec3(0.0), vec3(0.0), vec3(0.0), vec2(0.0), vec3(0.0), 0.0, vec4(0.0), 0.0);
    vec3 normal_5 = normalize((p_2 - center_2));
    float longitude = atan(normal_5.z, ((abs(normal_5.x) < 1e-20) ? 1e-20 : normal_5.x));
    float latitude = atan(normal_5.y, max(length(normal_5.xz), 1e-20));
    Surface _e24 = surface((center_2 + (radius_1 * normal_5)), normal_5, (radius_1 * vec2(longitude, latitude)));
    at_1 = _e24;
    at_1.whole = ((1.5707963 * radius_1) * vec4(2.0, -1.0, -4.0, 2.0));
    Surface _e35 = at_1;
    return _e35;
}

Placed surfaceAt(uint object_1, vec3 p_3) {
    switch(object_1) {
        case 0u: {
            Surface _e7 = planeSurface(p_3, vec3(0.0, 1.0, 0.0), 0.0);
            Placed _e8 = placed(_e7, p_3);
            return _e8;
        }
        case 1u: {
            Surface _e14 = sphereSurface(p_3, vec3(0.0, 1.0, 0.0), 1.0);
            Placed _e15 = placed(_e14, p_3);
            return _e15;
        }
        default: {
            Surface _e22 = surface(p_3, vec3(0.0, 1.0, 0.0), vec2(0.0));
            Placed _e23 = placed(_e22, p_3);
            return _e23;
        }
    }
}

Material matte(vec3 color) {
    return Material(color, 0.0, vec3(0.0), 50.0, 0.0, NO_FRESNEL, 0.0, 1.5);
}

vec2 dutyShare(vec2 x, vec2 width, float duty) {
    vec2 f = (x - floor(x));
    vec2 a_2 = (f - (0.5 * width));
    vec2 b_1 = (f + (0.5 * width));
    vec2 w = max(width, vec2(1e-20));
    vec2 ends = (min((b_1 - floor(b_1)), vec2(duty)) - min((a_2 - floor(a_2)), vec2(duty)));
    vec2 wide = ((((floor(b_1) - floor(a_2)) * duty) + ends) / w);
    bvec2 inside_1 = lessThan(f, vec2(duty));
    vec2 edge = mix(max((vec2(duty) - f), (f - vec2(1.0))), min(f, (vec2(duty) - f)), inside_1);
    vec2 narrow = clamp((vec2(0.5) + (edge / w)), vec2(0.0), vec2(1.0));
    vec2 soft = mix(wide, narrow, lessThan(width, vec2(min(duty, (1.0 - duty)))));
    return mix(soft, vec2(inside_1), equal(width, vec2(0.0)));
}

vec3 checker(Surface at_2, float scale, vec3 even, vec3 odd) {
    float half_scale = (0.5 * scale);
    vec2 _e12 = dutyShare((at_2.uv * half_scale), vec2((at_2.footprint * half_scale)), 0.5);
    vec2 side = ((2.0 * _e12) - vec2(1.0));
    float share_1 = (0.5 + ((0.5 * side.x) * side.y));
    return ((even * share_1) + (odd * (1.0 - share_1)));
}

Material floorMaterial(Surface at_3) {
    vec3 _e6 = checker(at_3, 1.0, vec3(0.2), vec3(0.6));
    Material _e7 = matte(_e6);
    return _e7;
}

Material ballMaterial(Surface at_4) {
    Material material = Material(vec3(0.0), 0.0, vec3(0.0), 0.0, 0.0, 0.0, 0.0, 0.0);
    Material _e5 = matte(vec3(1.0, 0.12477182, 0.06301002));
    material = _e5;
    material.reflectivity = 0.2;
    Material _e9 = material;
    return _e9;
}

Material materialAt(uint object_2, Surface at_5) {
    switch(object_2) {
        case 0u: {
            Material _e2 = floorMaterial(at_5);
            return _e2;
        }
        case 1u: {
            Material _e3 = ballMaterial(at_5);
            return _e3;
        }
        default: {
            Material _e6 = matte(vec3(0.0));
            return _e6;
        }
    }
}

bool isTextured(uint object_3) {
    switch(object_3) {
        case 0u: {
            return true;
        }
        default: {
            return false;
        }
    }
}

vec3 normalAt(uint object_4, Placed met) {
    return met.normal;
}

Surface skyPoint(vec3 direction) {
    Surface at_6 = Surface(vec3(0.0), vec3(0.0), vec3(0.0), vec2(0.0), vec3(0.0), 0.0, vec4(0.0), 0.0);
    vec2 uv_1 = vec2(atan(direction.z, direction.x), asin(clamp(direction.y, -1.0, 1.0)));
    Surface _e10 = surface(direction, direction, uv_1);
    at_6 = _e10;
    at_6.whole = vec4(-3.1415925, -1.5707963, 6.283185, 3.1415925);
    Surface _e18 = at_6;
    return _e18;
}

vec3 gradient(Surface at_7, vec3 zenith, vec3 horizon) {
    float height = clamp(at_7.position.y, 0.0, 1.0);
    return ((horizon * (1.0 - height)) + (zenith * height));
}

vec3 background(vec3 direction_1) {
    Surface _e1 = skyPoint(direction_1);
    vec3 _e10 = gradient(_e1, vec3(0.10946172, 0.24620135, 0.58407843), vec3(0.73791045, 0.8148466, 0.91309863));
    return _e10;
}

vec3 ambientLight() {
    return vec3(0.1);
}

Light pointLight(vec3 p_4, vec3 position_1, float radius_2, vec3 color_1) {
    return Light((position_1 - p_4), 1.0, color_1, radius_2, vec3(0.0), vec3(0.0));
}

Light lightAt(uint index, vec3 p_5) {
    switch(index) {
        case 0u: {
            Light _e9 = pointLight(p_5, vec3(4.0, 6.0, 5.0), 0.5, vec3(1.0));
            return _e9;
        }
        default: {
            Light _e13 = pointLight(p_5, p_5, 0.0, vec3(0.0));
            return _e13;
        }
    }
}

vec3 encodedSrgb(vec3 light) {
    vec3 low = (light * 12.92);
    vec3 high = ((1.055 * pow(light, vec3(0.41666666))) - vec3(0.055));
    return mix(high, low, lessThanEqual(light, vec3(0.0031308)));
}

vec3 tonedAces(vec3 x_1) {
    return clamp(((x_1 * ((2.51 * x_1) + vec3(0.03))) / ((x_1 * ((2.43 * x_1) + vec3(0.59))) + vec3(0.14))), vec3(0.0), vec3(1.0));
}

vec3 shown(vec3 light_1) {
    vec3 exposed = max((1.4142135 * light_1), vec3(0.0));
    vec3 _e6 = tonedAces(exposed);
    vec3 _e7 = encodedSrgb(_e6);
    return _e7;
}

void setScene() {
    frame.eye = vec3(0.0, 2.0, 6.0);
    frame.right = vec3(0.3639702, 0.0, 0.0);
    frame.up = vec3(0.0, 0.359018, -0.059836328);
    frame.forward = vec3(0.0, -0.16439898, -0.9863939);
    float _e29 = frame.resolution.y;
    frame.pixel_spread = (0.72794044 / _e29);
    frame.max_bounces = 5u;
    frame.shadow_samples = 16u;
    return;
}

uint hashed(uint x_2) {
    uint state = ((x_2 * 747796405u) + 2891336453u);
    uint word = (((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u);
    return ((word >> 22u) ^ word);
}

vec3 rayPointFrom(Ray ray_9, float t_2, vec3 center_3) {
    float t_high = uintBitsToFloat((floatBitsToUint(t_2) & HIGH_HALF));
    float t_low = (t_2 - t_high);
    vec3 high_1 = uintBitsToFloat((floatBitsToUint(ray_9.direction) & uvec3(4294963200u)));
    vec3 low_1 = (ray_9.direction - high_1);
    vec3 way = (t_high * high_1);
    vec3 there_1 = (ray_9.origin + way);
    vec3 apart = (ray_9.origin - center_3);
    vec3 point = mix((there_1 - center_3), (apart + way), lessThan(abs(apart), abs(there_1)));
    return (((point + (t_low * high_1)) + (t_high * low_1)) + (t_low * low_1));
}

vec3 rayPoint(Ray ray_10, float t_3) {
    vec3 _e4 = rayPointFrom(ray_10, t_3, vec3(0.0));
    return _e4;
}

vec3 slipAlong(Ray ray_11, float t_4, Placed there) {
    float approach_1 = dot(there.facet, ray_11.direction);
    float slip = (there.gap / ((abs(approach_1) < 1e-20) ? 1e-20 : approach_1));
    float most = (4e-6 * t_4);
    return (clamp(slip, -(most), most) * ray_11.direction);
}

Material summed(Material a, Material b) {
    return Material((a.color + b.color), (a.specular + b.specular), (a.emission + b.emission), (a.shininess + b.shininess), (a.reflectivity + b.reflectivity), b.fresnel, (a.transmission + b.transmission), b.ior);
}

Material meanOf(Material sum, float share) {
    return Material((share * sum.color), (share * sum.specular), (share * sum.emission), (share * sum.shininess), (share * sum.reflectivity), sum.fresnel, (share * sum.transmission), sum.ior);
}

Looked looked(Ray ray_12, Hit hit_2, float width_1) {
    Looked seen = Looked(vec3(0.0), Placed(Surface(vec3(0.0), vec3(0.0), vec3(0.0), vec2(0.0), vec3(0.0), 0.0, vec4(0.0), 0.0), vec3(0.0), vec3(0.0), 0.0, 0.0, 0.0), Material(vec3(0.0), 0.0, vec3(0.0), 0.0, 0.0, 0.0, 0.0, 0.0));
    bool corrected = false;
    float footprint = 0.0;
    vec3 step_ = vec3(0.0);
    uint looks = 1u;
    uint look = 0u;
    bool local_2 = false;
    Surface at_8 = Surface(vec3(0.0), vec3(0.0), vec3(0.0), vec2(0.0), vec3(0.0), 0.0, vec4(0.0), 0.0);
    vec3 _e6 = rayPoint(ray_12, hit_2.t);
    seen.point = _e6;
    while(true) {
        uint _e18 = look;
        uint _e19 = looks;
        if ((_e18 < _e19)) {
        } else {
            break;
        }
        {
            uint _e21 = look;
            uint _e27 = look;
            float place = (float(((_e21 + 1u) / 2u)) * (((_e27 & 1u) == 1u) ? 1.0 : -1.0));
            vec3 _e38 = seen.point;
            vec3 _e39 = step_;
            Placed _e42 = surfaceAt(hit_2.object, (_e38 + (place * _e39)));
            bool _e43 = corrected;
            if (!(_e43)) {
                corrected = true;
                vec3 _e47 = slipAlong(ray_12, hit_2.t, _e42);
                vec3 _e51 = seen.point;
                if ((length(_e47) > (MOST_SLIP * length(_e51)))) {
                    vec3 _e56 = seen.point;
                    seen.point = (_e56 + _e47);
                    continue;
                }
            }
            uint _e58 = look;
            if ((_e58 == 0u)) {
                seen.met = _e42;
                float cosine_1 = max(abs(dot(_e42.normal, ray_12.direction)), 0.02);
                vec3 along = (ray_12.direction - (dot(ray_12.direction, _e42.normal) * _e42.normal));
                uint wanted = ((2u * uint((0.5 / cosine_1))) + 1u);
                if ((width_1 > 0.0)) {
                    bool _e87 = isTextured(hit_2.object);
                    local_2 = _e87;
                } else {
                    local_2 = false;
                }
                bool varies = local_2;
                uint _e95 = zero;
                looks = ((varies ? min(wanted, MOST_LOOKS) : 1u) + _e95);
                uint _e103 = looks;
                step_ = (((along / vec3(max(length(along), 1e-6))) * width_1) / vec3((cosine_1 * float(_e103))));
                uint _e108 = looks;
                footprint = (max(width_1, (width_1 / (cosine_1 * float(_e108)))) * _e42.scale);
                seen.met.at.footprint = ((width_1 * _e42.scale) / cosine_1);
            }
            at_8 = _e42.at;
            float _e124 = footprint;
            at_8.footprint = _e124;
            Material _e127 = seen.material;
            Surface _e129 = at_8;
            Material _e130 = materialAt(hit_2.object, _e129);
            Material _e131 = summed(_e127, _e130);
            seen.material = _e131;
            uint _e133 = look;
            look = (_e133 + 1u);
        }
    }
    Material _e137 = seen.material;
    uint _e138 = looks;
    Material _e142 = meanOf(_e137, (1.0 / float(_e138)));
    seen.material = _e142;
    Looked _e143 = seen;
    return _e143;
}

vec3 spawnPoint(vec3 p_6, vec3 normal_3, float t_5) {
    float size_2 = max(max(abs(p_6.x), abs(p_6.y)), max(abs(p_6.z), t_5));
    return (p_6 + ((SPAWN_ERROR * size_2) * normal_3));
}

mat3x3 frameAround(vec3 axis) {
    float s = ((axis.z >= 0.0) ? 1.0 : -1.0);
    float a_3 = (-1.0 / (s + axis.z));
    float b_2 = ((axis.x * axis.y) * a_3);
    return mat3x3(vec3((1.0 + (((s * axis.x) * axis.x) * a_3)), (s * b_2), (-(s) * axis.x)), vec3(b_2, (s + ((axis.y * axis.y) * a_3)), -(axis.y)), axis);
}

float visibleShare(Light light_2, vec3 origin) {
    vec2 spoke = vec2(0.0);
    float open = 0.0;
    uint i = 0u;
    uint _e4 = frame.shadow_samples;
    uint _e6 = zero;
    uint rays_1 = (_e4 + _e6);
    uint n_5 = ((light_2.radius == 0.0) ? min(rays_1, 1u) : rays_1);
    if ((n_5 == 0u)) {
        return 1.0;
    }
    bool round_ = (light_2.radius >= 0.0);
    mat3x3 _e22 = frameAround(normalize(light_2.to));
    vec3 u_1 = (round_ ? (light_2.radius * _e22[0]) : light_2.u);
    vec3 v_3 = (round_ ? (light_2.radius * _e22[1]) : light_2.v);
    uint _e34 = seed;
    uint _e39 = seed;
    vec2 turn = (vec2(float((_e34 & 65535u)), float((_e39 >> 16u))) / vec2(65536.0));
    spoke = normalize(((turn - vec2(0.5)) + vec2(1e-6)));
    uint _e56 = work;
    uint _e59 = frame.casters;
    work = (_e56 + (n_5 * _e59));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e120 = i;
            i = (_e120 + 1u);
        }
        loop_init = false;
        uint _e66 = i;
        if ((_e66 < n_5)) {
        } else {
            break;
        }
        {
            vec2 _e68 = spoke;
            float _e72 = spoke.y;
            float _e75 = spoke.x;
            spoke = ((-0.7373689 * _e68) + (0.6754903 * vec2(-(_e72), _e75)));
            uint _e80 = i;
            vec2 _e87 = spoke;
            vec2 disk = (sqrt(((float(_e80) + turn.x) / float(n_5))) * _e87);
            uint _e89 = i;
            vec2 square = ((2.0 * fract((turn + (float(_e89) * vec2(0.7548777, 0.5698403))))) - vec2(1.0));
            vec2 on = (round_ ? disk : square);
            Ray ray_13 = Ray(origin, 0.0, ((light_2.to + (on.x * u_1)) + (on.y * v_3)), light_2.reach);
            float _e113 = open;
            bool _e114 = sceneBlocks(ray_13);
            open = (_e113 + (_e114 ? 0.0 : 1.0));
        }
    }
    float _e122 = open;
    return (_e122 / float(n_5));
}

Shade shade(vec3 p_7, vec3 origin_1, vec3 n_1, vec3 v, Material material_1) {
    vec3 sum_1 = vec3(0.0);
    float visible = 0.0;
    float facing = 0.0;
    uint i_1 = 0u;
    bool local_3 = false;
    vec3 _e6 = ambientLight();
    sum_1 = (material_1.emission + (_e6 * material_1.color));
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e66 = i_1;
            i_1 = (_e66 + 1u);
        }
        loop_init_1 = false;
        uint _e17 = i_1;
        if ((_e17 < LIGHTS)) {
        } else {
            break;
        }
        {
            uint _e20 = i_1;
            Light _e21 = lightAt(_e20, p_7);
            vec3 l = normalize(_e21.to);
            float cosine_2 = dot(n_1, l);
            if ((cosine_2 > 0.0)) {
                local_3 = (max(max(_e21.arriving.x, _e21.arriving.y), _e21.arriving.z) > 0.0);
            } else {
                local_3 = false;
            }
            bool _e40 = local_3;
            if (_e40) {
                float _e41 = visibleShare(_e21, origin_1);
                vec3 h = normalize((l + v));
                float highlight = (material_1.specular * pow(max(dot(n_1, h), 0.0), material_1.shininess));
                vec3 _e51 = sum_1;
                sum_1 = (_e51 + ((_e41 * _e21.arriving) * ((material_1.color * cosine_2) + vec3(highlight))));
                float _e60 = visible;
                visible = (_e60 + _e41);
                float _e62 = facing;
                facing = (_e62 + 1.0);
            }
        }
    }
    vec3 _e68 = sum_1;
    float _e69 = visible;
    float _e70 = facing;
    return Shade(_e68, (_e69 / max(_e70, 1.0)));
}

vec3 surfaceView(Hit hit_3, Placed met_1, vec3 n_2, vec3 v_1, vec3 albedo, float visibility) {
    return vec3(0.0);
}

float mirrored(Material material_2, float cosine) {
    float r = material_2.reflectivity;
    if ((material_2.fresnel < 0.0)) {
        return r;
    }
    return (r + ((1.0 - r) * pow(max((1.0 - cosine), 0.0), material_2.fresnel)));
}

vec3 refracted(vec3 direction_2, vec3 normal_4, float ratio) {
    float cosine_3 = -(dot(direction_2, normal_4));
    float k = (1.0 - ((ratio * ratio) * (1.0 - (cosine_3 * cosine_3))));
    if ((k < 0.0)) {
        return reflect(direction_2, normal_4);
    }
    return ((ratio * direction_2) + (((ratio * cosine_3) - sqrt(k)) * normal_4));
}

vec4 mediaBehind(vec4 media, float ior, bool leaves) {
    bool local_4 = false;
    bool local_5 = false;
    bool local_6 = false;
    if (!(leaves)) {
        return vec4(ior, media.xyz);
    }
    bvec4 is_it = equal(media, vec4(ior));
    if (!(is_it.x)) {
        local_4 = is_it.y;
    } else {
        local_4 = false;
    }
    bool _e14 = local_4;
    if (_e14) {
        return vec4(media.x, media.zw, 1.0);
    }
    if (!(is_it.x)) {
        local_5 = is_it.z;
    } else {
        local_5 = false;
    }
    bool _e25 = local_5;
    if (_e25) {
        return vec4(media.xy, media.w, 1.0);
    }
    if (!(is_it.x)) {
        local_6 = is_it.w;
    } else {
        local_6 = false;
    }
    bool _e36 = local_6;
    if (_e36) {
        return vec4(media.xyz, 1.0);
    }
    return vec4(media.yzw, 1.0);
}

float indexRatio(vec4 media_1, float ior_1, bool leaves_1) {
    bool local_7 = false;
    if (!(!(leaves_1))) {
        local_7 = any(equal(media_1, vec4(ior_1)));
    } else {
        local_7 = true;
    }
    bool is_known = local_7;
    vec4 _e14 = mediaBehind(media_1, ior_1, leaves_1);
    return ((is_known ? media_1.x : ior_1) / _e14.x);
}

Seen traceTree(vec3 origin_2, vec3 direction_3) {
    Seen seen_1 = Seen(vec3(0.0), -1.0, vec3(0.0), 4294967295u, 0u);
    Branch waiting[9] = Branch[9](Branch(vec3(0.0), 0.0, vec3(0.0), 0.0, vec4(0.0), 0u), Branch(vec3(0.0), 0.0, vec3(0.0), 0.0, vec4(0.0), 0u), Branch(vec3(0.0), 0.0, vec3(0.0), 0.0, vec4(0.0), 0u), Branch(vec3(0.0), 0.0, vec3(0.0), 0.0, vec4(0.0), 0u), Branch(vec3(0.0), 0.0, vec3(0.0), 0.0, vec4(0.0), 0u), Branch(vec3(0.0), 0.0, vec3(0.0), 0.0, vec4(0.0), 0u), Branch(vec3(0.0), 0.0, vec3(0.0), 0.0, vec4(0.0), 0u), Branch(vec3(0.0), 0.0, vec3(0.0), 0.0, vec4(0.0), 0u), Branch(vec3(0.0), 0.0, vec3(0.0), 0.0, vec4(0.0), 0u));
    uint waits = 0u;
    Branch branch = Branch(vec3(0.0), 0.0, vec3(0.0), 0.0, vec4(0.0), 0u);
    uint rays = 0u;
    bool follows = false;
    vec3 n_3 = vec3(0.0);
    bool local_8 = false;
    bool local_9 = false;
    bool local_10 = false;
    vec3 away = vec3(0.0);
    Branch heavier = Branch(vec3(0.0), 0.0, vec3(0.0), 0.0, vec4(0.0), 0u);
    bool local_11 = false;
    bool local_12 = false;
    bool local_13 = false;
    branch = Branch(origin_2, 1.0, direction_3, 0.0, AIR, 0u);
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            uint _e243 = rays;
            rays = (_e243 + 1u);
        }
        loop_init_2 = false;
        uint _e22 = rays;
        if ((_e22 < MAX_RAYS)) {
        } else {
            break;
        }
        {
            vec3 _e26 = branch.origin;
            vec3 _e28 = branch.direction;
            Ray ray_14 = Ray(_e26, 0.0, _e28, NO_HIT);
            Hit _e32 = rayTraceScene(ray_14);
            uint depth = branch.depth;
            uint _e37 = seen_1.bounces;
            seen_1.bounces = max(_e37, depth);
            follows = false;
            if ((_e32.object == NO_OBJECT)) {
                vec3 _e45 = seen_1.radiance;
                float _e47 = branch.weight;
                vec3 _e49 = branch.direction;
                vec3 _e50 = background(_e49);
                seen_1.radiance = (_e45 + (_e47 * _e50));
            } else {
                vec3 _e54 = branch.direction;
                vec3 v_4 = -(_e54);
                float _e57 = branch.width;
                float _e60 = frame.pixel_spread;
                float width_2 = (_e57 + (_e60 * _e32.t));
                Looked _e64 = looked(ray_14, _e32, width_2);
                vec3 p_8 = _e64.point;
                Placed met_2 = _e64.met;
                Material material_3 = _e64.material;
                bool inside_2 = (dot(met_2.facet, v_4) < 0.0);
                vec3 facing_1 = (inside_2 ? -(met_2.facet) : met_2.facet);
                vec3 _e77 = normalAt(_e32.object, met_2);
                n_3 = _e77;
                vec3 _e79 = n_3;
                vec3 _e80 = n_3;
                n_3 = (inside_2 ? -(_e80) : _e79);
                vec3 _e83 = n_3;
                vec3 _e84 = n_3;
                n_3 = normalize((_e83 + (max((0.001 - dot(_e84, v_4)), 0.0) * v_4)));
                vec3 _e98 = spawnPoint(p_8, ((facing_1 + v_4) - (dot(facing_1, v_4) * facing_1)), _e32.t);
                vec3 rise = ((inside_2 ? 0.0 : met_2.rise) * met_2.facet);
                vec3 _e106 = n_3;
                Shade _e107 = shade((p_8 + rise), (_e98 + rise), _e106, v_4, material_3);
                if ((depth == 0u)) {
                    seen_1.depth = _e32.t;
                    seen_1.object = _e32.object;
                    vec3 _e115 = n_3;
                    vec3 _e118 = surfaceView(_e32, met_2, _e115, v_4, material_3.color, _e107.visibility);
                    seen_1.value = _e118;
                }
                vec3 _e119 = n_3;
                float _e124 = mirrored(material_3, clamp(dot(_e119, v_4), 0.0, 1.0));
                float _e126 = branch.weight;
                float stays = (_e126 * (1.0 - _e124));
                vec3 _e131 = seen_1.radiance;
                seen_1.radiance = (_e131 + ((stays * (1.0 - material_3.transmission)) * _e107.light));
                uint _e141 = frame.max_bounces;
                uint _e143 = zero;
                bool deeper = (depth < (_e141 + _e143));
                float _e147 = branch.weight;
                float reflection = (_e147 * _e124);
                float refraction = (stays * material_3.transmission);
                if (deeper) {
                    local_8 = (reflection >= MIN_WEIGHT);
                } else {
                    local_8 = false;
                }
                bool reflects = local_8;
                if (TRANSMITS) {
                    local_9 = deeper;
                } else {
                    local_9 = false;
                }
                bool _e161 = local_9;
                if (_e161) {
                    local_10 = (refraction >= MIN_WEIGHT);
                } else {
                    local_10 = false;
                }
                bool refracts = local_10;
                vec3 into = branch.direction;
                vec4 media_2 = branch.media;
                if (reflects) {
                    vec3 _e172 = n_3;
                    away = reflect(into, _e172);
                    vec3 _e175 = away;
                    vec3 _e176 = away;
                    away = normalize((_e175 + (max((0.001 - dot(_e176, facing_1)), 0.0) * facing_1)));
                    vec3 _e185 = away;
                    branch = Branch(_e98, reflection, _e185, width_2, media_2, (depth + 1u));
                }
                if (refracts) {
                    vec3 _e189 = n_3;
                    float _e191 = indexRatio(media_2, material_3.ior, inside_2);
                    vec3 _e192 = refracted(into, _e189, _e191);
                    bool is_mirrored = (dot(_e192, facing_1) > 0.0);
                    vec3 _e199 = spawnPoint(p_8, (is_mirrored ? facing_1 : -(facing_1)), _e32.t);
                    vec4 _e201 = mediaBehind(media_2, material_3.ior, inside_2);
                    vec4 behind = (is_mirrored ? media_2 : _e201);
                    Branch beyond = Branch(_e199, refraction, _e192, width_2, behind, (depth + 1u));
                    heavier = beyond;
                    if (!(!(reflects))) {
                        local_11 = (reflection > refraction);
                    } else {
                        local_11 = true;
                    }
                    bool _e213 = local_11;
                    if (_e213) {
                        Branch _e214 = branch;
                        heavier = _e214;
                        branch = beyond;
                    }
                    if (reflects) {
                        uint _e215 = waits;
                        Branch _e217 = heavier;
                        waiting[_e215] = _e217;
                        uint _e219 = waits;
                        waits = (_e219 + 1u);
                    }
                }
                if (!(reflects)) {
                    local_12 = refracts;
                } else {
                    local_12 = true;
                }
                bool _e225 = local_12;
                follows = _e225;
            }
            bool _e226 = follows;
            if (!(_e226)) {
                if (false) {
                    uint _e231 = waits;
                    local_13 = (_e231 == 0u);
                } else {
                    local_13 = true;
                }
                bool _e235 = local_13;
                if (_e235) {
                    break;
                }
                uint _e237 = waits;
                waits = (_e237 - 1u);
                uint _e239 = waits;
                Branch _e241 = waiting[_e239];
                branch = _e241;
            }
        }
    }
    Seen _e245 = seen_1;
    return _e245;
}

Seen seenAt(vec2 pixel) {
    vec2 _e3 = frame.jitter;
    vec2 _e9 = frame.resolution;
    float _e17 = frame.resolution.x;
    float _e21 = frame.resolution.y;
    vec2 place_1 = ((((2.0 * (pixel + _e3)) / _e9) - vec2(1.0)) * vec2((_e17 / _e21), -1.0));
    vec3 _e28 = frame.forward;
    vec3 _e32 = frame.right;
    vec3 _e38 = frame.up;
    vec3 direction_5 = normalize(((_e28 + (place_1.x * _e32)) + (place_1.y * _e38)));
    uvec2 at_9 = uvec2(pixel);
    uint _e48 = frame.sample_;
    uint _e49 = hashed(_e48);
    uint _e51 = hashed((at_9.y + _e49));
    uint _e53 = hashed((at_9.x + _e51));
    seed = _e53;
    vec3 _e56 = frame.eye;
    Seen _e57 = traceTree(_e56, direction_5);
    return _e57;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    int _e3 = iFrame;
    zero = uint(min(_e3, 0));
    vec3 _e10 = iResolution;
    frame.resolution = _e10.xy;
    float _e15 = iTime;
    frame.time = _e15;
    vec4 _e17 = iMouse;
    vec2 pressed = abs(_e17.zw);
    float _e27 = iResolution.y;
    frame.mouse = (any(greaterThan(pressed, vec2(0.0))) ? vec2(pressed.x, (_e27 - pressed.y)) : vec2(0.0));
    setScene();
    float _e39 = iResolution.y;
    Seen _e43 = seenAt(vec2(fragCoord.x, (_e39 - fragCoord.y)));
    vec3 _e45 = shown(_e43.radiance);
    fragColor = vec4(_e45, 1.0);
    return;
}

