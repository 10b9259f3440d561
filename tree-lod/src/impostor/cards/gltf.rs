//! Cards in glTF 2.0.

use super::{Cards, PLANES};
use crate::error::{Result, check_range};
use std::path::Path;
use tree_mesh::io::gltf::{self, Attribute, GlbOptions, Level};

impl Cards {
    /// The planes of some boxes as a GLB file: the atlas as texture, alpha-tested, two-sided, and for each
    /// vertex what the shader needs to weigh planes. Programs that do not know them draw all planes.
    ///
    /// | attribute | values |
    /// |---|---|
    /// | `_TREE_CENTER` | middle of the box in metres, number of the plane (0 to 5) |
    /// | `_TREE_HALF` | half sides of the box in metres, number of the box |
    /// | `_TREE_TURN` | quaternion x, y, z, w that turns the box's axes into those of the tree |
    ///
    /// # Errors
    /// [`LodError::Impostor`](crate::LodError::Impostor) when there is no such box;
    /// [`LodError::Parameter`](crate::LodError::Parameter) for [`GlbOptions::quantize`]: the shader needs
    /// positions in metres; [`LodError::Mesh`](crate::LodError::Mesh) from the writer.
    ///
    /// # Complexity
    /// O(boxes + pixels).
    pub fn to_glb(&self, boxes: &[u32], options: &GlbOptions) -> Result<Vec<u8>> {
        self.with_level(boxes, options, |levels| Ok(gltf::to_glb_levels(levels, options)?))
    }

    /// [`to_glb`](Self::to_glb) into a file, whole or not at all.
    ///
    /// # Errors
    /// The same, and those of the file system.
    ///
    /// # Complexity
    /// The same.
    pub fn write_glb(&self, boxes: &[u32], path: &Path, options: &GlbOptions) -> Result<()> {
        self.with_level(boxes, options, |levels| Ok(gltf::write_glb_levels(levels, path, options)?))
    }

    fn with_level<R>(
        &self,
        boxes: &[u32],
        options: &GlbOptions,
        write: impl FnOnce(&[Level<'_>]) -> Result<R>,
    ) -> Result<R> {
        check_range("quantize", u8::from(options.quantize).into(), 0.0, 0.0)?;
        let mesh = self.mesh(boxes)?;
        let (mut centers, mut halves, mut turns) = (Vec::new(), Vec::new(), Vec::new());
        for &number in boxes {
            let leaf_box = self.boxes.get(number)?;
            for plane in 0..PLANES {
                for _ in 0..4 {
                    centers.extend(leaf_box.center.extend(plane as f32).to_array());
                    halves.extend(leaf_box.half.extend(number as f32).to_array());
                    turns.extend(leaf_box.turn.to_array());
                }
            }
        }
        let attribute =
            |name: &str, values| Attribute { surface: 0, name: name.into(), components: 4, values };
        let attributes = [
            attribute("_TREE_CENTER", centers),
            attribute("_TREE_HALF", halves),
            attribute("_TREE_TURN", turns),
        ];
        write(&[Level { attributes: &attributes, ..(&mesh).into() }])
    }
}
