/// A texture that gives what no scene can use.
fn returnType(at: Surface) -> vec4f {
    return vec4f(at.uv, 0.0, 1.0);
}
