//! What pictures and files may show.

use super::*;

#[test]
fn one_clean_photograph_gives_a_tree_without_warnings() {
    let made = sound(vec![shot(lollipop())]);
    assert_eq!(made.report.warnings(), Vec::<String>::new());
}

#[test]
fn views_may_be_of_different_sizes() {
    let small = matte_of(32, 48, |x, y| in_crown(2.0 * x, 2.0 * y) || in_trunk(2.0 * x, 2.0 * y));
    let wide =
        matte_of(200, 120, |x, y| in_crown(x - 68.0, y - 12.0) || in_trunk(x - 68.0, y - 12.0));
    let shots = [lollipop(), small, wide].map(shot).into_iter().enumerate();
    sound(shots.map(|(i, shot)| Shot { placing: Placing::at(2.1 * i as f32), ..shot }).collect());
}

#[test]
fn identical_and_opposite_views_give_a_tree() {
    sound(vec![shot(lollipop()), shot(lollipop())]);
    let back = Shot::new(lollipop().mirrored(), None, std::f32::consts::PI);
    sound(vec![shot(lollipop()), back]);
}

#[test]
fn empty_and_full_pictures_are_refused_with_advice() {
    for (full, says) in [(false, "no pixel is covered"), (true, "all pixels are covered")] {
        let bad = matte_of(WIDTH, HEIGHT, |_, _| full);
        let text = error(vec![shot(lollipop()), shot(bad)]);
        assert!(
            text.contains("views[1]") && text.contains(says) && text.contains("matt"),
            "{text}"
        );
    }
}

#[test]
fn tiny_pictures_are_refused() {
    for (width, height) in [(1, 1), (1, 2), (2, 1), (40, 1), (1, 40), (2, 2), (3, 3)] {
        for covered in [0, 1] {
            let matte = matte_of(width, height, |x, _| covered == 1 && x < width as f32 - 0.5);
            match tree(vec![shot(matte)]) {
                Ok(made) => assert_sound(&made),
                Err(error) => assert!(matches!(error, ModelError::View { view: 0, .. }), "{error}"),
            }
        }
    }
    let one = Matte::new(1, 1, vec![1.0]).unwrap();
    assert!(error(vec![shot(one)]).contains("views[0]"));
}

#[test]
fn a_crown_without_a_trunk_gives_a_tree_and_a_warning() {
    warns(&sound(vec![shot(matte_of(WIDTH, HEIGHT, in_crown))]), "no bare trunk");
}

#[test]
fn disconnected_crowns_give_a_tree_and_a_warning() {
    let tufts = |x: f32, y: f32| in_trunk(x, y) || (in_crown(x, y) && (y as u32) % 20 < 8);
    warns(&sound(vec![shot(matte_of(WIDTH, HEIGHT, tufts))]), "parts");
    let two = |x: f32, y: f32| {
        let beside =
            libm::hypotf(x - 10.0, y - 12.0) < 7.0 || libm::hypotf(x - 54.0, y - 12.0) < 7.0;
        beside || (in_trunk(x, y) && y > 50.0)
    };
    warns(&sound(vec![shot(matte_of(WIDTH, HEIGHT, two))]), "parts");
}

#[test]
fn lines_noise_haze_and_cut_off_trees_give_a_tree() {
    let noise = |x: f32, y: f32| (x as u32 * 7919 + y as u32 * 104_729) % 97 < 9;
    let cases: [(&str, Matte); 7] = [
        ("line", matte_of(WIDTH, HEIGHT, |x, y| x as u32 == 30 && y > 5.0)),
        ("level line", matte_of(WIDTH, HEIGHT, |_, y| (40.0..43.0).contains(&y))),
        ("noise", matte_of(WIDTH, HEIGHT, noise)),
        ("leaning line", matte_of(WIDTH, HEIGHT, |x, y| (x - 0.6 * y).abs() < 1.0)),
        ("cut off", matte_of(40, 50, |x, y| in_crown(x + 20.0, y + 20.0) || in_trunk(x, y))),
        ("all but a pixel", matte_of(WIDTH, HEIGHT, |x, y| x > 1.0 || y > 1.0)),
        (
            "haze",
            Matte::new(
                WIDTH,
                HEIGHT,
                lollipop().alpha().iter().map(|&alpha| 0.32 * alpha + 0.01).collect(),
            )
            .unwrap(),
        ),
    ];
    for (name, matte) in cases {
        let made = tree(vec![shot(matte)]).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_sound(&made);
    }
    // Too little for the threshold, with a view imagined or without.
    let dots = matte_of(WIDTH, HEIGHT, |x, y| {
        (x as u32).is_multiple_of(9) && (y as u32).is_multiple_of(9)
    });
    let text = error(vec![shot(dots)]);
    assert!(text.contains("views[0]") && text.contains("threshold"), "{text}");
    // A single pixel is no tree.
    assert!(
        error(vec![shot(matte_of(WIDTH, HEIGHT, |x, y| x < 1.0 && y < 1.0))]).contains("views[0]")
    );
}

#[test]
fn views_that_contradict_each_other_are_named() {
    let bush = matte_of(WIDTH, HEIGHT, |x, y| y > 80.0 && (10.0..60.0).contains(&x));
    let side = Shot { placing: Placing::at(1.5), ..shot(bush) };
    let made = sound(vec![shot(lollipop()), side]);
    assert!(!made.report.warnings().is_empty());
}

#[test]
fn broken_files_are_refused() {
    let n = 20 * 30;
    let pixels: Vec<[u8; 4]> = (0..n).map(|i| [i as u8, (i * 7) as u8, 90, 255]).collect();
    let png = Photo::new(20, 30, pixels).unwrap().to_png().unwrap();
    let mut jpeg = Vec::new();
    let grey = image::GrayImage::from_fn(20, 30, |x, y| image::Luma([(x * y) as u8]));
    image::codecs::jpeg::JpegEncoder::new(&mut jpeg).encode_image(&grey).unwrap();
    let limits = Limits { pixels: 1 << 20, ..Limits::default() };
    let judge = |bytes: &[u8], what: &str| match Photo::decode(bytes, &limits) {
        // Some damage leaves a picture.
        Ok(photo) => assert_eq!(
            photo.pixels().len(),
            photo.width() as usize * photo.height() as usize,
            "{what}"
        ),
        Err(ModelError::Picture { .. } | ModelError::Limit(_)) => {}
        Err(error) => panic!("{what}: {error}"),
    };
    for (name, whole) in [("PNG", &png), ("JPEG", &jpeg)] {
        assert!(Photo::decode(whole, &limits).is_ok());
        for length in 0..whole.len() {
            judge(&whole[..length], &format!("{name} of {length} bytes"));
            for value in [0, 0x7f, 0xff, whole[length] ^ 0x10] {
                let mut broken = whole.clone();
                broken[length] = value;
                judge(&broken, &format!("{name} with byte {length} as {value}"));
            }
        }
        // Half a picture is none.
        assert!(matches!(
            Photo::decode(&whole[..whole.len() / 2], &limits),
            Err(ModelError::Picture { .. })
        ));
    }
    let mut state = 1_u32;
    for length in 0..300 {
        let bytes = |_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        };
        let mut random: Vec<u8> = (0..length).map(bytes).collect();
        judge(&random, "random bytes");
        random.splice(0..0, png[..33].iter().copied());
        judge(&random, "random bytes behind a header");
    }
}
