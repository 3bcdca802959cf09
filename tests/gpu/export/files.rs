//! The file of texels beside an export, and the table of its head that says what to bind of it.

use raytoy::gpu::Gpu;

/// A row of the table.
pub struct Row<'a> {
    /// As the language writes it: `@group(1) @binding(2)`.
    pub place: &'a str,
    ty: &'a str,
    content: &'a str,
}

/// The table of a head; no rows where the scene takes nothing from files.
pub fn table(text: &str) -> Vec<Row<'_>> {
    let head = text.lines().map_while(|line| line.strip_prefix("//"));
    let rows = head.skip_while(|line| !line.starts_with("   bound to ")).skip(1);
    rows.map_while(|line| {
        let (place, rest) = line.strip_prefix("   ")?.split_once("  ")?;
        let (ty, rest) = rest.trim_start().split_once(' ')?;
        let (_, content) = rest.trim_start().split_once(' ')?;
        Some(Row { place, ty, content: content.trim_start() })
    })
    .collect()
}

/// Bind group 1 by the table, where there is one.
pub fn bind_group(
    gpu: &Gpu,
    text: &str,
    texels: &[u8],
    pipeline: &wgpu::RenderPipeline,
) -> Option<wgpu::BindGroup> {
    let rows = table(text);
    if rows.is_empty() {
        assert!(texels.is_empty(), "the head tells nothing of its texels");
        return None;
    }
    let size = format!("behind, {} bytes, little-endian", texels.len());
    assert!(text.contains(&size), "the head lacks `{size}`");
    let views: Vec<_> =
        rows.iter().map(|row| (row.ty != "sampler").then(|| view(gpu, row, texels))).collect();
    let sampler = sampler(gpu);
    let entries = rows.iter().zip(&views).map(|(row, view)| {
        let number = row.place.strip_prefix("@group(1) @binding(").and_then(|rest| rest.strip_suffix(')'));
        let resource = match view {
            Some(view) => wgpu::BindingResource::TextureView(view),
            None => {
                assert_eq!(row.content, "linear in a level and between levels; repeats to all sides");
                wgpu::BindingResource::Sampler(&sampler)
            }
        };
        wgpu::BindGroupEntry { binding: number.and_then(|n| n.parse().ok()).expect("a number"), resource }
    });
    Some(gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(1),
        entries: &entries.collect::<Vec<_>>(),
    }))
}

/// The texture of a row such as `rgba16float, 64x48, 7 levels from byte 0: a.png`.
fn view(gpu: &Gpu, row: &Row<'_>, texels: &[u8]) -> wgpu::TextureView {
    let (told, _) = row.content.split_once(": ").expect("it tells its files");
    let [format, size, levels] = told.split(", ").collect::<Vec<_>>()[..] else { panic!("{told}") };
    let number = |text: &str| text.parse::<u32>().unwrap_or_else(|_| panic!("`{text}` in {told}"));
    let (width, height) = size.split_once('x').map(|(x, y)| (number(x), number(y))).expect("a size");
    let words: Vec<&str> = levels.split(' ').collect();
    let (count, mut at) = (number(words[0]), number(words[words.len() - 1]) as usize);
    let (format, bytes) = match (format, row.ty) {
        ("rgba16float", "texture_2d<f32>") => (wgpu::TextureFormat::Rgba16Float, 8),
        ("rgba32uint", "texture_2d<u32>") => (wgpu::TextureFormat::Rgba32Uint, 16),
        other => panic!("no such texture: {other:?}"),
    };
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: count,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for mip_level in 0..count {
        let [width, height] = [width, height].map(|n| (n >> mip_level).max(1));
        let row = width * bytes;
        let end = at + (row * height) as usize;
        gpu.queue.write_texture(
            wgpu::TexelCopyTextureInfo { mip_level, ..texture.as_image_copy() },
            &texels[at..end],
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None },
            wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        );
        at = end;
    }
    texture.create_view(&Default::default())
}

fn sampler(gpu: &Gpu) -> wgpu::Sampler {
    gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        address_mode_u: wgpu::AddressMode::Repeat,
        address_mode_v: wgpu::AddressMode::Repeat,
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        ..Default::default()
    })
}
