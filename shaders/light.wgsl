// Lights as one point of the scene sees them.

/// A light's centre from a point, and the area around it.
struct Light {
    /// From the point to the light's centre; length 1 where the light is infinitely far.
    to: vec3f,
    /// The t along `to` at which the light stands.
    reach: f32,
    /// What arrives where nothing is in the way: color · intensity · falloff.
    arriving: vec3f,
    /// Half axes of the light's area; zero for a light without size.
    u: vec3f,
    v: vec3f,
    /// An ellipse over u and v, or a parallelogram.
    round: bool,
}

/// A ball of light, or a point where radius is 0.
fn pointLight(p: vec3f, position: vec3f, radius: f32, color: vec3f) -> Light {
    let to = position - p;
    let facing = frameAround(normalize(to));
    return Light(to, 1.0, color, radius * facing[0], radius * facing[1], true);
}

/// Light that travels along `direction`, from a disk of the sky whose half angle has `spread` as its tangent.
fn directionalLight(direction: vec3f, spread: f32, color: vec3f) -> Light {
    let facing = frameAround(-direction);
    return Light(-direction, NO_HIT, color, spread * facing[0], spread * facing[1], true);
}

/// A point light that shines into a cone, full inside the cosine `inner`, dark outside `outer`.
fn spotLight(
    p: vec3f,
    position: vec3f,
    radius: f32,
    axis: vec3f,
    inner: f32,
    outer: f32,
    color: vec3f,
) -> Light {
    var light = pointLight(p, position, radius, color);
    let x = clamp((dot(-normalize(light.to), axis) - outer) / max(inner - outer, 1e-6), 0.0, 1.0);
    light.arriving *= x * x * (3.0 - 2.0 * x);
    return light;
}

/// A shining parallelogram.
fn rectLight(p: vec3f, corner: vec3f, u: vec3f, v: vec3f, color: vec3f) -> Light {
    return Light(corner + 0.5 * (u + v) - p, 1.0, color, 0.5 * u, 0.5 * v, false);
}

/// The same light, weaker by the square of its distance.
fn inverseSquare(light: Light) -> Light {
    var weaker = light;
    weaker.arriving /= max(dot(light.to, light.to), 1e-12);
    return weaker;
}

/// From the point to the light at a place of its area, given in the unit square.
fn towards(light: Light, place: vec2f) -> vec3f {
    let angle = 6.2831853 * place.y;
    let disk = sqrt(place.x) * vec2f(cos(angle), sin(angle));
    let on = select(2.0 * place - 1.0, disk, light.round);
    return light.to + on.x * light.u + on.y * light.v;
}
