// Generated from tests/cases/names/long_names_break_lines.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   a box with a name that is longer than a line of the shader, so that it has to be cut…
//   shapes    RoundedBox
//   textures  Checker, Brick, Noise, Fbm, Stripes, Marble, Wood

const OBJECT_A_BOX_WITH_A_NAME_THAT_I: u32 = 0u;
const LIGHTS: u32 = 0u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(
        hit,
        aBoxWithANameThatIsLongeCrossing(rayInto(aBoxWithANameThatIsLongeSpace(), ray)),
        OBJECT_A_BOX_WITH_A_NAME_THAT_I,
    );
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if aBoxWithANameThatIsLongeCrossing(
        rayInto(aBoxWithANameThatIsLongeSpace(), ray),
    ) < NO_HIT { return true; }
    return false;
}

/// objects[0] "a box with a name that is longer than a line of the shader, so that it has to be cu…
fn aBoxWithANameThatIsLongeCrossing(ray: Ray) -> f32 {
    return roundedBox(
        ray,
        vec3f(-1.2345679, -2.3456788, -3.456789),
        vec3f(1.2345679, 2.3456788, 3.456789),
        0.12345679,
    );
}

fn aBoxWithANameThatIsLongeSurfaceAt(p: vec3f) -> Surface {
    return roundedBoxSurface(
        p,
        vec3f(-1.2345679, -2.3456788, -3.456789),
        vec3f(1.2345679, 2.3456788, 3.456789),
        0.12345679,
    );
}

fn aBoxWithANameThatIsLongeSpace() -> Space {
    return Space(
        vec4f(0.6798643, 0.46844482, -0.35825148, -0.5419995),
        vec4f(-0.21788062, 0.38371566, 0.08826303, -0.8143398),
        vec4f(0.13245411, 0.013369759, 0.26884416, -0.96572614),
    );
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_A_BOX_WITH_A_NAME_THAT_I: {
            return placedFrom(
                aBoxWithANameThatIsLongeSpace(),
                aBoxWithANameThatIsLongeSurfaceAt(pointInto(aBoxWithANameThatIsLongeSpace(), p)),
                p,
            );
        }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_A_BOX_WITH_A_NAME_THAT_I: { return aMaterialWithANameThatNoMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "a material with a name that nobody would ever want to type, but that somebody will ty…
fn aMaterialWithANameThatNoMaterial(at: Surface) -> Material {
    return matte(thePatternOfTheTilesOnThTexture(at));
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    return true;
}

/// The world normal of `object` at `met`.
fn normalAt(object: u32, met: Placed) -> vec3f {
    return met.normal;
}

/// What a ray sees that leaves the scene in `direction`.
fn background(direction: vec3f) -> vec3f {
    return vec3f(0.0);
}

fn ambientLight() -> vec3f {
    return vec3f(0.1);
}

/// texture "the pattern of the tiles on the terrace behind the summer house of my grandmother's si…
fn thePatternOfTheTilesOnThTexture(at: Surface) -> vec3f {
    return checker(
        at,
        1.0,
        brick(
            at,
            noise(at, fbm(at, noise(at, 12.345678), 5u, 2.0, 0.5)),
            3.0,
            0u,
            0.1,
            0.15,
            stripes(
                at,
                1.0,
                marble(
                    at,
                    1.5,
                    6u,
                    2.0,
                    5.0,
                    vec3f(0.8879231, 0.8631572, 0.8148466),
                    vec3f(0.0703601, 0.08021983, 0.097587354),
                ),
                wood(
                    at,
                    5.0,
                    vec3f(1.0, 0.12, 0.06),
                    0.5,
                    0.4,
                    vec3f(0.57112485, 0.32314324, 0.12477182),
                    vec3f(0.20507874, 0.068478175, 0.017641956),
                ),
            ),
            vec3f(noise(at, 1.5)),
        ),
        checker(
            at,
            1.0,
            checker(at, 1.0, checker(at, 1.0, vec3f(0.1), vec3f(0.2)), vec3f(0.3)),
            vec3f(0.4),
        ),
    );
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
