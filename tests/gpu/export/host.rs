//! A program that knows wgpu, a standalone file and what lies beside it, and of raytoy only its device.

use raytoy::frame::sample_offset;
use raytoy::gpu::{Display, Gpu};
use wgpu::util::DeviceExt;

use super::files;

/// Draws as the head says under "one sample a pixel".
pub fn one_sample(gpu: &Gpu, text: &str, texels: &[u8], size: [u32; 2]) -> Vec<u8> {
    let target = texture(gpu, size, wgpu::TextureFormat::Rgba8Unorm);
    let frame = frame(text, size, 0, [0.0; 2]);
    draw(gpu, text, "drawPicture", &target, Bound::Scene { frame: &frame, texels }, None);
    read(gpu, &target)
}

/// Draws as the head says under "many samples a pixel".
pub fn many_samples(gpu: &Gpu, text: &str, texels: &[u8], size: [u32; 2], count: u32) -> Vec<u8> {
    let light = texture(gpu, size, wgpu::TextureFormat::Rgba16Float);
    for n in 0..count {
        let frame = frame(text, size, n, sample_offset(n, count));
        let bound = Bound::Scene { frame: &frame, texels };
        draw(gpu, text, "drawLight", &light, bound, Some(1.0 / f64::from(n + 1)));
    }
    let target = texture(gpu, size, wgpu::TextureFormat::Rgba8Unorm);
    draw(gpu, text, "showSamples", &target, Bound::Samples(&light), None);
    read(gpu, &target)
}

/// How two pictures differ, unless 99.9 % of their pixels are within 2 of 255.
pub fn difference(one: &[u8], other: &[u8]) -> Option<String> {
    let far = |(a, b): &(&[u8], &[u8])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 2);
    let count = one.chunks(4).zip(other.chunks(4)).filter(far).count();
    let is_same = one.len() == other.len() && count * 1000 <= one.len() / 4;
    (!is_same).then(|| format!("{count} of {} pixels differ", one.len() / 4))
}

/// The bytes of the uniform buffer, by the table of the head.
fn frame(text: &str, [width, height]: [u32; 2], n: u32, jitter: [f32; 2]) -> Vec<u8> {
    let head: Vec<&str> = text.lines().map_while(|line| line.strip_prefix("//")).collect();
    let size = head.iter().find_map(|line| line.split_once(" bytes, for the fragment entry"));
    let size = size.and_then(|(before, _)| before.rsplit(' ').next()?.parse().ok());
    let mut bytes = vec![0; size.expect("the head tells how large the buffer is")];
    let (width, height) = (width as f32, height as f32);
    let mut told = 0;
    for line in head {
        let mut words = line.split_whitespace();
        let Some(offset) = words.next().and_then(|word| word.parse::<usize>().ok()) else { continue };
        let (ty, field) = (words.next().expect("a type"), words.next().expect("a name"));
        let said = words.collect::<Vec<_>>().join(" ");
        let numbers = said.split([':', ';']).next().unwrap_or_default();
        let scene: Vec<f32> = numbers.split(", ").filter_map(|number| number.parse().ok()).collect();
        let numbers = match field {
            "resolution" => vec![width, height],
            "pixel_spread" => vec![scene[0] / height],
            "jitter" => jitter.to_vec(),
            "sample" => vec![n as f32],
            "time" => vec![0.0],
            "mouse" => vec![0.0, 0.0],
            _ => scene,
        };
        let count = ["f32", "vec2f", "vec3f"].iter().position(|name| *name == ty).map_or(1, |i| i + 1);
        assert_eq!(numbers.len(), count, "{line}");
        for (i, x) in numbers.into_iter().enumerate() {
            let word = if ty == "u32" { (x as u32).to_le_bytes() } else { x.to_le_bytes() };
            bytes[offset + 4 * i..][..4].copy_from_slice(&word);
        }
        told += 1;
    }
    assert_eq!(told, 17, "the head tells of all fields");
    bytes
}

/// What a fragment entry reads.
enum Bound<'a> {
    Scene { frame: &'a [u8], texels: &'a [u8] },
    Samples(&'a wgpu::Texture),
}

/// One triangle, with layouts that wgpu reads from the shader; `blend` is the share of what is drawn.
fn draw(gpu: &Gpu, text: &str, entry: &str, target: &wgpu::Texture, bound: Bound<'_>, blend: Option<f64>) {
    let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: None,
        source: wgpu::ShaderSource::Wgsl(text.into()),
    });
    let mix = wgpu::BlendComponent {
        src_factor: wgpu::BlendFactor::Constant,
        dst_factor: wgpu::BlendFactor::OneMinusConstant,
        operation: wgpu::BlendOperation::Add,
    };
    let pipeline = gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: None,
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("coverPicture"),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: Default::default(),
        depth_stencil: None,
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some(entry),
            compilation_options: Default::default(),
            targets: &[Some(wgpu::ColorTargetState {
                format: target.format(),
                blend: blend.map(|_| wgpu::BlendState { color: mix, alpha: mix }),
                write_mask: wgpu::ColorWrites::ALL,
            })],
        }),
        multiview_mask: None,
        cache: None,
    });
    let view = |texture: &wgpu::Texture| texture.create_view(&Default::default());
    let (buffer, samples);
    let mut files = None;
    let entry = match bound {
        Bound::Scene { frame, texels } => {
            files = files::bind_group(gpu, text, texels, &pipeline);
            buffer = gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: None,
                contents: frame,
                usage: wgpu::BufferUsages::UNIFORM,
            });
            wgpu::BindGroupEntry { binding: 0, resource: buffer.as_entire_binding() }
        }
        Bound::Samples(texture) => {
            samples = view(texture);
            wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(&samples) }
        }
    };
    let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &[entry],
    });
    let target = view(target);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &target,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load: wgpu::LoadOp::Load, store: wgpu::StoreOp::Store },
            })],
            ..Default::default()
        });
        let c = blend.unwrap_or_default();
        pass.set_blend_constant(wgpu::Color { r: c, g: c, b: c, a: c });
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        files.iter().for_each(|files| pass.set_bind_group(1, files, &[]));
        pass.draw(0..3, 0..1);
    }
    gpu.queue.submit([encoder.finish()]);
}

fn read(gpu: &Gpu, target: &wgpu::Texture) -> Vec<u8> {
    Display::new(gpu, target.format()).read(target).expect("the driver answers")
}

fn texture(gpu: &Gpu, [width, height]: [u32; 2], format: wgpu::TextureFormat) -> wgpu::Texture {
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT
            | wgpu::TextureUsages::TEXTURE_BINDING
            | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    })
}
