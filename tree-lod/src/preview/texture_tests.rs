//! Levels keep coverage and colour.

use super::*;

fn dots(side: u32) -> Texture {
    // A single texel in nine is opaque: plain averaging would leave nothing above one half.
    let pixels = (0..side * side).flat_map(|i| {
        let on = (i % side).is_multiple_of(3) && (i / side).is_multiple_of(3);
        [0, 255, 0, if on { 255 } else { 0 }]
    });
    Texture { name: "dots".into(), width: side, height: side, pixels: pixels.collect() }
}

#[test]
fn smaller_levels_cover_as_much_as_the_texture() {
    let pyramid = Pyramid::new(&dots(192), 128, false, Srgb::shared());
    assert!(pyramid.levels.len() > 3);
    for level in &pyramid.levels {
        let n = level.alpha.iter().filter(|&&a| u16::from(a) >= level.cutoff).count();
        let share = n as f64 / level.alpha.len() as f64;
        assert!((0.09..0.13).contains(&share), "{} px: {share}", level.width);
    }
}

#[test]
fn what_lies_beside_a_leaf_does_not_bleed_into_it() {
    let mut texture = dots(64);
    texture.pixels.chunks_mut(4).filter(|p| p[3] == 0).for_each(|p| p[..3].fill(255));
    let srgb = Srgb::shared();
    let pyramid = Pyramid::new(&texture, 128, true, srgb);
    for level in &pyramid.levels {
        let color = level.color(1.0 / 64.0 * 0.5, 1.0 / 64.0 * 0.5, true, srgb);
        assert!(color.x < 0.05 && color.y > 0.95, "{} px: {color}", level.width);
    }
}

#[test]
fn srgb_survives_the_round_trip() {
    let srgb = Srgb::shared();
    for byte in 0..=255 {
        assert_eq!(srgb.encode(srgb.decode([byte, 0, 0, 0]).x), byte);
    }
}

#[test]
fn wrapping_repeats_and_survives_huge_coordinates() {
    assert_eq!(wrap(-0.25), 0.75);
    assert_eq!(wrap(7.5), 0.5);
    for t in [1e30, -1e30, f32::MAX, -1e-12, 2_147_483_648.0] {
        assert!((0.0..=1.0).contains(&wrap(t)), "{t}");
    }
}
