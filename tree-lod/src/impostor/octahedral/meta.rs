//! What a shader needs to know about an octahedral impostor.

use crate::error::{LodError, Result, check_range};
use glam::Vec3;

/// Numbers that go with the two pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meta {
    /// Views along each side of the square of directions, 2 to 64.
    pub grid: u32,
    /// Whether only the upper hemisphere is there.
    pub hemi: bool,
    /// Side of the picture of colours in texels.
    pub side: u32,
    /// Side of a view in texels of the picture of colours, gutter included.
    pub tile: u32,
    /// Side of the picture of normals and depths: `side`, or half of it.
    pub detail_side: u32,
    /// Middle of the tree in metres.
    pub center: Vec3,
    /// Radius of the ball around it in metres.
    pub radius: f32,
    /// Half the width of a view in metres, a little more than `radius`. Depths reach from −`reach` to
    /// `reach`, towards the viewer.
    pub reach: f32,
}

impl Meta {
    /// Checks that the numbers fit each other.
    ///
    /// # Errors
    /// [`LodError::Parameter`], naming the field, or [`LodError::Impostor`].
    pub fn validate(&self) -> Result<()> {
        check_range("meta.grid", self.grid.into(), 2.0, 64.0)?;
        check_range("meta.side", self.side.into(), 64.0, 16_384.0)?;
        check_range("meta.tile", self.tile.into(), 16.0, f64::from(self.side / self.grid))?;
        if self.detail_side != self.side && self.detail_side != self.side / 2 {
            return Err(LodError::Impostor("meta.detail_side must be meta.side or half of it"));
        }
        for v in self.center.to_array() {
            check_range("meta.center", v.into(), -1e6, 1e6)?;
        }
        check_range("meta.radius", self.radius.into(), 1e-6, 1e6)?;
        check_range(
            "meta.reach",
            self.reach.into(),
            self.radius.into(),
            4.0 * f64::from(self.radius),
        )
    }

    /// Metres of a texel.
    #[must_use]
    pub fn texel(&self) -> f32 {
        2.0 * self.reach / self.tile as f32
    }

    /// As JSON, to be stored beside the pictures. Numbers are written so that they are read as the same
    /// bits:
    ///
    /// ```json
    /// { "kind": "octahedral", "grid": 12, "hemi": true, "side": 2048, "tile": 170,
    ///   "detail_side": 2048, "center": [0, 5, 0], "radius": 6, "reach": 6.1 }
    /// ```
    #[must_use]
    pub fn to_json(&self) -> String {
        let Self { grid, hemi, side, tile, detail_side, center, radius, reach } = self;
        let [x, y, z] = center.to_array();
        format!(
            "{{ \"kind\": \"octahedral\", \"grid\": {grid}, \"hemi\": {hemi}, \"side\": {side}, \
             \"tile\": {tile},\n  \"detail_side\": {detail_side}, \"center\": [{x}, {y}, {z}], \
             \"radius\": {radius}, \"reach\": {reach} }}\n"
        )
    }
}
