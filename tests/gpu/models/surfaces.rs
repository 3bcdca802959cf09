//! Where light falls on a smooth surface that triangles stand for.

use raytoy::frame::View;
use raytoy::gpu::Picture;
use raytoy::wgsl::Mode;

use super::shapes;
use crate::common::expect_compiled;
use crate::device::gpu;
use crate::draw::picture;

/// Things in light, without any other.
const LIT: &str = "(
    camera: (eye: (0, 0, 5), target: (0, 0, 0), fov_deg: 30), background: \"#000000\", ambient: 0.0,
    lights: [LIGHT],
    objects: [OBJECTS],
)";

fn lit_by(light: &str, objects: &str) -> Option<Picture> {
    let sources = raytoy::sources::Sources::in_memory()
        .with("a.ron", &LIT.replace("LIGHT", light).replace("OBJECTS", objects))
        .with("ball.obj", &shapes::ball(8));
    let outcome = raytoy::compile(&sources, "a.ron".as_ref(), Mode::Baked, None);
    Some(picture(gpu()?, &expect_compiled(outcome), [128, 128], View::Color))
}

#[test]
fn light_falls_off_evenly_where_a_smooth_ball_turns_from_it() {
    let lit = |object| lit_by("Directional(direction: (-1, -0.3, -0.2))", object);
    let (Some(coarse), Some(round)) = (lit("Mesh(file: \"ball.obj\")"), lit("Sphere()")) else { return };
    // Well inside the silhouette the ball of triangles is lit as the round one is, but for its own coarseness.
    let mut most = 0.0_f32;
    for (y, x) in (0..128_usize).flat_map(|y| (0..128).map(move |x| (y, x))) {
        let from_middle = ((x as f32 - 63.5).powi(2) + (y as f32 - 63.5).powi(2)).sqrt();
        // The ball is 48 pixels around its middle.
        if from_middle < 40.0 {
            let [a, b] = [&coarse, &round].map(|picture| picture.radiance[128 * y + x][0]);
            most = most.max((a - b).abs());
        }
    }
    assert!(most < 0.12, "a pixel is off by {most}");
}

#[test]
fn no_light_leaks_under_a_ball_that_lies_on_a_thin_floor() {
    let slab = "Box(min: (-9, -1.02, -9), max: (9, -1, 9)), Mesh(file: \"ball.obj\")";
    let Some(picture) = lit_by("Directional(direction: (0.2, 1, -0.3))", slab) else { return };
    let lit = picture.radiance.iter().filter(|light| light[0] > 0.0).count();
    assert_eq!(lit, 0, "pixels that light from below reaches");
}
