//! All that lives on a device, and so ends with it: the screen, the threads behind it, and egui's textures.

use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::Sender;

use winit::event_loop::{EventLoopProxy, OwnedDisplayHandle};
use winit::window::Window;

use super::Options;
use super::screen::Screen;
use crate::engine::album::Album;
use crate::engine::builder_messages::BuilderCommand;
use crate::engine::crash_guard::CrashGuard;
use crate::engine::messages::{EngineEvent, PainterCommand};
use crate::engine::{builder, painter, thumbnails};
use crate::gpu::Gpu;
use crate::panel::{self, Theme};

/// A window's device, and what stands on it.
pub struct Backend {
    pub screen: Screen,
    pub context: egui::Context,
    pub input: egui_winit::State,
    pub builder: Sender<BuilderCommand>,
    pub painter: Sender<PainterCommand>,
    pub album: Album,
    pub thumbnails: Sender<thumbnails::ThumbnailCommand>,
    /// That of the picture.
    gpu: Gpu,
}

/// Passes on what a driving program asks for.
pub fn listen(options: &Options, proxy: EventLoopProxy<(u32, EngineEvent)>) {
    let Some(remote) = options.remote.clone() else { return };
    std::thread::spawn(move || {
        let remote = remote.lock().expect("nobody else reads it");
        remote.iter().for_each(|wish| drop(proxy.send_event((0, EngineEvent::Remote(wish)))));
    });
}

impl Backend {
    /// Starts all of it on `scene`; `notify` gets all events, from other threads.
    ///
    /// # Errors
    /// If no GPU can draw on the window: a message for the user.
    pub fn start(
        window: &Arc<Window>,
        display: OwnedDisplayHandle,
        options: &Options,
        (scene, crash_guard, theme): (&Path, CrashGuard, Theme),
        notify: impl Fn(EngineEvent) + Clone + Send + Sync + 'static,
    ) -> Result<Self, String> {
        let choice = &options.adapter;
        let frames = notify.clone();
        let told = move |is_shown| frames(EngineEvent::Frame { is_shown });
        let screen = Screen::new(window.clone(), display, choice, told)?;
        // A software driver compiles while it draws, so the picture gets a device of its own.
        let shares_device = !screen.gpu.is_software();
        let gpu = match shares_device {
            true => screen.gpu.clone(),
            false => Gpu::headless(choice).map_err(|e| e.to_string())?,
        };
        for gpu in [&gpu, &screen.gpu] {
            let notify = notify.clone();
            gpu.when_lost(move |why| notify(EngineEvent::Lost(why)));
        }
        let painter = painter::start(gpu.clone(), shares_device, notify.clone());
        let wishes = painter.clone();
        let news = notify.clone();
        let thumbnails =
            thumbnails::start(choice.clone(), options.cache.clone(), options.disk.clone(), move |told| {
                news(EngineEvent::Gallery(told));
            });
        let album = Album::new(gpu.clone(), move || notify(EngineEvent::Captured));
        let built = move |built| drop(wishes.send(PainterCommand::Built(built)));
        let builder = builder::start(gpu.clone(), options.disk.clone(), crash_guard, built);
        let _ = builder.send(BuilderCommand::Open(scene.to_owned()));
        let context = egui::Context::default();
        panel::apply_style(&context, theme);
        let side = screen.gpu.device.limits().max_texture_dimension_2d as usize;
        let input = egui_winit::State::new(
            context.clone(),
            egui::ViewportId::ROOT,
            &**window,
            None,
            None,
            Some(side),
        );
        Ok(Self { screen, context, input, builder, painter, album, thumbnails, gpu })
    }

    /// "llvmpipe (LLVM 15.0.6, 256 bits), Vulkan"
    pub fn adapter(&self) -> String {
        self.gpu.describe()
    }

    /// Ends the devices as a driver does that gives up.
    pub fn lose(&self) {
        [&self.gpu, &self.screen.gpu].into_iter().for_each(Gpu::lose);
    }
}

impl Drop for Backend {
    fn drop(&mut self) {
        // Its watcher holds a sender of its own, so the builder would wait for ever.
        let _ = self.builder.send(BuilderCommand::End);
    }
}
