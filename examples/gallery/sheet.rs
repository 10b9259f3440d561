//! Pictures side by side, saved for pages.

use crate::Outcome;
use image::{DynamicImage, ImageFormat, Rgba, RgbaImage, imageops};
use std::path::Path;

/// Pictures of one size, so many in a row.
pub(crate) fn tiles(pictures: &[DynamicImage], columns: usize) -> DynamicImage {
    let (width, height) = pictures.first().map_or((1, 1), |first| (first.width(), first.height()));
    let n_rows = pictures.len().div_ceil(columns) as u32;
    let white = Rgba([255; 4]);
    let mut sheet = RgbaImage::from_pixel(columns as u32 * width, n_rows * height, white);
    for (i, picture) in pictures.iter().enumerate() {
        let (x, y) = (i % columns * width as usize, i / columns * height as usize);
        imageops::overlay(&mut sheet, &picture.to_rgba8(), x as i64, y as i64);
    }
    DynamicImage::ImageRgba8(sheet)
}

/// Rows of pictures, each as high as it takes to be as wide as the sheet.
pub(crate) fn rows(rows: &[Vec<DynamicImage>], width: u32) -> DynamicImage {
    let rows: Vec<Vec<RgbaImage>> = rows.iter().map(|row| fitted(row, width)).collect();
    let high = |row: &[RgbaImage]| row.first().map_or(0, RgbaImage::height);
    let height = rows.iter().map(|row| high(row)).sum();
    let mut sheet = RgbaImage::from_pixel(width, height, Rgba([255; 4]));
    let mut y = 0;
    for row in &rows {
        let mut x = 0;
        for picture in row {
            imageops::overlay(&mut sheet, picture, x, y);
            x += i64::from(picture.width());
        }
        y += i64::from(high(row));
    }
    DynamicImage::ImageRgba8(sheet)
}

/// Pictures of one height that are together so wide.
fn fitted(row: &[DynamicImage], width: u32) -> Vec<RgbaImage> {
    let shape = |picture: &DynamicImage| picture.width() as f32 / picture.height().max(1) as f32;
    let height = width as f32 / row.iter().map(shape).sum::<f32>();
    let scaled = |picture: &DynamicImage| {
        let (wide, high) = ((height * shape(picture)).round() as u32, height.round() as u32);
        imageops::resize(&picture.to_rgba8(), wide, high, imageops::FilterType::CatmullRom)
    };
    row.iter().map(scaled).collect()
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
