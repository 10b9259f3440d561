//! Photographs from PNG and JPEG files, and photographs and mattes to PNG.

use super::{Matte, Photo};
use crate::error::{ModelError, Result};
use image::{DynamicImage, ExtendedColorType, ImageDecoder, ImageEncoder, ImageError, ImageReader};
use std::path::Path;
use tree_core::{CoreError, Limits, Resource, file};

impl Photo {
    /// Reads a PNG or JPEG file, recognised by its content. A photograph is turned upright as its camera
    /// noted.
    ///
    /// # Errors
    /// [`ModelError::Core`] when the file cannot be read, [`ModelError::Limit`] when the file is larger
    /// than [`Limits::input_bytes`] or the picture than [`Limits::pixels`], before it is decoded, and
    /// [`ModelError::Picture`] when it is no such picture.
    pub fn open(path: impl AsRef<Path>, limits: &Limits) -> Result<Self> {
        let path = path.as_ref();
        let bytes = file::read_bytes(path, limits).map_err(|error| match error {
            CoreError::Limit(limit) => ModelError::Limit(limit),
            other => other.into(),
        })?;
        Self::decode(&bytes, limits).map_err(|error| match error {
            ModelError::Picture { problem } => {
                ModelError::Picture { problem: format!("{}: {problem}", path.display()) }
            }
            other => other,
        })
    }

    /// Decodes a PNG or JPEG file held in memory.
    ///
    /// # Errors
    /// As [`Photo::open`].
    pub fn decode(bytes: &[u8], limits: &Limits) -> Result<Self> {
        let failed = |error: ImageError| ModelError::Picture {
            problem: format!("not a PNG or JPEG file that can be read: {error}"),
        };
        let reader = ImageReader::new(std::io::Cursor::new(bytes))
            .with_guessed_format()
            .map_err(|error| failed(error.into()))?;
        let mut decoder = reader.into_decoder().map_err(failed)?;
        let (width, height) = decoder.dimensions();
        limits.check(Resource::Pixels, u64::from(width) * u64::from(height))?;
        let orientation = decoder.orientation().map_err(failed)?;
        let mut picture = DynamicImage::from_decoder(decoder).map_err(failed)?;
        picture.apply_orientation(orientation);
        let pixels = picture.into_rgba8();
        let (width, height) = pixels.dimensions();
        Self::new(width, height, pixels.into_raw().as_chunks().0.to_vec())
    }

    /// The photograph as a PNG file in memory, with alpha.
    ///
    /// # Errors
    /// [`ModelError::Picture`] when the encoder fails.
    pub fn to_png(&self) -> Result<Vec<u8>> {
        encode(self.pixels().as_flattened(), self.width(), self.height(), ExtendedColorType::Rgba8)
    }

    /// Writes the photograph as a PNG file, whole or not at all.
    ///
    /// # Errors
    /// As [`Photo::to_png`], and [`ModelError::Core`] when the file cannot be written.
    pub fn save_png(&self, path: impl AsRef<Path>) -> Result<()> {
        save(path.as_ref(), &self.to_png()?)
    }
}

impl Matte {
    /// The matte as a PNG file in memory: grey, black for 0 and white for 1.
    ///
    /// # Errors
    /// [`ModelError::Picture`] when the encoder fails.
    pub fn to_png(&self) -> Result<Vec<u8>> {
        let grey: Vec<u8> = self.alpha().iter().map(|alpha| (alpha * 255.0 + 0.5) as u8).collect();
        encode(&grey, self.width(), self.height(), ExtendedColorType::L8)
    }

    /// Writes the matte as a PNG file, whole or not at all.
    ///
    /// # Errors
    /// As [`Matte::to_png`], and [`ModelError::Core`] when the file cannot be written.
    pub fn save_png(&self, path: impl AsRef<Path>) -> Result<()> {
        save(path.as_ref(), &self.to_png()?)
    }
}

fn encode(bytes: &[u8], width: u32, height: u32, color: ExtendedColorType) -> Result<Vec<u8>> {
    let mut png = Vec::new();
    image::codecs::png::PngEncoder::new(&mut png)
        .write_image(bytes, width, height, color)
        .map_err(|error| ModelError::Picture { problem: format!("cannot be written: {error}") })?;
    Ok(png)
}

fn save(path: &Path, png: &[u8]) -> Result<()> {
    file::write_atomic(path, |writer| {
        writer.write_all(png).map_err(|error| CoreError::io(path, error).into())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn photo() -> Photo {
        Photo::new(2, 1, vec![[255, 0, 0, 255], [0, 10, 20, 0]]).unwrap()
    }

    #[test]
    fn a_png_comes_back_bit_for_bit() {
        let folder = std::env::temp_dir().join(format!("tree-model-png-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let path = folder.join("t.png");
        photo().save_png(&path).unwrap();
        assert_eq!(Photo::open(&path, &Limits::default()).unwrap(), photo());
        assert!(photo().save_png(folder.join("none/t.png")).is_err());
        let limits = Limits { pixels: 1, ..Limits::default() };
        assert!(matches!(Photo::open(&path, &limits), Err(ModelError::Limit(_))));
        let limits = Limits { input_bytes: 1, ..Limits::default() };
        assert!(matches!(Photo::open(&path, &limits), Err(ModelError::Limit(_))));
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn a_matte_is_written_in_grey() {
        let matte = Matte::new(3, 1, vec![0.0, 0.2, 1.0]).unwrap();
        let read = Photo::decode(&matte.to_png().unwrap(), &Limits::default()).unwrap();
        assert_eq!(read.pixels(), [[0, 0, 0, 255], [51, 51, 51, 255], [255; 4]]);
    }

    #[test]
    fn what_is_no_picture_is_refused() {
        let limits = Limits::default();
        let png = photo().to_png().unwrap();
        for bytes in [&b""[..], b"hello", &png[..20], &png[..png.len() - 20]] {
            assert!(matches!(Photo::decode(bytes, &limits), Err(ModelError::Picture { .. })));
        }
        assert!(matches!(
            Photo::open("/no/such/file.png", &limits),
            Err(ModelError::Core(CoreError::Io { .. }))
        ));
    }
}
