//! How well a silhouette covers another: precision, recall and F1 at 128².

use std::error::Error;
use tree_core::{Control, Tree};
use tree_lod::preview::{Camera, Lens, Mask, Pose, View, mask};
use tree_mesh::{Look, Mesh, MeshParams};
use tree_model::glam::Vec2;
use tree_model::particle::{self, Matte};

/// Rows and columns in which silhouettes are compared.
const SIDE: usize = 128;
/// Empty share of the frame around what is compared.
const MARGIN: f32 = 0.08;
/// A cell counts as covered from this share up.
const COVERED: f32 = 0.5;

/// Precision, recall and F1.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Score {
    pub(super) precision: f64,
    pub(super) recall: f64,
}

impl Score {
    pub(super) fn f1(self) -> f64 {
        let sum = self.precision + self.recall;
        if sum > 0.0 { 2.0 * self.precision * self.recall / sum } else { 0.0 }
    }
}

/// Compares `found` with the truth `asked`: two mattes of one size. Both are brought to 128² over a square
/// around the truth; a cell is covered where at least half of it is.
pub(super) fn score(found: &Matte, asked: &Matte) -> Score {
    let Some((low, side)) = square_around(asked) else { return Score::default() };
    let (found, asked) = (cells(found, low, side), cells(asked, low, side));
    let (mut both, mut n_found, mut n_asked) = (0_u32, 0_u32, 0_u32);
    for (found, asked) in found.into_iter().zip(asked) {
        let (found, asked) = (found >= COVERED, asked >= COVERED);
        both += u32::from(found && asked);
        n_found += u32::from(found);
        n_asked += u32::from(asked);
    }
    let share = |n: u32| if n > 0 { f64::from(both) / f64::from(n) } else { 0.0 };
    Score { precision: share(n_found), recall: share(n_asked) }
}

/// The square around everything in a matte, with a margin: its lowest corner and its side in pixels.
fn square_around(matte: &Matte) -> Option<(Vec2, f32)> {
    let width = matte.width() as usize;
    let (mut low, mut high) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
    for (i, &alpha) in matte.alpha().iter().enumerate() {
        if alpha >= COVERED {
            let at = Vec2::new((i % width) as f32, (i / width) as f32);
            low = low.min(at);
            high = high.max(at + 1.0);
        }
    }
    let size = high - low;
    let side = size.max_element() * (1.0 + 2.0 * MARGIN);
    side.is_finite().then(|| (low + 0.5 * size - 0.5 * side, side))
}

/// Mean of the matte in each cell of a square; outside the picture nothing is covered.
fn cells(matte: &Matte, low: Vec2, side: f32) -> Vec<f32> {
    let cell = side / SIDE as f32;
    let taps = (cell.ceil() as usize * 2).clamp(2, 16);
    let mut cells = Vec::with_capacity(SIDE * SIDE);
    for row in 0..SIDE {
        for column in 0..SIDE {
            let corner = low + cell * Vec2::new(column as f32, row as f32);
            let mut sum = 0.0;
            for tap in 0..taps * taps {
                let share = Vec2::new((tap % taps) as f32, (tap / taps) as f32) + 0.5;
                let at = (corner + cell * share / taps as f32).floor();
                sum += matte.at(at.x as i64, at.y as i64);
            }
            cells.push(sum / (taps * taps) as f32);
        }
    }
    cells
}

/// The mesh of a tree.
pub(super) fn mesh(tree: &Tree, control: &Control) -> Result<Mesh, Box<dyn Error>> {
    dressed(tree, &Look::built_in(tree.species())?, control)
}

/// The mesh of a tree in a look that is there already.
pub(super) fn dressed(tree: &Tree, look: &Look, control: &Control) -> Result<Mesh, Box<dyn Error>> {
    Ok(tree_mesh::build(tree, look, &MeshParams::default(), control)?.mesh)
}

/// What `mesh` covers as `camera` sees it.
pub(super) fn seen(
    mesh: &Mesh,
    camera: &particle::Camera,
    control: &Control,
) -> Result<Matte, Box<dyn Error>> {
    let stand = camera.stand();
    let lens = match stand.fov {
        Some(fov) => Lens::Perspective { fov },
        None => Lens::Orthographic { height: stand.height },
    };
    let pose = Pose { eye: stand.eye, target: stand.target, up: stand.up, lens };
    let view = View {
        width: camera.size.x as u32,
        height: camera.size.y as u32,
        samples: 2,
        camera: Camera::Placed(pose),
    };
    let Mask { width, height, coverage } = mask(mesh, &view, control)?;
    let alpha = coverage.iter().map(|&c| f32::from(c) / 255.0).collect();
    Ok(Matte::new(width, height, alpha)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn disc(radius: f32) -> Matte {
        let alpha = (0..200 * 300).map(|i| {
            let at = Vec2::new((i % 200) as f32 + 0.5, (i / 200) as f32 + 0.5);
            f32::from(u8::from(at.distance(Vec2::new(90.0, 150.0)) < radius))
        });
        Matte::new(200, 300, alpha.collect()).unwrap()
    }

    #[test]
    fn a_silhouette_covers_itself() {
        let score = score(&disc(60.0), &disc(60.0));
        assert_eq!((score.precision, score.recall, score.f1()), (1.0, 1.0, 1.0));
    }

    #[test]
    fn a_smaller_disc_is_precise_and_misses_the_rim() {
        let score = score(&disc(42.4), &disc(60.0));
        assert_eq!(score.precision, 1.0);
        assert!((score.recall - 0.5).abs() < 0.02, "{score:?}");
    }
}
