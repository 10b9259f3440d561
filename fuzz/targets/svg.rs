#![no_main]

use tree_core::glam::Vec3;
use tree_model::path::{Profile, ProfileOptions};

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    let text = String::from_utf8_lossy(data);
    if let Ok(profile) = Profile::from_svg(&text, &ProfileOptions::default()) {
        let _ = profile.volume(Vec3::ZERO);
    }
});
