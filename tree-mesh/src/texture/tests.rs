//! What holds for every built-in texture.

use super::*;

fn pixel(texture: &Texture, x: usize, y: usize) -> [u8; 4] {
    let at = 4 * (y * texture.width as usize + x);
    [0, 1, 2, 3].map(|k| texture.pixels[at + k])
}

fn difference(a: [u8; 4], b: [u8; 4]) -> f32 {
    (0..3).map(|k| f32::from(a[k].abs_diff(b[k]))).sum::<f32>() / 3.0
}

#[test]
fn barks_tile_without_a_seam() {
    for name in bark_names() {
        let texture = bark(name).unwrap();
        let n = texture.width as usize;
        assert_eq!(texture.pixels.len(), 4 * n * n);
        assert!(texture.pixels.chunks_exact(4).all(|pixel| pixel[3] == 255));
        let columns = |x: usize| -> f32 {
            (0..n).map(|y| difference(pixel(&texture, x, y), pixel(&texture, (x + 1) % n, y))).sum()
        };
        let rows = |y: usize| -> f32 {
            (0..n).map(|x| difference(pixel(&texture, x, y), pixel(&texture, x, (y + 1) % n))).sum()
        };
        for (way, step) in [("across", &columns as &dyn Fn(usize) -> f32), ("along", &rows)] {
            let mut inner: Vec<f32> = (0..n - 1).map(step).collect();
            inner.sort_unstable_by(f32::total_cmp);
            let (most, seam) = (inner[n - 2], step(n - 1));
            assert!(seam <= most, "{name} {way}: seam {seam}, inside at most {most}");
        }
    }
}

#[test]
fn barks_have_contrast_and_differ() {
    let mut means = Vec::new();
    for name in bark_names() {
        let texture = bark_sized(name, 128).unwrap();
        let light: Vec<f32> = texture
            .pixels
            .chunks_exact(4)
            .map(|p| (f32::from(p[0]) + f32::from(p[1]) + f32::from(p[2])) / 3.0)
            .collect();
        let mean = light.iter().sum::<f32>() / light.len() as f32;
        let variance = light.iter().map(|l| (l - mean) * (l - mean)).sum::<f32>();
        let deviation = (variance / light.len() as f32).sqrt();
        assert!((4.0..70.0).contains(&deviation), "{name} {deviation}");
        means.push((*name, mean));
    }
    let of = |name| means.iter().find(|(known, _)| *known == name).unwrap().1;
    assert!(of("birch") > of("smooth") && of("smooth") > of("oak"), "{means:?}");
}

#[test]
fn leaves_stand_on_the_bottom_and_leave_the_border_free() {
    for name in leaf_names() {
        let LeafTexture { texture, width, petiole } = leaf(name).unwrap();
        let n = texture.width as usize;
        assert_eq!((texture.height as usize, texture.pixels.len()), (n, 4 * n * n));
        assert!((0.04..2.0).contains(&width) && (0.0..0.6).contains(&petiole), "{name}");
        let alpha = |x: usize, y: usize| pixel(&texture, x, y)[3];
        assert!(alpha(n / 2, n - 1) > 127, "{name} has no base");
        for i in 0..n {
            for k in 0..2 {
                assert_eq!(alpha(i, k), 0, "{name} touches the top");
                assert_eq!(alpha(k, i), 0, "{name} touches the left side");
                assert_eq!(alpha(n - 1 - k, i), 0, "{name} touches the right side");
                if i.abs_diff(n / 2) > n / 10 {
                    assert_eq!(alpha(i, n - 1 - k), 0, "{name} touches the bottom");
                }
            }
        }
        // The apex reaches the top of the card, so that sizes mean what they say.
        let top = (0..n).find(|&y| (0..n).any(|x| alpha(x, y) > 127)).unwrap();
        assert!(top < n / 24, "{name} starts at {top}");
    }
}

/// Share of pixels an alpha test at 0.5 keeps on mip level `level`.
fn coverage(texture: &Texture, level: usize) -> f32 {
    let n = texture.width as usize;
    let block = 1 << level;
    let mut kept = 0;
    for y in 0..n / block {
        for x in 0..n / block {
            let sum: usize = (0..block * block)
                .map(|k| {
                    usize::from(pixel(texture, x * block + k % block, y * block + k / block)[3])
                })
                .sum();
            kept += usize::from(2 * sum > 255 * block * block);
        }
    }
    kept as f32 / (n / block * (n / block)) as f32
}

#[test]
fn leaves_cover_a_plausible_share_and_survive_mip_maps() {
    for name in leaf_names() {
        let texture = leaf(name).unwrap().texture;
        let full = coverage(&texture, 0);
        assert!((0.2..0.85).contains(&full), "{name} covers {full}");
        for level in 1..5 {
            let left = coverage(&texture, level);
            assert!(left > 0.6 * full, "{name}: {left} of {full} left on level {level}");
        }
    }
}

#[test]
fn transparent_pixels_carry_the_colour_of_their_neighbours() {
    for name in leaf_names() {
        let texture = leaf(name).unwrap().texture;
        let n = texture.width as usize;
        let (mut sum, mut count, mut worst) = (0.0, 0, 0.0_f32);
        for y in 0..n {
            for x in 0..n - 1 {
                let (a, b) = (pixel(&texture, x, y), pixel(&texture, x + 1, y));
                if (a[3] == 0) != (b[3] == 0) {
                    let step = difference(a, b);
                    sum += step;
                    count += 1;
                    worst = worst.max(step);
                }
                assert_ne!([a[0], a[1], a[2]], [0; 3], "{name} has black at {x}, {y}");
            }
        }
        let mean = sum / count as f32;
        assert!(mean < 10.0 && worst < 90.0, "{name}: mean {mean}, worst {worst}");
    }
}

