//! Coverage, exactly.

use super::super::project::Spot;
use super::*;
use glam::Vec2;
use proptest::prelude::*;

fn corner(x: i32, y: i32, depth: f32) -> Corner {
    Corner { spot: Spot { x, y, depth }, uv: Vec2::ZERO }
}

fn cover(corners: [Corner; 3], side: i32) -> Vec<bool> {
    let mut depth = vec![f32::NEG_INFINITY; (side * side) as usize];
    let mut ids = vec![0; depth.len()];
    let mut band = Band { top: 0, width: side, depth: &mut depth, ids: &mut ids };
    draw::<true, false>(&mut band, corners, 7, None);
    ids.iter().map(|&id| id == 7).collect()
}

#[test]
fn half_a_square_covers_half_its_samples() {
    let s = SUBSAMPLES;
    let (a, b, c, d) = (
        corner(0, 0, 1.0),
        corner(16 * s, 0, 1.0),
        corner(0, 16 * s, 1.0),
        corner(16 * s, 16 * s, 1.0),
    );
    let count = |covered: Vec<bool>| covered.iter().filter(|&&on| on).count();
    let (upper, lower) = (count(cover([a, b, c], 16)), count(cover([b, d, c], 16)));
    // The 16 samples on the diagonal belong to one of them.
    assert_eq!((upper + lower, upper.abs_diff(lower)), (256, 16));
}

proptest! {
    #[test]
    fn a_fan_covers_each_sample_exactly_once(
        middle in (0..16 * 256, 0..16 * 256),
        ring in prop::collection::vec(0..4 * 16 * 256, 3..8),
    ) {
        // Points on the border of the square in order, and all four corners of it.
        let side = 16 * SUBSAMPLES;
        let mut ring = ring;
        ring.extend([0, side, 2 * side, 3 * side]);
        ring.sort_unstable();
        ring.dedup();
        let on_border = |t: i32| match t / side {
            0 => corner(t, 0, 1.0),
            1 => corner(side, t - side, 1.0),
            2 => corner(3 * side - t, side, 1.0),
            _ => corner(0, 4 * side - t, 1.0),
        };
        let middle = corner(middle.0, middle.1, 1.0);
        let mut times = vec![0; 256];
        for i in 0..ring.len() {
            let next = ring[(i + 1) % ring.len()];
            let covered = cover([middle, on_border(ring[i]), on_border(next)], 16);
            times.iter_mut().zip(covered).for_each(|(n, on)| *n += i32::from(on));
        }
        prop_assert!(times.iter().all(|&n| n == 1), "{times:?}");
    }

    #[test]
    fn the_quotient_is_rounded_down(n in 0..1 << 30, steps in 1..1 << 14, k in 0..64) {
        let slope = steps * SUBSAMPLES;
        let edge = SmallEdge::from(Edge { start: 0, per_row: 0, per_x: i64::from(slope) });
        prop_assert_eq!(edge.quotient(n), n / slope);
        prop_assert_eq!(edge.quotient(k * slope), k);
        prop_assert_eq!(edge.quotient(k * slope + slope - 1), k);
    }

    #[test]
    fn small_and_large_triangles_are_drawn_alike(
        at in prop::array::uniform3((-500..16 * 256 + 500, -500..16 * 256 + 500)),
    ) {
        let [a, b, c] = at.map(|(x, y)| corner(x, y, 1.0));
        let (left, top) = (0, 0);
        for (from, to) in [(&a, &b), (&b, &c), (&c, &a)] {
            let edge = Edge::new(from, to, left, top);
            let small = SmallEdge::from(edge);
            for row in 0..16 {
                let (mut large, mut little) = ((0, 15), (0, 15));
                edge.bound(row, &mut large.0, &mut large.1);
                small.bound(row, &mut little.0, &mut little.1);
                let empty = |(first, last): (i32, i32)| first > last;
                prop_assert!(large == little || empty(large) && empty(little));
            }
        }
    }
}
