//! The window's thread: winit's events in, commands out. It never compiles, draws a scene or waits for a GPU.

use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

use winit::application::ApplicationHandler;
use winit::event::{StartCause, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, EventLoopProxy};
use winit::window::{Window, WindowId};

use super::Options;
use super::backend::{self, Backend};
use super::open::{Fresh, Open};
use super::screen::Presented;
use crate::diagnostic::{Diagnostic, Severity};
use crate::engine::builder_messages::BuilderCommand;
use crate::engine::crash_guard::CrashGuard;
use crate::engine::events::Event;
use crate::engine::messages::{EngineEvent, PainterCommand, Remote};
use crate::gpu::GpuError;
use crate::panel::{Memory, Panel, Theme};

/// Opens the window and returns when it is closed.
pub fn run(options: Options, on_event: &dyn Fn(&Event)) -> Result<(), String> {
    let events = EventLoop::<(u32, EngineEvent)>::with_user_event().build().map_err(|error| {
        let instead = "to draw to a file without a display: raytoy render SCENE -o out.png";
        format!("the window cannot be opened: {error}\n{instead}")
    })?;
    let proxy = events.create_proxy();
    backend::listen(&options, proxy.clone());
    let mut app = App { options, on_event, proxy, open: None, failure: None, blocked: Duration::ZERO };
    events.run_app(&mut app).map_err(|error| error.to_string())?;
    app.failure.map_or(Ok(()), Err)
}

struct App<'a> {
    options: Options,
    on_event: &'a dyn Fn(&Event),
    proxy: EventLoopProxy<(u32, EngineEvent)>,
    open: Option<Open>,
    /// Why the window had to close.
    failure: Option<String>,
    /// The longest event since the last picture.
    blocked: Duration,
}

/// What a new text offers may show that much later: where it has another picture, the window is drawn for
/// that, and until then the driver needs the processor.
const PATIENCE: Duration = Duration::from_millis(300);

/// A driver that gives up this often before it has drawn anything does not come back.
const MAX_FAILED_RESTARTS: u32 = 4;

impl App<'_> {
    fn open(&self, event_loop: &ActiveEventLoop) -> Result<Open, String> {
        let memory = Memory::open(self.options.memory.clone());
        let [width, height] = self.options.size.unwrap_or(memory.kept().size);
        let attributes = Window::default_attributes()
            .with_title("raytoy")
            .with_inner_size(winit::dpi::LogicalSize::new(width, height));
        let window = Arc::new(event_loop.create_window(attributes).map_err(|e| e.to_string())?);
        let backend = self.backend(
            &window,
            event_loop,
            0,
            (&self.options.scene, CrashGuard::default(), memory.kept().theme),
        )?;
        let panel = Panel::new(&self.options.scene, backend.adapter(), memory.kept().clone());
        let panel = panel.on(&self.options.disk);
        (self.on_event)(&Event::Opened { adapter: backend.adapter() });
        Ok(Open::new(window, backend, 0, panel, memory))
    }

    /// Starts the device with this number, counted from 0, and all that stands on it.
    fn backend(
        &self,
        window: &Arc<Window>,
        event_loop: &ActiveEventLoop,
        number: u32,
        begun: (&Path, CrashGuard, Theme),
    ) -> Result<Backend, String> {
        let proxy = self.proxy.clone();
        // A loop that has ended wants no more news.
        let notify = move |notice| drop(proxy.send_event((number, notice)));
        Backend::start(window, event_loop.owned_display_handle(), &self.options, begun, notify)
    }

    /// Goes on with another device in place of one that is lost. What the author has done stays.
    fn restart(&mut self, event_loop: &ActiveEventLoop, why: String) {
        let Some(open) = self.open.take() else { return };
        let Open {
            window,
            mut backend,
            restarts,
            failed_restarts,
            mut crash_guard,
            mut panel,
            memory: kept,
            ..
        } = open;
        crash_guard.fail(&why);
        let memory = backend.context.memory(Clone::clone);
        let picture = backend.screen.take_picture();
        // The surface has to let go of the window before another one takes it.
        drop(backend);
        let number = restarts + 1;
        let started = match failed_restarts < MAX_FAILED_RESTARTS {
            true => {
                let begun = (panel.scene(), crash_guard.clone(), panel.settings.theme);
                self.backend(&window, event_loop, number, begun)
            }
            false => Err(format!("the GPU fails repeatedly: {why}")),
        };
        match started {
            Ok(mut backend) => {
                // It stays on the screen while the new device draws it again.
                picture.into_iter().for_each(|picture| backend.screen.set_picture(picture));
                backend.context.memory_mut(|fresh| *fresh = memory);
                for order in panel.begin_again() {
                    let _ = backend.builder.send(order);
                }
                window.request_redraw();
                (self.on_event)(&Event::Restarted { adapter: backend.adapter(), why });
                let open = Open::new(window, backend, number, panel, kept);
                self.open = Some(Open { failed_restarts: failed_restarts + 1, crash_guard, ..open });
            }
            Err(why) => {
                self.failure = Some(why);
                event_loop.exit();
            }
        }
    }

    /// Keeps the longest time that the thread was busy with one event.
    fn timed(&mut self, work: impl FnOnce(&mut Self)) {
        let begun = Instant::now();
        work(self);
        self.blocked = self.blocked.max(begun.elapsed());
    }

    fn redraw(&mut self) {
        let Some(open) = &mut self.open else { return };
        if open.backend.screen.is_presenting() {
            open.is_outdated = true;
            return;
        }
        if let Some(object) = open.panel.take_choice() {
            (self.on_event)(&Event::Chosen { object });
        }
        let frame = open.draw();
        if frame != Presented::Dropped {
            open.sent = open.fresh.take();
        }
        if frame == Presented::Shown {
            self.presented();
        }
    }

    /// The frame drawn last is on the screen.
    fn presented(&mut self) {
        let Some(open) = &mut self.open else { return };
        let _ = open.backend.painter.send(PainterCommand::Shown);
        let Some(Fresh { mut event, noticed, compiled }) = open.sent.take() else { return };
        let _ = open.backend.builder.send(BuilderCommand::Shown(compiled));
        if let Event::Presented { since_change_ms, blocked_ms, .. } = &mut event {
            *since_change_ms = noticed.elapsed().as_secs_f64() * 1e3;
            *blocked_ms = self.blocked.as_secs_f64() * 1e3;
        }
        self.blocked = Duration::ZERO;
        (self.on_event)(&event);
    }
}

