//! What a scene's test asks for: `NAME.test.ron` beside the scene, over `folder.test.ron` of its folders.
//!
//! In: the text of such a file. Out: [`Settings`], or its mistakes, reported as those of scenes.

use std::ops::Range;
use std::path::Path;

use crate::diagnostic::{Diagnostic, Place, Report};
use crate::judge::Limits;
use crate::scene::{self, Field, Kind, Value};
use crate::sources::{Answer, Sources};

/// How one scene is tested.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Pixels of the picture.
    pub size: [u32; 2],
    /// For each pixel.
    pub samples: u32,
    /// Seconds since the scene began.
    pub time: f32,
    /// Whether the generated text is compared.
    pub text: bool,
    /// Whether a picture is compared.
    pub picture: bool,
    /// Whether the scene is one with mistakes, whose report is compared instead.
    pub mistakes: bool,
    pub limits: Limits,
    /// Why it is not tested at all.
    pub skip: Option<String>,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            size: [160, 120],
            samples: 4,
            time: 0.0,
            text: true,
            picture: true,
            mistakes: false,
            limits: Limits::default(),
            skip: None,
        }
    }
}

/// The settings of a folder and of those below it.
pub const OF_FOLDER: &str = "folder.test.ron";

/// Whether `path` holds settings, and no scene.
pub fn is_settings(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name.to_string_lossy().ends_with(".test.ron"))
}

/// What holds for the file at `path`.
///
/// # Errors
/// What is wrong with the settings.
pub fn settings_for(sources: &Sources, path: &Path) -> Result<Settings, Report> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let reach = sources.reach(folder);
    let mut folders = reach.folders();
    folders.reverse();
    let of_folders = folders.into_iter().map(|folder| folder.join(OF_FOLDER));
    let files = of_folders.chain([path.with_extension("test.ron")]);
    let mut settings = Settings::default();
    for file in files {
        let name = sources.name(&file);
        let read = match reach.read(&file) {
            Answer::Missing => continue,
            _ => reach.text(&file).map_err(|problem| vec![problem]),
        };
        let read = read.and_then(|text| settings.clone().with(&name, &text));
        settings = read.map_err(|diagnostics| Report { diagnostics, texts: sources.texts() })?;
    }
    Ok(settings)
}

impl Settings {
    /// These, with what the settings file called `file` says.
    ///
    /// # Errors
    /// All that is wrong with it.
    pub fn with(mut self, file: &str, text: &str) -> Result<Self, Vec<Diagnostic>> {
        let root = scene::parse(file, text)?;
        let mut reader = Reader { file, problems: vec![], asked: vec![], fields: &[] };
        match &root.kind {
            Kind::Record(record) if record.name.is_none() && record.items.is_empty() => {
                reader.fields = &record.fields;
            }
            _ => {
                let found = format!("found {}; write `(samples: 1)`", root.describe());
                reader.error(&root.span, "write settings as fields in parentheses").help.push(found);
                return Err(reader.problems);
            }
        }
        reader.size(&mut self.size);
        reader.whole("samples", 1.0..=65536.0, &mut self.samples);
        reader.number("time", -1e6..=1e6, |x| self.time = x as f32);
        for (name, flag) in
            [("text", &mut self.text), ("picture", &mut self.picture), ("mistakes", &mut self.mistakes)]
        {
            reader.flag(name, flag);
        }
        let limits = &mut self.limits;
        let mut tolerance = u32::from(limits.tolerance);
        reader.whole("tolerance", 0.0..=255.0, &mut tolerance);
        limits.tolerance = tolerance as u8;
        reader.number("outliers", 0.0..=1.0, |x| limits.outliers = x);
        reader.number("structure", -1.0..=1.0, |x| limits.structure = x);
        reader.number("window", -1.0..=1.0, |x| limits.window = x);
        reader.number("flip", 0.0..=1.0, |x| limits.flip = x);
        if let Some(why) = reader.text("skip") {
            self.skip = Some(why);
        }
        let reason = reader.text("reason");
        if reason.is_none() {
            reader.refuse_loosened();
        }
        reader.finish();
        if reader.problems.is_empty() { Ok(self) } else { Err(reader.problems) }
    }
}

/// The fields of a settings file, each asked for once.
struct Reader<'a> {
    file: &'a str,
    fields: &'a [Field],
    asked: Vec<&'static str>,
    problems: Vec<Diagnostic>,
}

