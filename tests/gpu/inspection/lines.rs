//! Lines over a picture: where they lie, and what hides them.

use glam::{Vec2, Vec3, vec2};
use raytoy::Compiled;
use raytoy::frame::{Lens, Moment};
use raytoy::gpu::{Display, Gpu, Line, Lines, Pipeline, Region, Target, Tracer};

use crate::device;

const SIZE: [u32; 2] = [240, 160];
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
const WHOLE: Target = Target { corner: [0.0; 2], zoom: 1.0 };

/// White, three pixels wide.
fn line(from: Vec3, to: Vec3) -> Line {
    Line { from, to, color: Vec3::ONE, width: 3.0 }
}

/// The opacity of each pixel of a target of `size`, 0 to 1, when `lines` are drawn over the scene at `place`.
fn drawn(gpu: &Gpu, compiled: &Compiled, size: [u32; 2], place: Target, lines: &[Line]) -> Vec<f32> {
    let pipeline = Pipeline::build(gpu, compiled).unwrap_or_else(|e| panic!("{e}"));
    let mut tracer = Tracer::new(gpu, SIZE).unwrap_or_else(|e| panic!("{e}"));
    let scene = &compiled.scene;
    let all = Region::after(0, SIZE[0] * SIZE[1], SIZE);
    tracer.draw(&pipeline, &Moment::of(scene), &scene.render, [0.0; 2], &all);
    tracer.next();
    let display = Display::new(gpu, FORMAT);
    let target = Tracer::new(gpu, size).unwrap_or_else(|e| panic!("{e}"));
    // New textures are transparent.
    let canvas = display.canvas(target.picture(), FORMAT);
    let onto = canvas.create_view(&Default::default());
    Lines::new(gpu, FORMAT).draw(tracer.picture(), &scene.camera, &onto, place, lines);
    let texels = display.read(&canvas).unwrap_or_else(|e| panic!("{e}"));
    let opacity = |texel: &[u8]| {
        assert!(texel[..3].iter().all(|channel| *channel == texel[3]), "white is premultiplied: {texel:?}");
        f32::from(texel[3]) / 255.0
    };
    texels.chunks_exact(4).map(opacity).collect()
}

fn at(opacities: &[f32], size: [u32; 2], pixel: Vec2) -> f32 {
    let pixel = pixel.as_uvec2();
    assert!(pixel.x < size[0] && pixel.y < size[1], "{pixel} is beside the picture");
    opacities[(pixel.y * size[0] + pixel.x) as usize]
}

/// Points of a line, but for those less than two pixels from its ends.
fn points<'a>(line: &Line, lens: &'a Lens) -> impl Iterator<Item = Vec3> + 'a {
    let Line { from, to, .. } = *line;
    let points = (1..400).map(move |i| from.lerp(to, i as f32 / 400.0));
    points.filter(move |p| [from, to].iter().all(|end| lens.pixel(*end).distance(lens.pixel(*p)) > 2.0))
}

#[test]
fn a_line_is_faint_exactly_where_a_ball_is_nearer() {
    let Some(gpu) = device::gpu() else { return };
    let text = "(camera: (eye: (1, 2, 6), target: (0, 0, 0), fov_deg: 50), objects: [Sphere()])";
    let compiled = super::scene(text);
    let lens = Lens::new(&compiled.scene.camera, SIZE);
    let is_hidden = |point: Vec3| {
        let d = (point - lens.eye).as_dvec3();
        let (o, length) = (lens.eye.as_dvec3(), d.length());
        let middle = -o.dot(d) / length;
        let inside = 1.0 - (o + middle * d / length).length_squared();
        inside > 0.0 && middle - inside.sqrt() < length
    };
    let lines = [
        // Through the ball, from before it to behind it; behind it; before it.
        line(Vec3::new(-2.0, 0.4, 1.8), Vec3::new(2.2, -0.5, -2.0)),
        line(Vec3::new(-2.5, -1.0, -1.5), Vec3::new(2.0, 0.6, -1.5)),
        line(Vec3::new(-1.5, 0.9, 2.0), Vec3::new(1.5, 1.0, 2.0)),
    ];
    for (number, line) in lines.iter().enumerate() {
        let opacities = drawn(gpu, &compiled, SIZE, WHOLE, &[*line]);
        let mut counts = [0; 2];
        for point in points(line, &lens) {
            let pixel = lens.pixel(point);
            let hidden = is_hidden(point);
            // Not within two pixels of a change.
            let step = (line.to - line.from) * 2.0 / lens.pixel(line.from).distance(lens.pixel(line.to));
            if is_hidden(point + step) != hidden || is_hidden(point - step) != hidden {
                continue;
            }
            counts[usize::from(hidden)] += 1;
            let expected = if hidden { 0.2 } else { 1.0 };
            let actual = at(&opacities, SIZE, pixel);
            assert!((actual - expected).abs() < 0.01, "line {number}, {point}, {pixel}: {actual}");
        }
        let [seen, hidden] = counts;
        assert!(seen > 100 && (hidden > 60) == (number < 2), "line {number}: {seen} seen, {hidden} hidden");
    }
}

