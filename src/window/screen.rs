//! The window's surface: the picture and egui on it.

use std::sync::Arc;

use winit::window::Window;

use super::presenter::Presenter;
use crate::engine::messages::{FORMAT, Texels};
use crate::gpu::{AdapterChoice, Display, Gpu, Target};

/// A surface with what draws on it.
pub struct Screen {
    /// Where the driver is software: it would keep the window waiting. It ends first, since it has frames of
    /// the surface.
    presenter: Option<Presenter>,
    pub gpu: Gpu,
    config: wgpu::SurfaceConfiguration,
    egui: egui_wgpu::Renderer,
    /// What puts the picture there: faster than egui, which blends.
    display: Display,
    picture: Option<wgpu::Texture>,
    /// The same where it has come through memory, and so outlives the device.
    kept: Option<Texels>,
    /// As egui calls it.
    picture_id: Option<egui::TextureId>,
    is_presenting: bool,
    /// Whether the surface has yet to get the window's size.
    is_resized: bool,
    /// It ends last: while the device does work, that has frames, too.
    surface: wgpu::Surface<'static>,
}

/// What became of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Presented {
    /// There is none.
    Dropped,
    Shown,
    /// It is on its way, and the presenter reports when it is there.
    Sent,
}

impl Screen {
    /// `told` gets whether a frame that was sent is shown.
    ///
    /// # Errors
    /// If no GPU can draw on the window: a message for the user.
    pub fn new(
        window: Arc<Window>,
        display: winit::event_loop::OwnedDisplayHandle,
        choice: &AdapterChoice,
        told: impl Fn(bool) + Send + 'static,
    ) -> Result<Self, String> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_with_display_handle_from_env(
            Box::new(display),
        ));
        let size = window.inner_size();
        let surface = instance.create_surface(window).map_err(|e| e.to_string())?;
        let gpu = Gpu::open(&instance, choice, Some(&surface)).map_err(|e| e.to_string())?;
        let config = surface.get_default_config(&gpu.adapter, size.width.max(1), size.height.max(1));
        let mut config = config.ok_or("the GPU cannot draw on this window")?;
        // egui blends in the screen's own encoding.
        let formats = surface.get_capabilities(&gpu.adapter).formats;
        config.format = egui_wgpu::preferred_framebuffer_format(&formats).map_err(|e| e.to_string())?;
        // Pictures come when something has changed, so there is no need to wait for the screen's beat.
        config.present_mode = wgpu::PresentMode::AutoNoVsync;
        config.desired_maximum_frame_latency = 1;
        surface.configure(&gpu.device, &config);
        let options = egui_wgpu::RendererOptions { dithering: false, ..Default::default() };
        let egui = egui_wgpu::Renderer::new(&gpu.device, config.format, options);
        let display = Display::new(&gpu, config.format);
        let presenter = gpu.is_software().then(|| Presenter::start(gpu.clone(), told));
        Ok(Self {
            gpu,
            surface,
            config,
            egui,
            display,
            picture: None,
            kept: None,
            picture_id: None,
            presenter,
            is_presenting: false,
            is_resized: false,
        })
    }

    pub fn resize(&mut self, width: u32, height: u32) {
        if width > 0 && height > 0 {
            self.config.width = width;
            self.config.height = height;
            self.is_resized = true;
        }
    }

    /// Whether a frame is on its way: no other one may be drawn.
    pub fn is_presenting(&self) -> bool {
        self.is_presenting
    }

    /// The frame that was sent is there, or never will be.
    pub fn end_frame(&mut self) {
        self.is_presenting = false;
    }

    /// The picture, as egui calls it.
    pub fn picture_id(&self) -> Option<egui::TextureId> {
        self.picture_id
    }

    pub fn set_picture(&mut self, texels: Texels) {
        let Gpu { device, queue, .. } = &self.gpu;
        let texture = match &texels {
            Texels::Shared(texture) => texture.clone(),
            Texels::Bytes { size: [width, height], rgba } => {
                let size = wgpu::Extent3d { width: *width, height: *height, depth_or_array_layers: 1 };
                let old = self.picture.take().filter(|texture| texture.size() == size);
                let texture = old.unwrap_or_else(|| picture_texture(device, size));
                let layout = wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(4 * width),
                    rows_per_image: None,
                };
                queue.write_texture(texture.as_image_copy(), rgba, layout, size);
                texture
            }
        };
        let (view, filter) = (texture.create_view(&Default::default()), wgpu::FilterMode::Nearest);
        match self.picture_id {
            Some(id) => self.egui.update_egui_texture_from_wgpu_texture(device, &view, filter, id),
            None => self.picture_id = Some(self.egui.register_native_texture(device, &view, filter)),
        }
        self.picture = Some(texture);
        self.kept = matches!(texels, Texels::Bytes { .. }).then_some(texels);
    }

    /// The picture for the screen of another device, unless it is lost with this one.
    pub fn take_picture(&mut self) -> Option<Texels> {
        self.kept.take()
    }

    /// Draws the picture at its corner, so many pixels wide, and what egui has laid out.
    pub fn present(
        &mut self,
        (corner, width): ([u32; 2], u32),
        context: &egui::Context,
        mut output: egui::FullOutput,
        window: &Window,
    ) -> Presented {
        let Gpu { device, queue, .. } = &self.gpu;
        let points = output.pixels_per_point;
        let jobs = context.tessellate(std::mem::take(&mut output.shapes), points);
        let screen = egui_wgpu::ScreenDescriptor {
            size_in_pixels: [self.config.width, self.config.height],
            pixels_per_point: points,
        };
        for (id, deltas) in output.textures_delta.set.drain() {
            deltas.iter().for_each(|delta| self.egui.update_texture(device, queue, id, delta));
        }
        let mut encoder = device.create_command_encoder(&Default::default());
        let mut commands = self.egui.update_buffers(device, queue, &mut encoder, &jobs, &screen);
        let target = self.next_target();
        if let Some(target) = &target {
            let view = target.texture.create_view(&Default::default());
            let load = match &self.picture {
                Some(picture) => {
                    let zoom = width as f32 / picture.width() as f32;
                    self.display.draw(
                        picture,
                        None,
                        &view,
                        Target { corner: corner.map(|x| x as f32), zoom },
                    );
                    wgpu::LoadOp::Load
                }
                None => wgpu::LoadOp::Clear(wgpu::Color::BLACK),
            };
            let attachment = wgpu::RenderPassColorAttachment {
                view: &view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load, store: wgpu::StoreOp::Store },
            };
            let pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                color_attachments: &[Some(attachment)],
                ..Default::default()
            });
            self.egui.render(&mut pass.forget_lifetime(), &jobs, &screen);
        }
        commands.push(encoder.finish());
        self.gpu.queue.submit(commands);
        for id in output.textures_delta.free.drain() {
            self.egui.free_texture(&id);
        }
        let Some(target) = target else { return Presented::Dropped };
        window.pre_present_notify();
        match &self.presenter {
            Some(presenter) => {
                presenter.present(target);
                self.is_presenting = true;
                Presented::Sent
            }
            None => {
                self.gpu.queue.present(target);
                Presented::Shown
            }
        }
    }

    fn next_target(&mut self) -> Option<wgpu::SurfaceTexture> {
        use wgpu::CurrentSurfaceTexture::{Lost, Outdated, Suboptimal, Success};
        if std::mem::take(&mut self.is_resized) {
            self.surface.configure(&self.gpu.device, &self.config);
        }
        match self.surface.get_current_texture() {
            Success(target) | Suboptimal(target) => Some(target),
            Outdated | Lost => {
                self.surface.configure(&self.gpu.device, &self.config);
                match self.surface.get_current_texture() {
                    Success(target) | Suboptimal(target) => Some(target),
                    _ => None,
                }
            }
            _ => None,
        }
    }
}

fn picture_texture(device: &wgpu::Device, size: wgpu::Extent3d) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("picture"),
        size,
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: FORMAT,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    })
}
