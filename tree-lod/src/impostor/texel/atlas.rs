//! Tiles side by side.

use super::bake::Tile;
use crate::error::{Result, check_range};
use crate::preview::{Picture, Srgb};
use glam::Vec3;
use tree_core::{Control, Resource};

/// Widest atlas that engines take everywhere.
pub(crate) const SIDE_MAX: f64 = 16_384.0;

/// Where tiles of one size lie in an atlas: row by row from the top left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Grid {
    pub(crate) columns: u32,
    pub(crate) rows: u32,
    /// Side of a tile in texels, gutters included.
    pub(crate) tile: u32,
    /// Side of the picture; what tiles leave over stays empty.
    pub(crate) width: u32,
    pub(crate) height: u32,
}

/// Pictures of all tiles.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Atlas {
    pub(crate) grid: Grid,
    /// sRGB colour and alpha.
    pub(crate) color: Picture,
    /// Normal, −1 to 1 as 0 to 255, and depth.
    pub(crate) detail: Picture,
}

impl Grid {
    /// About as wide as high.
    ///
    /// # Errors
    /// [`LodError::Parameter`](crate::LodError::Parameter) when it would be wider than
    /// [`SIDE_MAX`].
    pub(crate) fn square(n: usize, tile: u32) -> Result<Self> {
        let columns = (n.max(1) as f64).sqrt().ceil();
        check_range("atlas.width", columns * f64::from(tile), 1.0, SIDE_MAX)?;
        let columns = columns as u32;
        let rows = (n.max(1) as u32).div_ceil(columns);
        Ok(Self { columns, rows, tile, width: columns * tile, height: rows * tile })
    }

    /// First column and row of a tile.
    pub(crate) fn origin(&self, tile: usize) -> [u32; 2] {
        [tile as u32 % self.columns * self.tile, tile as u32 / self.columns * self.tile]
    }
}

impl Atlas {
    /// Empty pictures.
    ///
    /// # Errors
    /// [`LodError::Limit`](crate::LodError::Limit) over the limit of pixels, of both pictures.
    pub(crate) fn new(grid: Grid, control: &Control) -> Result<Self> {
        let n = u64::from(grid.width) * u64::from(grid.height);
        control.limits.check(Resource::Pixels, 2 * n)?;
        let empty =
            || Picture { width: grid.width, height: grid.height, pixels: vec![0; 4 * n as usize] };
        Ok(Self { grid, color: empty(), detail: empty() })
    }

    /// Writes a tile.
    pub(crate) fn put(&mut self, number: usize, tile: &Bytes) {
        let [left, top] = self.grid.origin(number).map(|t| t as usize);
        let (line, width) = (4 * self.grid.tile as usize, self.grid.width as usize);
        for (picture, bytes) in
            [(&mut self.color.pixels, &tile.color), (&mut self.detail.pixels, &tile.detail)]
        {
            for (row, from) in bytes.chunks_exact(line).enumerate() {
                let at = 4 * ((top + row) * width + left);
                picture[at..at + line].copy_from_slice(from);
            }
        }
    }
}

/// A tile as it is in an atlas.
pub(crate) struct Bytes {
    /// sRGB colour and alpha.
    pub(crate) color: Vec<u8>,
    /// Normal and depth.
    pub(crate) detail: Vec<u8>,
}

impl Tile {
    /// As bytes; depths from −`reach` to `reach` become 0 to 255.
    pub(crate) fn bytes(&self, reach: f32, srgb: &Srgb) -> Bytes {
        let n = 4 * self.alpha.len();
        let mut bytes = Bytes { color: Vec::with_capacity(n), detail: Vec::with_capacity(n) };
        for i in 0..self.alpha.len() {
            let [r, g, b] = self.color[i].to_array().map(|v| srgb.encode(v.clamp(0.0, 1.0)));
            bytes.color.extend([r, g, b, byte(self.alpha[i])]);
            let n = (0.5 * self.normal[i].normalize_or(Vec3::Y) + 0.5).to_array().map(byte);
            bytes.detail.extend([n[0], n[1], n[2], byte(0.5 + 0.5 * self.depth[i] / reach)]);
        }
        bytes
    }
}

impl Bytes {
    /// Texels that are covered at least by half.
    pub(crate) fn covered(&self) -> usize {
        self.color.as_chunks::<4>().0.iter().filter(|texel| texel[3] >= 128).count()
    }
}

/// 0 to 1 as 0 to 255.
fn byte(v: f32) -> u8 {
    (v.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_holds_all_tiles_and_none_overlap() {
        for n in [1, 2, 3, 5, 6, 7, 60, 361] {
            let grid = Grid::square(n, 64).unwrap();
            let mut origins: Vec<_> = (0..n).map(|tile| grid.origin(tile)).collect();
            assert!(origins.iter().all(|o| o[0] + 64 <= grid.width && o[1] + 64 <= grid.height));
            origins.sort_unstable();
            origins.dedup();
            assert_eq!(origins.len(), n);
        }
        assert!(Grid::square(300, 1024).is_err());
    }
}
