/// A model from a file of triangles.
///
/// file: a Wavefront OBJ or glTF file, beside the scene
/// smooth = true: light sees the curved surface that the triangles stand for
fn mesh(ray: Ray, file: Model, smooth_: bool) -> f32 {
    return modelCrossing(ray, file);
}

fn meshSurface(p: vec3f, file: Model, smooth_: bool) -> Surface {
    var at = modelSurface(p, file);
    at.normal = select(at.geometric_normal, at.normal, smooth_);
    at.whole = select(vec4f(0.0), vec4f(0.0, 0.0, 1.0, 1.0), file.has_uv);
    at.rise = select(0.0, at.rise, smooth_);
    return at;
}
