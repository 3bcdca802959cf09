// What the hand-written shaders ask of the section that raytoy writes for each scene, in the least form that
// is valid: a scene of nothing. docs/dev/generated-text.md says what each is for.

const LIGHTS: u32 = 0u;
const TRANSMITS: bool = false;

fn rayTraceScene(ray: Ray) -> Hit {
    return noHit(ray);
}

fn sceneBlocks(ray: Ray) -> bool {
    return false;
}

fn surfaceAt(object: u32, p: vec3f) -> Placed {
    return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p);
}

fn normalAt(object: u32, met: Placed) -> vec3f {
    return met.normal;
}

fn heightAt(object: u32, at: Surface) -> f32 {
    return 0.0;
}

fn materialAt(object: u32, at: Surface) -> Material {
    return matte(vec3f(0.0));
}

fn isTextured(object: u32) -> bool {
    return false;
}

fn lightAt(index: u32, p: vec3f) -> Light {
    return pointLight(p, p, 0.0, vec3f(0.0));
}

fn background(direction: vec3f) -> vec3f {
    return vec3f(0.0);
}

fn ambientLight() -> vec3f {
    return vec3f(0.0);
}

fn measuredAt(hit: Hit, at: Surface, facing: f32) -> f32 {
    return 0.0;
}

fn shown(light: vec3f) -> vec3f {
    return light;
}

fn setScene() {}
