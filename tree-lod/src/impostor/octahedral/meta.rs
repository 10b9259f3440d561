//! What a shader needs to know about an octahedral impostor.

use crate::error::{LodError, Result, check_range};
use glam::{Vec2, Vec3};

/// Numbers that go with the two pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OctahedralMeta {
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
    /// Radius in metres of the upright cylinder around it, and a gutter more.
    pub wide: f32,
    /// Half the height in metres of that cylinder, and a gutter more.
    pub high: f32,
}

impl OctahedralMeta {
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
        let most = 2.0 * f64::from(self.radius);
        check_range("meta.wide", self.wide.into(), f64::MIN_POSITIVE, most)?;
        check_range("meta.high", self.high.into(), f64::MIN_POSITIVE, most)
    }

    /// Half width and half height in metres of a view from a direction with this y: what the cylinder
    /// fills.
    #[must_use]
    pub fn half(&self, y: f32) -> Vec2 {
        let level = (1.0 - y * y).max(0.0).sqrt();
        Vec2::new(self.wide, self.high * level + self.wide * y.abs())
    }

    /// Half the depth of the cylinder in metres, likewise.
    #[must_use]
    pub fn depth(&self, y: f32) -> f32 {
        let level = (1.0 - y * y).max(0.0).sqrt();
        self.wide * level + self.high * y.abs()
    }

    /// Metres of a texel: the largest of any view.
    #[must_use]
    pub fn texel(&self) -> f32 {
        2.0 * (self.wide * self.wide + self.high * self.high).sqrt() / self.tile as f32
    }

    /// As JSON, to be stored beside the pictures. Numbers are written so that they are read as the same
    /// bits:
    ///
    /// ```json
    /// { "kind": "octahedral", "grid": 12, "hemi": true, "side": 2048, "tile": 170,
    ///   "detail_side": 2048, "center": [0, 5, 0], "radius": 6,
    ///   "wide": 4.1, "high": 5.2 }
    /// ```
    #[must_use]
    pub fn to_json(&self) -> String {
        let Self { grid, hemi, side, tile, detail_side, center, radius, wide, high } = self;
        let [x, y, z] = center.to_array();
        format!(
            "{{ \"kind\": \"octahedral\", \"grid\": {grid}, \"hemi\": {hemi}, \"side\": {side}, \
             \"tile\": {tile},\n  \"detail_side\": {detail_side}, \"center\": [{x}, {y}, {z}], \
             \"radius\": {radius},\n  \"wide\": {wide}, \"high\": {high} }}\n"
        )
    }
}
