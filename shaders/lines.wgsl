// Lines of the world over a finished picture, faint where the picture shows something nearer.

struct Over {
    /// Top left corner of the picture on the target, pixels.
    corner: vec2f,
    /// Target pixels to a pixel of the picture.
    zoom: f32,
    /// The tangent of half the vertical angle of view.
    half_view: f32,
    /// Width and height of the target, pixels.
    target_size: vec2f,
}

/// A line as the camera sees it: pixels of the target, and how far along the view.
struct Line {
    @location(0) start: vec3f,
    @location(1) end: vec3f,
    @location(2) color: vec3f,
    /// Pixels of the target.
    @location(3) width: f32,
}

struct Drawn {
    @builtin(position) pixel: vec4f,
    /// Pixels from the middle of the line.
    @location(0) side: f32,
    /// One over the way along the view, since that is what goes straight over a screen.
    @location(1) nearness: f32,
    /// To the right of the line, length 1.
    @location(2) @interpolate(flat) across: vec2f,
    @location(3) @interpolate(flat) color: vec3f,
    @location(4) @interpolate(flat) width: f32,
}

/// Opacity of what lies behind something.
const HIDDEN: f32 = 0.2;

/// A line this share behind a surface counts as on it.
const ON_SURFACE: f32 = 5e-4;

@group(0) @binding(0) var<uniform> over: Over;
/// Its w is the distance along each pixel's ray, negative where that meets nothing.
@group(0) @binding(1) var picture: texture_2d<f32>;

/// A strip of two triangles around the line, half a pixel wider on each side than it.
@vertex
fn coverLine(@builtin(vertex_index) corner: u32, line: Line) -> Drawn {
    let along = line.end.xy - line.start.xy;
    let across = vec2f(-along.y, along.x) / max(length(along), 1e-6);
    let side = select(-0.5, 0.5, (corner & 1u) == 1u) * (line.width + 1.0);
    let on_line = select(line.start, line.end, corner >= 2u);
    let place = 2.0 * (on_line.xy + side * across) / over.target_size - 1.0;
    let at = vec4f(place.x, -place.y, 0.0, 1.0);
    return Drawn(at, side, 1.0 / on_line.z, across, line.color, line.width);
}

@fragment
fn paintLine(drawn: Drawn) -> @location(0) vec4f {
    let covered = clamp(0.5 * drawn.width + 0.5 - abs(drawn.side), 0.0, 1.0);
    // Asked in the middle of the line: else one half of a line on a floor would lie under it.
    let middle = (drawn.pixel.xy - drawn.side * drawn.across - over.corner) / over.zoom;
    let is_hidden = 1.0 > pictureDepth(middle) * drawn.nearness * (1.0 + ON_SURFACE);
    let opacity = covered * select(1.0, HIDDEN, is_hidden);
    return vec4f(drawn.color * opacity, opacity);
}

/// How far along the view the picture goes at `place`: the farthest of the four pixels around it, so that a
/// slanted surface does not hide a line that lies on it.
fn pictureDepth(place: vec2f) -> f32 {
    let size = vec2i(textureDimensions(picture));
    let first = vec2i(floor(place - 0.5));
    var farthest = 0.0;
    for (var i = 0; i < 4; i++) {
        let at = clamp(first + vec2i(i & 1, i >> 1u), vec2i(0), size - 1);
        let distance = textureLoad(picture, at, 0).w;
        // The ray of shaders/main.wgsl, where the view has length 1.
        let ray = over.half_view * (2.0 * (vec2f(at) + 0.5) - vec2f(size)) / f32(size.y);
        let depth = distance / length(vec3f(ray, 1.0));
        farthest = max(farthest, select(1e30, depth, distance >= 0.0));
    }
    return farthest;
}
