//! Pictures side by side, saved for pages.

use crate::Outcome;
use image::{DynamicImage, ImageFormat, Rgba, RgbaImage, imageops};
use std::path::Path;

/// Rows of pictures, each scaled to the row's height; what is left of a row is white.
pub(crate) fn rows(rows: &[Vec<DynamicImage>], height: u32) -> DynamicImage {
    let scaled = |picture: &DynamicImage| {
        let width = (picture.width() * height).div_ceil(picture.height().max(1));
        imageops::resize(&picture.to_rgba8(), width, height, imageops::FilterType::CatmullRom)
    };
    let rows: Vec<Vec<RgbaImage>> =
        rows.iter().map(|row| row.iter().map(scaled).collect()).collect();
    let width = rows.iter().map(|row| row.iter().map(RgbaImage::width).sum()).max().unwrap_or(1);
    let mut sheet = RgbaImage::from_pixel(width, height * rows.len() as u32, Rgba([255; 4]));
    for (y, row) in (0_u32..).zip(&rows) {
        let mut x = 0;
        for picture in row {
            imageops::overlay(&mut sheet, picture, i64::from(x), i64::from(y * height));
            x += picture.width();
        }
    }
    DynamicImage::ImageRgba8(sheet)
}

pub(crate) fn save(sheet: &DynamicImage, path: &Path) -> Outcome {
    match ImageFormat::from_path(path)? {
        // JPEG has no alpha; a grey picture is a third of the size.
        ImageFormat::Jpeg => sheet.to_rgb8().save(path)?,
        _ => sheet.to_luma8().save(path)?,
    }
    println!("{}", path.display());
    Ok(())
}