impl ApplicationHandler<(u32, EngineEvent)> for App<'_> {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.open.is_some() {
            return;
        }
        match self.open(event_loop) {
            Ok(open) => self.open = Some(open),
            Err(why) => {
                self.failure = Some(why);
                event_loop.exit();
            }
        }
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, (device, notice): (u32, EngineEvent)) {
        self.timed(|app| {
            let Some(open) = &mut app.open else { return };
            // Messages of a lost device are of no use.
            if device != open.restarts && !matches!(notice, EngineEvent::Remote(_)) {
                return;
            }
            match notice {
                EngineEvent::Lost(why) | EngineEvent::Failed(GpuError::Lost(why)) => {
                    return app.restart(event_loop, why);
                }
                EngineEvent::Remote(Remote::LoseDevice) => return open.backend.lose(),
                EngineEvent::Picture(picture) => open.take(picture),
                EngineEvent::Unsketched(compiled) => {
                    return drop(open.backend.builder.send(BuilderCommand::Shown(compiled)));
                }
                EngineEvent::Frame { is_shown } => {
                    open.end_frame();
                    return if is_shown {
                        app.presented()
                    };
                }
                EngineEvent::Unchanged(warnings) => {
                    (app.on_event)(&Event::Unchanged);
                    if !open.panel.mend(&warnings) {
                        return;
                    }
                }
                EngineEvent::Warned(warnings) => {
                    (app.on_event)(&Event::Warned { text: warnings.to_string() });
                    open.panel.mend(&warnings);
                }
                EngineEvent::Tries(compiled) => {
                    open.crash_guard.begin(compiled);
                    return (app.on_event)(&Event::Begun);
                }
                EngineEvent::File(text) => {
                    // A verdict follows, and shows.
                    return drop(open.backend.builder.send(open.panel.file_says(&text)));
                }
                EngineEvent::Gallery(news) => open.panel.receive_thumbnails(news),
                EngineEvent::Captured => open.panel.follow(&mut open.backend.album),
                EngineEvent::Identity(identity) => open.panel.know(identity),
                EngineEvent::Outline { outline, text } => {
                    open.panel.offer(outline, text);
                    return open.draw_within(PATIENCE);
                }
                EngineEvent::Ready { pipelines } => return (app.on_event)(&Event::Ready { pipelines }),
                EngineEvent::Broken(report) => {
                    let (errors, text) = (report.count(Severity::Error), report.to_string());
                    (app.on_event)(&Event::Broken { errors, text });
                    open.panel.break_with(report);
                }
                EngineEvent::Slow(slow) => {
                    let before = std::mem::replace(&mut open.panel.slow, slow);
                    if let Some(slow) = slow.filter(|_| before.is_none()) {
                        (app.on_event)(&Event::Slow { seconds: slow.sample.as_secs_f64().round() });
                    }
                }
                EngineEvent::Failed(error) => {
                    open.panel.break_with(Diagnostic::error(error.to_string()).into());
                }
            }
            open.window.request_redraw();
        });
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        self.timed(|app| {
            let Some(open) = &mut app.open else { return };
            let response = open.backend.input.on_window_event(&open.window, &event);
            match event {
                WindowEvent::CloseRequested if open.panel.closes() => event_loop.exit(),
                WindowEvent::CloseRequested => {
                    open.window.focus_window();
                    open.window.request_redraw();
                }
                WindowEvent::Resized(size) => {
                    open.backend.screen.resize(size.width, size.height);
                    open.window.request_redraw();
                }
                WindowEvent::DroppedFile(file) => open.drop_file(file),
                WindowEvent::RedrawRequested => app.redraw(),
                _ if response.repaint => open.window.request_redraw(),
                _ => {}
            }
        });
    }

    fn new_events(&mut self, _: &ActiveEventLoop, cause: StartCause) {
        if let (StartCause::ResumeTimeReached { .. }, Some(open)) = (cause, &mut self.open) {
            open.wake = None;
            open.window.request_redraw();
        }
    }

    fn exiting(&mut self, _: &ActiveEventLoop) {
        if let Some(open) = &mut self.open {
            open.remember();
        }
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        if self.open.as_ref().is_some_and(|open| open.quits) {
            event_loop.exit();
        }
        let wake = self.open.as_ref().and_then(|open| open.wake);
        event_loop.set_control_flow(wake.map_or(ControlFlow::Wait, ControlFlow::WaitUntil));
    }
}
