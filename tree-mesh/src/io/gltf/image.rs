//! Pictures of a document that is read, each decoded once and only when something shows it.

use super::accessor::Columns;
use super::buffer::resource;
use crate::error::{MeshError, Result};
use crate::io::import::{Beside, ImportReport, Note, is_missing};
use crate::mesh::Texture;
use std::path::Path;
use std::sync::Arc;
use tree_core::{Control, Limits};

/// Decoded pictures, and what may still be decoded.
pub(super) struct Images {
    /// By number of the image; `Some(None)` for those that cannot be had.
    known: Vec<Option<Option<Arc<Texture>>>>,
    n_pixels: u64,
}

impl Images {
    pub(super) fn new(n: usize) -> Self {
        Self { known: vec![None; n], n_pixels: 0 }
    }

    /// The picture of a texture, `None` with a note when it cannot be had.
    ///
    /// # Errors
    /// [`MeshError::Limit`] when all pictures together have more than [`Limits::pixels`],
    /// [`MeshError::External`] for a file that lies elsewhere.
    pub(super) fn texture(
        &mut self,
        columns: Columns<'_>,
        texture: usize,
        beside: &mut Beside<'_>,
        report: &mut ImportReport,
        control: &Control,
    ) -> Result<Option<Arc<Texture>>> {
        let source = columns.document.textures.get(texture).and_then(|texture| texture.source);
        let Some(number) = source else {
            report.note(Note::TextureUnsupported);
            return Ok(None);
        };
        if let Some(Some(known)) = self.known.get(number) {
            return Ok(known.clone());
        }
        let loaded = self.load(columns, number, beside, report, control)?;
        if let Some(place) = self.known.get_mut(number) {
            *place = Some(loaded.clone());
        }
        Ok(loaded)
    }

    fn load(
        &mut self,
        columns: Columns<'_>,
        number: usize,
        beside: &mut Beside<'_>,
        report: &mut ImportReport,
        control: &Control,
    ) -> Result<Option<Arc<Texture>>> {
        let Some(image) = columns.document.images.get(number) else {
            report.note(Note::ExternalMissing);
            return Ok(None);
        };
        let owned;
        let bytes = match (&image.uri, image.buffer_view) {
            (_, Some(view)) => columns.buffers.view(columns.document, view)?.0,
            (Some(uri), None) => {
                if !uri.starts_with("data:") && !beside.allowed() {
                    report.note(Note::ExternalRefused);
                    return Ok(None);
                }
                match resource(uri, &format!("image {number}"), beside) {
                    Ok(bytes) => owned = bytes,
                    Err(error) if is_missing(&error) => {
                        report.note(Note::ExternalMissing);
                        return Ok(None);
                    }
                    Err(error) => return Err(error),
                }
                &owned
            }
            (None, None) => {
                report.note(Note::TextureUnsupported);
                return Ok(None);
            }
        };
        let stem = |uri: &String| {
            let stem = Path::new(uri).file_stem().filter(|_| !uri.starts_with("data:"));
            stem.map(|stem| stem.to_string_lossy().into_owned())
        };
        let name = image.name.clone().filter(|name| !name.is_empty());
        let name = name.or_else(|| image.uri.as_ref().and_then(stem));
        let name = name.unwrap_or_else(|| format!("image {number}"));
        control.check()?;
        let left = control.limits.pixels.saturating_sub(self.n_pixels);
        let limits = Limits { pixels: left, ..control.limits };
        match Texture::decode(&name, bytes, &limits) {
            Ok(texture) => {
                self.n_pixels += u64::from(texture.width) * u64::from(texture.height);
                report.n_textures += 1;
                Ok(Some(Arc::new(texture)))
            }
            Err(MeshError::Image { .. }) => {
                report.note(Note::TextureUnreadable);
                Ok(None)
            }
            Err(error) => Err(error),
        }
    }
}
