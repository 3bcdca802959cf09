// In place of view.wgsl where a scene stands on its own: its picture shows the light and nothing else.

fn surfaceView(hit: Hit, met: Placed, n: vec3f, v: vec3f, albedo: vec3f, visibility: f32) -> vec3f {
    return vec3f(0.0);
}
