// Lights of other kinds than a point or ball.

/// Light that travels along `direction`, from a disk of the sky whose half angle has `spread` as its tangent.
fn directionalLight(direction: vec3f, spread: f32, color: vec3f) -> Light {
    return Light(-direction, NO_HIT, color, spread, vec3f(0.0), vec3f(0.0));
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
    return Light(corner + 0.5 * (u + v) - p, 1.0, color, -1.0, 0.5 * u, 0.5 * v);
}

/// The same light, weaker by the square of its distance.
fn inverseSquare(light: Light) -> Light {
    var weaker = light;
    weaker.arriving /= max(dot(light.to, light.to), 1e-12);
    return weaker;
}
