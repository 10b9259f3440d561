//! Textures from PNG and JPEG files, and to PNG.

use crate::error::{MeshError, Result};
use crate::mesh::Texture;
use image::{DynamicImage, ExtendedColorType, ImageDecoder, ImageEncoder, ImageReader};
use std::path::Path;
use tree_core::{CoreError, Limits, Resource, file};

impl Texture {
    /// Reads a PNG or JPEG file, recognised by its content. The texture is named after the file; a
    /// photograph is turned upright as its camera noted.
    ///
    /// # Errors
    /// [`MeshError::Core`] when the file cannot be read, [`MeshError::Limit`] when the file is larger
    /// than [`Limits::input_bytes`] or the picture than [`Limits::pixels`], before it is decoded, and
    /// [`MeshError::Image`] when it is no such picture.
    pub fn open(path: impl AsRef<Path>, limits: &Limits) -> Result<Self> {
        let path = path.as_ref();
        let bytes = file::read_bytes(path, limits).map_err(|error| match error {
            CoreError::Limit(limit) => MeshError::Limit(limit),
            other => other.into(),
        })?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        Self::decode(&name, &bytes, limits)
    }

    /// Decodes a PNG or JPEG file held in memory.
    ///
    /// # Errors
    /// As [`Texture::open`].
    pub fn decode(name: &str, bytes: &[u8], limits: &Limits) -> Result<Self> {
        let failed = |source| MeshError::Image { name: name.into(), source };
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
        Ok(Self {
            name: name.into(),
            width: pixels.width(),
            height: pixels.height(),
            pixels: pixels.into_raw(),
        })
    }

    /// The texture as a PNG file in memory.
    ///
    /// # Errors
    /// [`MeshError::Texture`] when the pixels do not fill width and height, [`MeshError::Image`] when
    /// the encoder fails.
    pub fn to_png(&self) -> Result<Vec<u8>> {
        self.check()?;
        let mut bytes = Vec::new();
        image::codecs::png::PngEncoder::new(&mut bytes)
            .write_image(&self.pixels, self.width, self.height, ExtendedColorType::Rgba8)
            .map_err(|source| MeshError::Image { name: self.name.clone(), source })?;
        Ok(bytes)
    }

    /// Writes the texture as a PNG file, whole or not at all.
    ///
    /// # Errors
    /// As [`Texture::to_png`], and [`MeshError::Core`] when the file cannot be written.
    pub fn save_png(&self, path: impl AsRef<Path>) -> Result<()> {
        let (path, png) = (path.as_ref(), self.to_png()?);
        file::write_atomic(path, |writer| {
            writer.write_all(&png).map_err(|error| CoreError::io(path, error).into())
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texture() -> Texture {
        Texture {
            name: "t".into(),
            width: 2,
            height: 1,
            pixels: vec![255, 0, 0, 255, 0, 10, 20, 0],
        }
    }

    #[test]
    fn a_png_comes_back_bit_for_bit() {
        let folder = std::env::temp_dir().join(format!("tree-mesh-png-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let path = folder.join("t.png");
        texture().save_png(&path).unwrap();
        assert_eq!(Texture::open(&path, &Limits::default()).unwrap(), texture());
        assert!(texture().save_png(folder.join("none/t.png")).is_err());
        let mut limits = Limits { pixels: 1, ..Limits::default() };
        let error = Texture::open(&path, &limits).unwrap_err();
        assert!(matches!(error, MeshError::Limit(_)), "{error}");
        limits.input_bytes = 1;
        assert!(matches!(Texture::open(&path, &limits), Err(MeshError::Limit(_))));
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn a_source_without_end_is_refused() {
        let limits = Limits { input_bytes: 1000, ..Limits::default() };
        let error = Texture::open("/dev/zero", &limits).unwrap_err();
        assert!(matches!(error, MeshError::Limit(_)), "{error}");
    }

    #[test]
    fn what_is_no_picture_is_refused() {
        let limits = Limits::default();
        let png = texture().to_png().unwrap();
        for bytes in [&b""[..], b"hello", &png[..20], &png[..png.len() - 20]] {
            assert!(matches!(Texture::decode("t", bytes, &limits), Err(MeshError::Image { .. })));
        }
        assert!(matches!(
            Texture::open("/no/such/file.png", &limits),
            Err(MeshError::Core(CoreError::Io { .. }))
        ));
        let mut short = texture();
        short.pixels.pop();
        assert!(matches!(short.to_png(), Err(MeshError::Texture { .. })));
    }
}
