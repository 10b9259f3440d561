//! Pictures.

use crate::limits;
use tree_mesh::Texture;
use tree_model::particle::Photo;
use tree_model::particle::matting::{Trimap, alpha_of};

/// Textures: pixels fill the picture.
pub fn picture(data: &[u8]) {
    if let Ok(texture) = Texture::decode("fuzz", data, &limits()) {
        texture.check().expect("pixels fill the picture");
        assert!(texture.pixels.len() <= 4 << 16);
    }
}

/// Photographs: what was read gives a matte or a typed error, and comes back as it was.
pub fn photo(data: &[u8]) {
    let Ok(photo) = Photo::decode(data, &limits()) else { return };
    let n = photo.width() as usize * photo.height() as usize;
    assert!(photo.pixels().len() == n && n <= 1 << 16);
    if let Ok(matte) = alpha_of(&photo) {
        assert!(matte.alpha().len() == n && matte.area() > 0.0);
        matte.to_png().expect("a matte");
    }
    let _ = Trimap::from_photo(&photo);
    let again = Photo::decode(&photo.to_png().expect("a photograph"), &limits());
    assert!(again.is_ok_and(|again| again == photo), "a PNG comes back as it was");
}
