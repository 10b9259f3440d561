#![no_main]

use tree_core::Control;
use tree_core::glam::{Vec2, Vec3};
use tree_model::particle::attractor::{StrokeParams, from_strokes, strokes_from_svg};
use tree_model::path::{Profile, ProfileOptions};

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    let text = String::from_utf8_lossy(data);
    if let Ok(profile) = Profile::from_svg(&text, &ProfileOptions::default()) {
        let _ = profile.volume(Vec3::ZERO);
    }
    let picture = Vec2::new(64.0, 48.0);
    if let Ok(strokes) = strokes_from_svg(&text, picture) {
        assert!(!strokes.is_empty(), "a drawing without strokes is an error");
        // Joining compares all strokes with each other; a drawing has tens.
        if strokes.len() <= 50 && strokes.iter().map(Vec::len).sum::<usize>() <= 1000 {
            let base = Vec2::new(32.0, 48.0);
            let _ = from_strokes(&strokes, base, &StrokeParams::default(), &Control::default());
        }
    }
});
