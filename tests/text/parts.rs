//! The parts that a large picture is drawn in.

use raytoy::gpu::Region;
use raytoy::gpu::parts::{Parts, lay};

#[test]
fn parts_cover_each_pixel_once_and_begin_at_even_places() {
    for (pixels, side, size) in [
        (1 << 22, 16_384, [65_536, 1000]),
        (64, 8, [33, 17]),
        (1, 1, [5, 3]),
        (100, 64, [1, 65]),
        (1 << 22, 16_384, [960, 540]),
    ] {
        let parts = Parts { pixels, side };
        let regions: Vec<Region> = parts.strips(size).into_iter().flatten().collect();
        let covered: u64 = regions.iter().map(|region| u64::from(region.pixels())).sum();
        assert_eq!(covered, u64::from(size[0]) * u64::from(size[1]), "{parts:?} {size:?}");
        for region in &regions {
            assert!(region.columns.start % 2 == 0 && region.rows.start % 2 == 0, "{region:?}");
            assert!(region.columns.end <= size[0] && region.rows.end <= size[1], "{region:?}");
            let most = side.max(2) as usize;
            assert!(region.columns.len() <= most && region.rows.len() <= most, "{region:?}");
        }
    }
    assert_eq!(Parts { pixels: 1 << 22, side: 16_384 }.strips([960, 540]).len(), 1);
}

#[test]
fn parts_are_laid_beside_each_other() {
    let mut strip = [0; 6];
    for (columns, part) in [(0..2, &[1, 2, 4, 5][..]), (2..3, &[3, 6])] {
        lay(&mut strip, 3, &Region { columns, rows: 0..2 }, part);
    }
    assert_eq!(strip, [1, 2, 3, 4, 5, 6]);
}