#[test]
fn a_line_lies_where_its_points_are_seen() {
    let Some(gpu) = device::gpu() else { return };
    let compiled = super::scene(
        "(camera: (eye: (0, 1, 6), target: (0.3, 0, 0)), objects: [Sphere(center: (0, 99, 0))])",
    );
    let lens = Lens::new(&compiled.scene.camera, SIZE);
    let slanted = line(Vec3::new(-1.7, -0.9, 0.5), Vec3::new(2.0, 1.1, -3.0));
    let (start, end) = (lens.pixel(slanted.from), lens.pixel(slanted.to));
    let along = (end - start).normalize();
    let opacities = drawn(gpu, &compiled, SIZE, WHOLE, &[slanted]);
    for (x, y, pixel) in super::middles(SIZE) {
        let q = pixel - start;
        let (forth, side) = (q.dot(along), q.dot(along.perp()).abs());
        let length = start.distance(end);
        if forth.abs() < 0.6 || (forth - length).abs() < 0.6 {
            continue;
        }
        let covered = if forth > 0.0 && forth < length { (2.0 - side).clamp(0.0, 1.0) } else { 0.0 };
        let actual = at(&opacities, SIZE, pixel);
        assert!((actual - covered).abs() < 0.02, "{x}, {y}: {actual}, not {covered}");
    }
}

#[test]
fn a_picture_may_lie_anywhere_on_the_target() {
    let Some(gpu) = device::gpu() else { return };
    let compiled = super::scene("(camera: (eye: (0, 0, 6), target: (0, 0, 0)), objects: [Sphere()])");
    let size = [600, 400];
    let place = Target { corner: [37.0, 21.0], zoom: 2.0 };
    let lens = Lens::new(&compiled.scene.camera, SIZE);
    let behind = line(Vec3::new(-3.0, 0.1, -2.0), Vec3::new(3.0, 0.1, -2.0));
    let opacities = drawn(gpu, &compiled, size, place, &[behind]);
    for (x, expected) in [(-2.5, 1.0), (0.0, 0.2), (0.5, 0.2), (2.5, 1.0)] {
        let pixel = vec2(37.0, 21.0) + 2.0 * lens.pixel(Vec3::new(x, 0.1, -2.0));
        let actual = at(&opacities, size, pixel);
        assert!((actual - expected).abs() < 0.01, "{x}: {actual}");
    }
}

#[test]
fn a_line_on_a_surface_is_not_hidden_by_it() {
    let Some(gpu) = device::gpu() else { return };
    let text = "(camera: (eye: (0, 1, 6), target: (0, 0, 0)), objects: [Plane(), Sphere(center: (2, 0, -9), radius: 3)])";
    let compiled = super::scene(text);
    let lens = Lens::new(&compiled.scene.camera, SIZE);
    let lines = [
        line(Vec3::new(-2.0, 0.0, 3.0), Vec3::new(2.0, 0.0, 3.0)),
        line(Vec3::new(-2.0, 0.0, 2.0), Vec3::new(-9.0, 0.0, -20.0)),
        line(Vec3::new(-9.0, 0.0, -30.0), Vec3::new(-2.0, 0.0, -30.0)),
    ];
    let opacities = drawn(gpu, &compiled, SIZE, WHOLE, &lines);
    for point in lines.iter().flat_map(|line| points(line, &lens)) {
        let pixel = lens.pixel(point);
        if pixel.cmpge(vec2(1.0, 1.0)).all() && pixel.x < SIZE[0] as f32 - 1.0 {
            let actual = at(&opacities, SIZE, pixel);
            assert!(actual > 0.7, "{point}, {pixel}: {actual}");
        }
    }
    // Under it, they are.
    let under = line(Vec3::new(-2.0, -0.1, 3.0), Vec3::new(2.0, -0.1, 3.0));
    let opacities = drawn(gpu, &compiled, SIZE, WHOLE, &[under]);
    assert!((at(&opacities, SIZE, lens.pixel(Vec3::new(0.0, -0.1, 3.0))) - 0.2).abs() < 0.01);
}

#[test]
fn what_lies_behind_the_eye_is_cut_off() {
    let Some(gpu) = device::gpu() else { return };
    let compiled =
        super::scene("(camera: (eye: (0, 0, 6), target: (0, 0, 0)), objects: [Sphere(center: (0, 99, 0))])");
    let lens = Lens::new(&compiled.scene.camera, SIZE);
    let behind = line(Vec3::new(-1.0, 0.0, 7.0), Vec3::new(3.0, 0.0, 20.0));
    assert!(drawn(gpu, &compiled, SIZE, WHOLE, &[behind]).iter().all(|opacity| *opacity == 0.0));
    let ends = [Vec3::new(1.0, 0.5, 20.0), Vec3::new(0.5, 0.2, -8.0)];
    for (from, to) in [(ends[0], ends[1]), (ends[1], ends[0])] {
        let through = line(from, to);
        let opacities = drawn(gpu, &compiled, SIZE, WHOLE, &[through]);
        let is_inside = |p: Vec2| p.cmpgt(Vec2::ZERO).all() && p.x < SIZE[0] as f32 && p.y < SIZE[1] as f32;
        let seen: Vec<Vec2> = points(&through, &lens)
            .filter(|p| p.z < 5.9)
            .map(|p| lens.pixel(p))
            .filter(|p| is_inside(*p))
            .collect();
        assert!(seen.len() > 100);
        for pixel in &seen {
            assert!(at(&opacities, SIZE, *pixel) > 0.7, "{pixel}: {}", at(&opacities, SIZE, *pixel));
        }
        let count = opacities.iter().filter(|opacity| **opacity > 0.5).count();
        let length = seen.iter().map(|p| p.distance(seen[0])).fold(0.0, f32::max);
        assert!((count as f32) < 5.0 * length + 20.0, "{count} pixels, {length} long");
    }
}
