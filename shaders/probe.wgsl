// Questions to the scene's own functions, many at a time and without a picture. Asked by gpu/probe.rs, whose
// structs have the same layout; no other shader includes this file.

struct ProbePoint {
    position: vec3f,
    footprint: f32,
    normal: vec3f,
    object: u32,
    world: vec3f,
    uv: vec2f,
}

struct ProbeLook {
    color: vec3f,
    emission: vec3f,
}

struct ProbeCrossing {
    position: vec3f,
    t: f32,
    normal: vec3f,
    /// NO_OBJECT where the ray meets nothing; then only this counts.
    object: u32,
    uv: vec2f,
}

@group(2) @binding(0) var<storage, read> probe_points: array<ProbePoint>;
@group(2) @binding(1) var<storage, read_write> probe_looks: array<ProbeLook>;

/// The material of an object at a point of it.
@compute @workgroup_size(64)
fn probeMaterials(@builtin(global_invocation_id) id: vec3u) {
    let count = arrayLength(&probe_points);
    if id.x >= count {
        return;
    }
    // Nothing, as everywhere; and no driver knows it.
    zero = count >> 31u;
    let asked = probe_points[id.x];
    var at = surface(asked.position, asked.normal, asked.uv);
    at.world = asked.world;
    at.footprint = asked.footprint;
    let material = materialAt(asked.object, at);
    probe_looks[id.x] = ProbeLook(material.color, material.emission);
}

@group(2) @binding(0) var<storage, read> probe_rays: array<Ray>;
@group(2) @binding(1) var<storage, read_write> probe_crossings: array<ProbeCrossing>;

/// Where a ray meets the scene, and the surface there, without its bumps.
@compute @workgroup_size(64)
fn probeRays(@builtin(global_invocation_id) id: vec3u) {
    let count = arrayLength(&probe_rays);
    if id.x >= count {
        return;
    }
    zero = count >> 31u;
    let ray = probe_rays[id.x];
    let hit = rayTraceScene(ray);
    let met = sampleFootprint(ray, hit, 0.0).met;
    probe_crossings[id.x] = ProbeCrossing(met.at.world, hit.t, met.normal, hit.object, met.at.uv);
}
