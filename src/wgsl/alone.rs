//! A scene that is to be drawn without raytoy: its text brings along what raytoy adds to other scenes.
//!
//! In: the scene's picture settings, and a [`Host`]. Out: functions of the scene's own section.

use super::code::{Code, CodeLines};
use super::numbers::Numbers;
use super::{Host, Writer};
use crate::ir::{Render, ToneMap, Transfer};
use crate::library::Const;

impl Writer<'_> {
    /// What raytoy itself does in its display pass and its uniforms; nothing for raytoy.
    pub fn without_raytoy(&mut self, host: &Host) -> CodeLines {
        let mut lines = CodeLines::default();
        match host {
            Host::Raytoy => {}
            Host::Any => lines.extend(display(&self.scene.render, &mut self.numbers)),
            Host::Shadertoy { settings } => {
                lines.extend(display(&self.scene.render, &mut self.numbers));
                lines.extend(preset(settings, &mut self.numbers));
            }
        }
        lines
    }
}

/// The function `shown`: what shaders/display.wgsl does in raytoy, with nothing left to choose.
fn display(render: &Render, numbers: &mut Numbers) -> CodeLines {
    let mut number = |x: f32| numbers.constant(Const::F32(x));
    let exposed = || [Code::atom("exposed")];
    let gain = number(render.gain);
    let toned = match render.tone_map {
        ToneMap::Clamp => Code::call("min", [Code::atom("exposed"), Code::call("vec3f", [number(1.0)])]),
        ToneMap::Reinhard => Code::call("tonedReinhard", exposed()),
        ToneMap::Aces => Code::call("tonedAces", exposed()),
        ToneMap::Agx => Code::call("tonedAgx", exposed()),
    };
    let encoded = match render.transfer {
        Transfer::Linear => toned,
        Transfer::Srgb => Code::call("encodedSrgb", [toned]),
        Transfer::Gamma(gamma) => Code::call("pow", [toned, Code::call("vec3f", [number(1.0 / gamma)])]),
    };
    let mut lines = CodeLines::default();
    lines.push("");
    lines.push("/// Light as a screen shows it, by the scene's exposure, tone map and transfer curve.");
    lines.push("fn shown(light: vec3f) -> vec3f {");
    lines.statement(4, "let exposed = max(", &gain, " * light, vec3f(0.0));");
    lines.statement(4, "return ", &encoded, ";");
    lines.push("}");
    lines
}

/// The function `setScene`, which fills the fields of `frame` that stay as they are.
fn preset(settings: &[(&str, Const)], numbers: &mut Numbers) -> CodeLines {
    let mut lines = CodeLines::default();
    lines.push("");
    lines.push("/// The scene's camera and settings.");
    lines.push("fn setScene() {");
    for (field, value) in settings {
        let after = if *field == "pixel_spread" { " / frame.resolution.y;" } else { ";" };
        lines.statement(4, &format!("frame.{field} = "), &numbers.constant(*value), after);
    }
    lines.push("}");
    lines
}