#[test]
fn the_same_bytes_with_one_and_two_threads() {
    let all = |threads: usize| -> Vec<Vec<u8>> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let barks = bark_names().iter().map(|name| bark_sized(name, 96).unwrap().pixels);
            let leaves = leaf_names().iter().map(|name| leaf_sized(name, 96).unwrap());
            barks.chain(leaves.map(|leaf| leaf.texture.pixels)).collect()
        })
    };
    let once = all(1);
    assert_eq!(once, all(2));
    assert_eq!(once, all(1));
}

#[test]
fn the_bytes_of_a_texture_never_change_by_accident() {
    // "Same name, other picture" is a change users must be told of (CHANGELOG).
    let hash = |pixels: &[u8]| {
        pixels.iter().fold(0xcbf2_9ce4_8422_2325_u64, |hash, &byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        })
    };
    let found = [
        hash(&bark_sized("oak", 64).unwrap().pixels),
        hash(&bark_sized("birch", 64).unwrap().pixels),
        hash(&leaf_sized("maple", 64).unwrap().texture.pixels),
        hash(&leaf_sized("birch-cluster", 64).unwrap().texture.pixels),
    ];
    let known = [
        0xeb63_8a36_ee4e_3623,
        0xa8d8_22f5_7087_4c2e,
        0xb3ac_f8d0_d72d_95fb,
        0x2b6d_c42b_fdd1_e9d1,
    ];
    assert_eq!(found, known, "{found:#x?}");
}

#[test]
fn every_size_works_or_names_its_range() {
    for size_px in [16, 17, 31, 33, 100] {
        for name in bark_names() {
            assert_eq!(bark_sized(name, size_px).unwrap().width, size_px);
        }
        for name in leaf_names() {
            assert_eq!(leaf_sized(name, size_px).unwrap().texture.height, size_px);
        }
    }
    for size_px in [0, 15, 4097, u32::MAX] {
        for error in [
            bark_sized("oak", size_px).unwrap_err(),
            leaf_sized("oak", size_px).unwrap_err(),
            bark_with(&BarkStyle::default(), size_px).unwrap_err(),
            leaf_with(&LeafShape::default(), size_px).unwrap_err(),
        ] {
            assert!(
                matches!(error, MeshError::Parameter(error) if error.field == "size_px" && error.max == 4096.0)
            );
        }
    }
}

#[test]
fn an_unknown_name_gets_the_known_ones() {
    for (what, error) in [
        ("bark", bark("plastic").unwrap_err()),
        ("bark", bark_style("plastic").unwrap_err()),
        ("leaf kind", leaf("").unwrap_err()),
        ("leaf kind", leaf_shape("Oak").unwrap_err()),
    ] {
        let MeshError::Unknown { what: found, known, .. } = error else {
            panic!("{error}");
        };
        assert_eq!(found, what);
        assert!(known.starts_with("oak, "), "{known}");
    }
}

#[test]
fn rows_are_valid_and_bad_ones_name_the_field() {
    for name in bark_names() {
        bark_style(name).unwrap().validate().unwrap();
    }
    for name in leaf_names() {
        leaf_shape(name).unwrap().validate().unwrap();
    }
    let bark = BarkStyle { warp: f32::NAN, ..Default::default() };
    assert!(matches!(
        bark_with(&bark, 64).unwrap_err(),
        MeshError::Parameter(error) if error.field == "warp"
    ));
    let leaf = LeafShape { petiole: 0.9, ..Default::default() };
    assert!(matches!(
        leaf_with(&leaf, 64).unwrap_err(),
        MeshError::Parameter(error) if error.field == "petiole"
    ));
}

#[test]
fn odd_shapes_are_drawn_without_harm() {
    let point = LeafShape { outline: vec![[0.0; 3]; 2].into(), ..Default::default() };
    let crossing = LeafShape {
        outline: vec![[0.0, 1.0, 0.0], [2.0, -1.0, 0.0], [0.0, 2.0, 0.0], [1.0, 0.0, 1.0]].into(),
        teeth: Teeth { count: 100, depth: 0.2, sharpness: 1.0, double: true },
        petiole: 0.0,
        spray: Some(Spray { leaves: 1, shoots: 32, jitter: 1.0, ..Default::default() }),
        ..Default::default()
    };
    for shape in [point, crossing] {
        let leaf = leaf_with(&shape, 48).unwrap();
        assert!(leaf.width.is_finite() && leaf.width > 0.0);
    }
}

#[test]
fn autumn_turns_the_colour() {
    let summer = leaf_shape("maple").unwrap();
    let autumn = LeafShape { style: summer.style.autumn(1.0), ..summer.clone() };
    let redness = |shape: &LeafShape| {
        let texture = leaf_with(shape, 64).unwrap().texture;
        let middle = pixel(&texture, 40, 20);
        i32::from(middle[0]) - i32::from(middle[1])
    };
    assert!(redness(&summer) < 0 && redness(&autumn) > 40);
    assert_eq!(summer.style.autumn(f32::NAN), summer.style);
}