impl<'a> Reader<'a> {
    fn error(&mut self, span: &Range<usize>, message: impl Into<String>) -> &mut Diagnostic {
        let place = Place { file: self.file.into(), span: span.clone() };
        self.problems.push(Diagnostic::error(message).at(place, ""));
        self.problems.last_mut().expect("it was just pushed")
    }

    fn get(&mut self, name: &'static str) -> Option<&'a Value> {
        self.asked.push(name);
        self.fields.iter().find(|field| field.name.text == name).map(|field| &field.value)
    }

    fn mismatch(&mut self, name: &str, value: &Value, wanted: &str) {
        self.error(&value.span, format!("`{name}` takes {wanted}, found {}", value.describe()));
    }

    fn number(&mut self, name: &'static str, range: std::ops::RangeInclusive<f64>, mut set: impl FnMut(f64)) {
        let Some(value) = self.get(name) else { return };
        match value.kind {
            Kind::Number(x) if range.contains(&x) => set(x),
            _ => {
                let wanted = format!("a number from {} to {}", range.start(), range.end());
                self.mismatch(name, value, &wanted);
            }
        }
    }

    fn whole(&mut self, name: &'static str, range: std::ops::RangeInclusive<f64>, into: &mut u32) {
        let Some(value) = self.get(name) else { return };
        match value.kind {
            Kind::Number(x) if range.contains(&x) && x.fract() == 0.0 => *into = x as u32,
            _ => {
                let wanted = format!("a whole number from {} to {}", range.start(), range.end());
                self.mismatch(name, value, &wanted);
            }
        }
    }

    fn flag(&mut self, name: &'static str, into: &mut bool) {
        let Some(value) = self.get(name) else { return };
        match value.kind {
            Kind::Bool(flag) => *into = flag,
            _ => self.mismatch(name, value, "true or false"),
        }
    }

    fn text(&mut self, name: &'static str) -> Option<String> {
        let value = self.get(name)?;
        match &value.kind {
            Kind::Text(text) if !text.trim().is_empty() => return Some(text.clone()),
            _ => self.mismatch(name, value, "a reason in words"),
        }
        None
    }

    fn size(&mut self, into: &mut [u32; 2]) {
        let Some(value) = self.get("size") else { return };
        let side = |value: &Value| match value.kind {
            Kind::Number(x) if (8.0..=4096.0).contains(&x) && x.fract() == 0.0 => Some(x as u32),
            _ => None,
        };
        match &value.kind {
            Kind::Tuple(sides) if sides.len() == 2 && sides.iter().all(|s| side(s).is_some()) => {
                *into = [0, 1].map(|i| side(&sides[i]).unwrap_or_default());
            }
            _ => self.mismatch("size", value, "width and height from 8 to 4096, such as `(160, 120)`"),
        }
    }

    /// A limit that lets pass more than it does without being set needs a reason.
    fn refuse_loosened(&mut self) {
        let Limits { tolerance, outliers, structure, window, flip } = Limits::default();
        let limits = [
            ("tolerance", f64::from(tolerance), 1.0),
            ("outliers", outliers, 1.0),
            ("structure", structure, -1.0),
            ("window", window, -1.0),
            ("flip", flip, 1.0),
        ];
        for field in self.fields {
            let Kind::Number(x) = field.value.kind else { continue };
            let limit = limits.iter().find(|(name, ..)| *name == field.name.text);
            let Some((name, default, sign)) = limit else { continue };
            if (x - default) * sign > 0.0 {
                let message = format!("`{name}` is looser than {default} and needs a reason");
                let help = "add a reason: `reason: \"the shadow is noisy\"`";
                self.error(&field.value.span, message).help.push(help.into());
            }
        }
    }

    fn finish(&mut self) {
        for (i, Field { name, .. }) in self.fields.iter().enumerate() {
            if !self.asked.contains(&name.text.as_str()) {
                let known = self.asked.clone();
                let problem = self.error(&name.span, format!("a test has no setting `{}`", name.text));
                *problem = problem.clone().suggest(&name.text, known);
            } else if self.fields[..i].iter().any(|field| field.name.text == name.text) {
                self.error(&name.span, format!("`{}` is given twice", name.text));
            }
        }
    }
}
