#![no_main]

use tree_mesh::Texture;

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    if let Ok(texture) = Texture::decode("fuzz", data, &tree_fuzz::limits()) {
        texture.check().expect("pixels fill the picture");
        assert!(texture.pixels.len() <= 4 << 16);
    }
});
