//! The only place that prints a number: as a literal, or as a slot of the scene's data.

use super::Mode;
use super::code::{Code, CodeLines};
use crate::bindings::NUMBERS;
use crate::library::{Const, Type};

/// The numbers of one scene, in the order in which they are written.
pub struct Numbers {
    mode: Mode,
    data: Vec<f32>,
}

impl Numbers {
    pub fn new(mode: Mode) -> Self {
        Self { mode, data: vec![] }
    }

    pub fn constant(&mut self, value: Const) -> Code {
        match self.mode {
            Mode::Baked => literal(value),
            Mode::Live => self.slot(value),
        }
    }

    /// What the slots hold, filled up to whole `vec4f`s; never empty in live mode.
    pub fn into_data(mut self) -> Vec<f32> {
        if self.mode == Mode::Live {
            self.data.resize(self.data.len().next_multiple_of(4).max(4), 0.0);
        }
        self.data
    }

    /// The only reader of the slots; nothing when baked.
    pub fn accessor(&self) -> CodeLines {
        let mut lines = CodeLines::default();
        if self.mode == Mode::Live {
            let fours = self.data.len().div_ceil(4).max(1);
            lines.push("");
            let (attributes, name) = (NUMBERS.attributes(), NUMBERS.name);
            lines.push(format!("{attributes} var<uniform> {name}: array<vec4f, {fours}>;"));
            lines.push("");
            lines.push("fn live(i: u32) -> vec4f {");
            lines.push(format!("    return {name}[i] + f32(zero);"));
            lines.push("}");
        }
        lines
    }

    fn slot(&mut self, value: Const) -> Code {
        let size = value.ty().size();
        // A value lies inside one four.
        if self.data.len() % 4 + size > 4 {
            self.data.resize(self.data.len().next_multiple_of(4), 0.0);
        }
        let (four, first) = (self.data.len() / 4, self.data.len() % 4);
        self.data.extend(value.numbers());
        let read = match &"xyzw"[first..first + size] {
            "xyzw" => format!("live({four})"),
            part => format!("live({four}).{part}"),
        };
        Code::atom(match value.ty() {
            Type::I32 => format!("i32({read})"),
            Type::U32 => format!("u32({read})"),
            Type::Bool => format!("({read} != 0.0)"),
            _ => read,
        })
    }
}

fn literal(value: Const) -> Code {
    let vector = |name: &str| {
        let mut numbers = value.numbers();
        if numbers.iter().all(|x| *x == numbers[0]) {
            numbers.truncate(1);
        }
        Code::call(name, numbers.into_iter().map(|x| Code::atom(float(x))))
    };
    match value {
        Const::F32(x) => Code::atom(float(x)),
        Const::I32(i) => Code::atom(format!("{i}i")),
        Const::U32(u) => Code::atom(format!("{u}u")),
        Const::Bool(b) => Code::atom(b.to_string()),
        Const::Vec2(_) => vector("vec2f"),
        Const::Vec3(_) => vector("vec3f"),
        Const::Vec4(_) => vector("vec4f"),
    }
}

/// The shortest text that reads back as `x`, with a point or an exponent; zero has no sign.
fn float(x: f32) -> String {
    if x == 0.0 { "0.0".into() } else { format!("{x:?}") }
}
