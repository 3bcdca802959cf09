// What a surface does with light.

/// The value of `fresnel` that leaves reflectivity alone.
const NO_FRESNEL: f32 = -1.0;

struct Material {
    /// Diffuse color, linear RGB.
    color: vec3f,
    specular: f32,
    /// Light of its own, linear RGB.
    emission: vec3f,
    /// Blinn-Phong exponent.
    shininess: f32,
    /// Share of light that is mirrored, head on.
    reflectivity: f32,
    /// Exponent by which the mirrored share grows towards grazing angles, or NO_FRESNEL.
    fresnel: f32,
    /// Share of what is not mirrored that passes through.
    transmission: f32,
    /// Index of refraction inside.
    ior: f32,
}

/// Matte: what a material is where the author says nothing else.
fn matte(color: vec3f) -> Material {
    return Material(color, 0.0, vec3f(0.0), 50.0, 0.0, NO_FRESNEL, 0.0, 1.5);
}

/// The sum of what may vary over a surface; the rest is that of `b`.
fn summed(a: Material, b: Material) -> Material {
    return Material(
        a.color + b.color,
        a.specular + b.specular,
        a.emission + b.emission,
        a.shininess + b.shininess,
        a.reflectivity + b.reflectivity,
        b.fresnel,
        a.transmission + b.transmission,
        b.ior,
    );
}

/// A sum of materials as their mean, where `share` is one over their number.
fn meanOf(sum: Material, share: f32) -> Material {
    return Material(
        share * sum.color,
        share * sum.specular,
        share * sum.emission,
        share * sum.shininess,
        share * sum.reflectivity,
        sum.fresnel,
        share * sum.transmission,
        sum.ior,
    );
}

/// The mirrored share of light that arrives at `cosine` from the normal.
fn mirrored(material: Material, cosine: f32) -> f32 {
    let r = material.reflectivity;
    if material.fresnel < 0.0 {
        return r;
    }
    return r + (1.0 - r) * pow(max(1.0 - cosine, 0.0), material.fresnel);
}

/// The direction in which a ray goes on through the surface by Snell's law; the mirrored one under
/// total internal reflection. `normal` faces the ray, `ratio` is the index before over the one behind.
fn refracted(direction: vec3f, normal: vec3f, ratio: f32) -> vec3f {
    let cosine = -dot(direction, normal);
    let k = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    if k < 0.0 {
        return reflect(direction, normal);
    }
    return ratio * direction + (ratio * cosine - sqrt(k)) * normal;
}
