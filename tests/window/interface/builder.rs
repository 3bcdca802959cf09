//! What stands behind the panel in place of the window's threads: it compiles, and draws nothing.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use raytoy::diagnostic::Report;
use raytoy::engine::{BuilderCommand, Change, Focus, Picture, Texels};
use raytoy::ir::Measure;
use raytoy::library::Library;
use raytoy::outline::outline;
use raytoy::panel::Panel;
use raytoy::scene::parse;
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use raytoy::{Compiled, compile, on_deep_stack};

/// Obeys the panel's orders, and remembers what they were.
#[derive(Default)]
pub struct Builder {
    scene: PathBuf,
    /// What stands for the text of the scene's file.
    edited: Option<Arc<str>>,
    file: Option<String>,
    pub focus: Focus,
    pub measure: Option<String>,
    /// The last version that could be drawn.
    before: Option<Arc<Compiled>>,
    /// What each version has changed.
    pub changes: Vec<Change>,
}

impl Builder {
    pub fn obey(&mut self, order: BuilderCommand, panel: &mut Panel) {
        match order {
            BuilderCommand::Open(scene) => *self = Self { scene, ..Self::default() },
            BuilderCommand::Edited(text) => self.edited = text,
            BuilderCommand::Focus(focus) => self.focus = focus,
            BuilderCommand::Measure(name) => self.measure = name,
            BuilderCommand::Changed
            | BuilderCommand::Shown(_)
            | BuilderCommand::Views(_)
            | BuilderCommand::End => {}
        }
        self.build(panel);
    }

    fn build(&mut self, panel: &mut Panel) {
        let file = fs::read_to_string(&self.scene).expect("the scene has a file");
        if self.file.as_ref() != Some(&file) {
            if let BuilderCommand::Edited(text) = panel.file_says(&file) {
                self.edited = text;
            }
            self.file = Some(file.clone());
        }
        let text = self.edited.clone().unwrap_or_else(|| file.into());
        let here = std::env::current_dir().expect("tests run in a folder");
        let sources = Sources::on_disk(&here).with(&self.scene, &text);
        let outcome = compile(&sources, &self.scene, Mode::Live, self.before.as_deref());
        match outcome.compiled {
            Some(compiled) => self.show(compiled, outcome.report, panel),
            None => panel.break_with(outcome.report),
        }
        let sources = Sources::on_disk(&here);
        let library = Library::new(&sources, self.scene.parent().unwrap_or(Path::new("")));
        let root = on_deep_stack(|| parse(&sources.name(&self.scene), &text).ok());
        if let Some(root) = root {
            panel.offer(Box::new(outline(&root, &text, &library)), text);
        }
    }

    fn show(&mut self, compiled: Compiled, warnings: Report, panel: &mut Panel) {
        let part = self.focus.of(compiled).expect("naga has taken the whole");
        let measured = match &self.measure {
            None => part,
            Some(name) => {
                let measure = Measure::named(&part.scene, name).unwrap_or(Measure::Pattern);
                part.measuring(measure).expect("naga has taken the rest")
            }
        };
        let compiled = Arc::new(measured);
        let change = match &self.before {
            Some(before) if before.has_structure_of(&compiled) => {
                let is_same = before.source.numbers == compiled.source.numbers;
                if is_same { Change::Cosmetic } else { Change::Numbers }
            }
            _ => Change::Structure,
        };
        self.changes.push(change);
        self.before = Some(compiled.clone());
        let snippets = compiled.source.sections.iter().filter(|s| !s.name.starts_with("shaders/"));
        let moves = snippets.into_iter().any(|section| section.text.contains("frame.time"));
        let time = Duration::from_millis(20);
        let picture = Picture {
            is_sketch: false,
            texels: Texels::Bytes { size: [1, 1], rgba: vec![0; 4] },
            edit: self.changes.len() as u64,
            change,
            samples: 64,
            resolution: 1.0,
            pipelines: 1,
            noticed: Instant::now(),
            pipeline_time: time,
            frame_time: time,
            moves,
            compiled,
            warnings,
        };
        panel.take(&picture, true);
    }
}
