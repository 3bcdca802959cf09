//! What exists while the window does, and a frame of it.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use winit::window::Window;

use super::backend::Backend;
use super::screen::Presented;
use crate::compile::Compiled;
use crate::engine::builder_messages::BuilderCommand;
use crate::engine::crash_guard::CrashGuard;
use crate::engine::events::Event;
use crate::engine::messages::{PainterCommand, Picture, ViewRequest};
use crate::panel::{CaptureAction, Leaving, Memory, Panel};

/// What exists while the window does.
pub struct Open {
    pub window: Arc<Window>,
    pub backend: Backend,
    /// How many devices were lost before this one.
    pub restarts: u32,
    /// How many since a picture was there.
    pub failed_restarts: u32,
    pub crash_guard: CrashGuard,
    pub panel: Panel,
    pub memory: Memory,
    pub quits: bool,
    pub look: Option<ViewRequest>,
    /// A picture that was set and not presented yet.
    pub fresh: Option<Fresh>,
    /// The one of the frame that is on its way.
    pub sent: Option<Fresh>,
    /// Whether something has changed since that was drawn.
    pub is_outdated: bool,
    pub last_edit: Option<u64>,
    pub wake: Option<Instant>,
}

/// The report of a picture once it is on the screen.
pub struct Fresh {
    pub event: Event,
    /// When the change was noticed that it shows.
    pub noticed: Instant,
    pub compiled: Arc<Compiled>,
}

impl Open {
    /// The last frame is on the screen, or was not wanted there; what has changed meanwhile is drawn next.
    pub fn end_frame(&mut self) {
        self.backend.screen.end_frame();
        if std::mem::take(&mut self.is_outdated) {
            self.window.request_redraw();
        }
    }

    /// Writes the settings to their file, with the size of the window.
    pub fn remember(&mut self) {
        // A window that fills the screen has no size to come back to.
        if !self.window.is_maximized() && self.window.fullscreen().is_none() {
            let size = self.window.inner_size().to_logical(self.window.scale_factor());
            self.panel.settings.size = [size.width, size.height];
        }
        self.memory.keep(&self.panel.settings);
    }

    pub fn new(window: Arc<Window>, backend: Backend, restarts: u32, panel: Panel, memory: Memory) -> Self {
        let (look, fresh, sent, last_edit, wake) = (None, None, None, None, None);
        Self {
            window,
            backend,
            restarts,
            failed_restarts: 0,
            crash_guard: CrashGuard::default(),
            panel,
            memory,
            quits: false,
            look,
            fresh,
            sent,
            is_outdated: false,
            last_edit,
            wake,
        }
    }

    pub fn take(&mut self, picture: Picture) {
        self.failed_restarts = 0;
        self.crash_guard.end(&picture);
        let is_new_edit = self.last_edit != Some(picture.edit);
        self.last_edit = Some(picture.edit);
        self.panel.take(&picture, is_new_edit);
        let event = Event::Presented {
            edit: picture.edit,
            change: picture.change,
            samples: picture.samples,
            resolution: picture.resolution,
            pipelines: picture.pipelines,
            since_change_ms: 0.0,
            blocked_ms: 0.0,
        };
        let (noticed, compiled) = (picture.noticed, picture.compiled.clone());
        self.fresh = Some(Fresh { event, noticed, compiled });
        self.window.set_title(&format!("{} - raytoy", picture.compiled.scene.name));
        self.backend.screen.set_picture(picture.texels);
    }

    /// Sees to it that the window is drawn again in that time, unless something else draws it before.
    pub fn draw_within(&mut self, time: Duration) {
        let then = Instant::now() + time;
        self.wake = Some(self.wake.map_or(then, |wake| wake.min(then)));
    }

    /// A scene that is let go over the window takes the place of the one there.
    pub fn drop_file(&mut self, file: PathBuf) {
        if file.extension().is_some_and(|ending| ending == "ron") {
            self.panel.leave(Leaving::Open(file));
            self.window.request_redraw();
        }
    }

    /// Lays out and presents.
    pub fn draw(&mut self) -> Presented {
        let input = self.backend.input.take_egui_input(&self.window);
        let picture = self.backend.screen.picture_id();
        let mut reply = None;
        let mut output = self.backend.context.run_ui(input, |ui| reply = Some(self.panel.show(ui, picture)));
        if let Some(reply) = reply {
            match reply.capture {
                Some(CaptureAction::Take(order)) => self.backend.album.take(*order),
                Some(CaptureAction::Stop) => self.backend.album.stop(),
                None => {}
            }
            for wish in reply.wishes {
                let _ = self.backend.thumbnails.send(wish);
            }
            for order in reply.orders {
                let _ = self.backend.builder.send(order);
            }
            self.quits |= reply.quits;
            let had_views = self.look.is_some_and(|look| look.has_views());
            if had_views != reply.look.has_views() {
                let _ = self.backend.builder.send(BuilderCommand::Views(!had_views));
            }
            if self.look != Some(reply.look) {
                self.look = Some(reply.look);
                let _ = self.backend.painter.send(PainterCommand::View(reply.look));
            }
        }
        // What a hand still drags is not worth a file yet.
        if !self.backend.context.input(|input| input.pointer.any_down()) {
            self.memory.keep(&self.panel.settings);
        }
        let delays = output.viewport_output.values().map(|viewport| viewport.repaint_delay);
        let delay = delays.min().unwrap_or(Duration::MAX);
        self.wake = Instant::now().checked_add(delay).filter(|_| delay < Duration::from_secs(3600));
        self.backend.input.handle_platform_output(&self.window, std::mem::take(&mut output.platform_output));
        let place = self.look.map_or(([0; 2], 1), |look| (look.corner, look.size[0]));
        let Backend { screen, context, .. } = &mut self.backend;
        // egui's renderer panics if the device is lost, and the report of that is on its way.
        if screen.gpu.is_lost() {
            return Presented::Dropped;
        }
        // It may be lost meanwhile, too.
        catch_unwind(AssertUnwindSafe(|| screen.present(place, context, output, &self.window)))
            .unwrap_or(Presented::Dropped)
    }
}
