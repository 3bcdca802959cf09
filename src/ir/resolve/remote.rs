//! Objects so far from the origin that numbers of 32 bits have too few digits for what the camera sees there.

use std::ops::Range;

use glam::{DAffine3, DVec3};

use super::Resolver;
use crate::assets::Model;
use crate::diagnostic::Diagnostic;
use crate::ir::{Camera, Value};
use crate::library::{Const, Function, Parameter};

/// An object may lie so many times as far from the origin as it is large, or as half of what the camera sees
/// there. Then 97 of 100 pixels are right; what is lost is the edge of shadows. At ten times as much they are
/// gone (tests/gpu/remote.rs).
const MAX_REMOTE: f64 = 1e4;

/// Where an object stands in the world.
pub struct Stand {
    shape: String,
    /// Where it was written.
    span: Range<usize>,
    /// None for what goes on without end.
    middle: Option<DVec3>,
    size: f64,
}

impl Stand {
    /// That of a shape with `arguments` and a map into the world, as far as its parameters say it.
    pub fn of(
        shape: &Function,
        arguments: &[Value],
        models: &[Model],
        to_world: Option<DAffine3>,
        span: &Range<usize>,
    ) -> Self {
        let (mut points, mut size) = (vec![], 0.0_f64);
        for (parameter, argument) in shape.parameters.iter().zip(arguments) {
            match argument {
                Value::Const(Const::Vec3(point)) if parameter.is_point => points.push(point.as_dvec3()),
                Value::Const(constant) => size = size.max(length(parameter, *constant)),
                Value::Model(index) => {
                    let root = models[*index].nodes.first();
                    points.extend(root.iter().flat_map(|node| [node.low.as_dvec3(), node.high.as_dvec3()]));
                }
                _ => {}
            }
        }
        let middle = points.iter().sum::<DVec3>() / points.len().max(1) as f64;
        size = points.iter().map(|point| 2.0 * point.distance(middle)).fold(size, f64::max);
        let to_world = to_world.unwrap_or(DAffine3::IDENTITY);
        let m = to_world.matrix3;
        let scale = m.x_axis.length().max(m.y_axis.length()).max(m.z_axis.length());
        let is_endless = shape.traits.is_endless;
        Self {
            shape: shape.name.clone(),
            span: span.clone(),
            middle: (!is_endless).then(|| to_world.transform_point3(middle)),
            size: if is_endless { 0.0 } else { scale * size },
        }
    }
}

/// What a number or vector adds to a shape's size; directions and counts add nothing.
fn length(parameter: &Parameter, value: Const) -> f64 {
    match value {
        Const::F32(x) => f64::from(x),
        Const::Vec3(v) if !parameter.nonzero && !parameter.is_color => v.as_dvec3().length(),
        _ => 0.0,
    }
}

impl Resolver<'_> {
    /// Warns of the first object that is too far from the origin for its size, and counts the others.
    pub fn check_remote(&mut self, camera: &Camera) {
        let (eye, target) = (camera.eye.as_dvec3(), camera.target.as_dvec3());
        // Of such a camera there is an error.
        if eye == target {
            return;
        }
        let half_view = (0.5 * f64::from(camera.fov)).tan();
        let stands = std::mem::take(&mut self.stands);
        let far = |stand: &Stand| {
            let middle = stand.middle.unwrap_or(target);
            let away = middle.abs().max_element();
            // From farther off a pixel is wider than what is lost.
            let seen = half_view * middle.distance(eye);
            (away > MAX_REMOTE * stand.size.max(seen)).then_some(away)
        };
        let remote: Vec<(&Stand, f64)> =
            stands.iter().filter_map(|stand| Some((stand, far(stand)?))).collect();
        let Some((first, away)) = remote.first() else { return };
        let others = match remote.len() - 1 {
            0 => String::new(),
            1 => ", as is one other object".into(),
            n => format!(", as are {n} other objects"),
        };
        let message = format!("`{}` is too far from the origin for precise numbers{others}", first.shape);
        let step = f64::from(f32::EPSILON) * away.log2().floor().exp2();
        let digits = (-step.log10().floor()).max(0.0) as usize;
        let help = format!(
            "move the scene, its camera and its lights to the origin: {away:.0} units away, numbers are \
             {step:.digits$} apart, so shadows and then surfaces go wrong"
        );
        let place = self.place(&first.span);
        self.push(Diagnostic::warning(message).at(place, "").help(help));
    }
}
