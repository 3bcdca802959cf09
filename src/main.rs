use raytoy::gpu::*;
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let sources = raytoy::sources::Sources::on_disk(std::path::Path::new("."));
    let mode = if args.len() > 3 { raytoy::wgsl::Mode::Live } else { raytoy::wgsl::Mode::Baked };
    let out = raytoy::compile(&sources, args[1].as_ref(), mode, None);
    eprint!("{}", out.report);
    if let Some(c) = out.compiled { eprintln!("{:?}", c.times); if args[2] == "-" { print!("{}", c.source.text()); return; }
        let gpu = Gpu::headless(&AdapterChoice::Fastest).unwrap();
        eprintln!("{}", gpu.describe());
        let p = render(&gpu, &c, &Moment::of(&c.scene), [960,540], 1, &mut |_|()).unwrap();
        eprintln!("{:?}", p.times);
        image::RgbaImage::from_raw(960,540,p.rgba).unwrap().save(&args[2]).unwrap();
    }
}
