//! How true each shape's crossings and normals are in f32, as a table:
//! `cargo test --release --test shape_table -- [RAYS] [SHAPE…]`, that many rays for each shape and distance; a
//! million for all shapes, unless told.

#[path = "../common/device.rs"]
mod device;
#[path = "../gpu/rays/mod.rs"]
mod rays;
// This table takes a part of it.
#[allow(dead_code, unused_imports)]
#[path = "../gpu/reference/mod.rs"]
mod reference;

use rays::{DISTANCES, SHAPES, Subject, Tally, extent};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let count: u64 = arguments.iter().find_map(|argument| argument.parse().ok()).unwrap_or(1_000_000);
    let is_wanted = |name: &str| arguments.iter().any(|argument| argument == name);
    let wants_all = !SHAPES.iter().any(|(name, _)| is_wanted(name));
    let Some(gpu) = device::gpu() else { return };
    println!(
        "{count} rays each. Errors are shares of the distance, or of the shape's radius where that is more; \
         each is the largest and what 99.9 % stay below. Excluded: rays that pass an edge or silhouette \
         within 1e-4 of the radius and 2e-6 of the distance.\n"
    );
    println!(
        "| shape | from | excluded | false hits | misses | off the surface | along the ray | normal, rad \
         | at its own point |"
    );
    println!("|---|--:|--:|--:|--:|--:|--:|--:|--:|");
    for (name, calls) in SHAPES.into_iter().filter(|(name, _)| wants_all || is_wanted(name)) {
        let subjects: Vec<Subject> = calls.iter().map(|call| Subject::new(gpu, *call)).collect();
        for distance in DISTANCES {
            let mut tally = Tally::default();
            subjects
                .iter()
                .for_each(|subject| tally.join(subject.shoot(distance, count / calls.len() as u64)));
            let from = distance.map_or("within".into(), |d| format!("{d}"));
            let share = |part: u64, of: u64| part as f64 / of as f64;
            print!(
                "| {name} | {from} | {:.1} % | {} ({:.0e}) | {} ({:.0e}) |",
                100.0 * share(tally.excluded, tally.rays),
                tally.false_hits,
                share(tally.false_hits, tally.judged()),
                tally.misses,
                share(tally.misses, tally.judged()),
            );
            let errors = [&mut tally.surface, &mut tally.along, &mut tally.normal, &mut tally.own_normal];
            for (most, usual) in errors.map(|values| extent(values, 0.999)) {
                print!(" {most:.1e}, {usual:.1e} |");
            }
            println!();
            if let Some((_, worst)) = tally.worst.filter(|_| std::env::var_os("RAYTOY_WORST").is_some()) {
                eprintln!("{name} from {from}: {worst}");
            }
        }
    }
}
