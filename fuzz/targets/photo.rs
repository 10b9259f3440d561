#![no_main]

use tree_model::particle::Photo;
use tree_model::particle::matting::{Trimap, alpha_of};

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    let Ok(photo) = Photo::decode(data, &tree_fuzz::limits()) else { return };
    let n = photo.width() as usize * photo.height() as usize;
    assert!(photo.pixels().len() == n && n <= 1 << 16);
    if let Ok(matte) = alpha_of(&photo) {
        assert!(matte.alpha().len() == n && matte.area() > 0.0);
        matte.to_png().expect("a matte");
    }
    let _ = Trimap::from_photo(&photo);
    let again = Photo::decode(&photo.to_png().expect("a photograph"), &tree_fuzz::limits());
    assert!(again.is_ok_and(|again| again == photo), "a PNG comes back as it was");
});
