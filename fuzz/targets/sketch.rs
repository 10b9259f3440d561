#![no_main]

use tree_model::sketch::clean::{CleanParams, clean};
use tree_model::sketch::{Drawing, read};

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    let text = String::from_utf8_lossy(data);
    let mut drawings: Vec<Drawing> = read::from_svg(&text).into_iter().collect();
    drawings.extend(read::from_json(&text));
    drawings.extend(read::from_ndjson(&text).unwrap_or_default());
    for drawing in drawings.iter().take(4) {
        if let Ok(written) = read::to_json(drawing) {
            assert_eq!(&read::from_json(&written).expect("what was written"), drawing);
        }
        // Strokes are compared with each other; a drawing has tens.
        if drawing.strokes.len() > 50 {
            continue;
        }
        if let Ok(cleaned) = clean(drawing, &CleanParams::default(), &tree_fuzz::control()) {
            assert!(cleaned.plan.positions().iter().all(|p| p.is_finite()));
            assert!(cleaned.crown.iter().flatten().all(|p| p.is_finite()));
        }
    }
});
