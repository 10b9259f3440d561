//! What examples of pictures share.

use image::{RgbaImage, imageops};
use std::error::Error;
use tree_lod::preview::Picture;

/// Pictures of `tile` × `tile` pixels side by side.
pub(crate) fn sheet(
    pictures: &[Picture],
    columns: u32,
    tile: u32,
) -> Result<RgbaImage, Box<dyn Error>> {
    let rows = (pictures.len() as u32).div_ceil(columns);
    let mut sheet = RgbaImage::new(columns * tile, rows * tile);
    for (i, picture) in (0_u32..).zip(pictures) {
        let image = RgbaImage::from_raw(picture.width, picture.height, picture.pixels.clone())
            .ok_or("a picture with too few pixels")?;
        let (x, y) = (i % columns * tile, i / columns * tile);
        imageops::replace(&mut sheet, &image, i64::from(x), i64::from(y));
    }
    Ok(sheet)
}
