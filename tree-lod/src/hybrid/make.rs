//! A tree to its hybrid model.

use crate::element::{Elements, Grain, LeafSurfaces};
use crate::error::{Result, check_range};
use crate::impostor::boxes::{Bearers, BoxParams, Boxes};
use crate::impostor::cards::{CardParams, Cards};
use crate::impostor::choose::ChooseParams;
use crate::multires::{Adt, Metric, MultiMesh, Multires, paths};
use tree_core::{Aabb, Control, Tree};
use tree_mesh::{Look, Mesh, MeshParams};

/// Parameters of every step.
#[derive(Clone, Debug, PartialEq)]
pub struct HybridParams {
    /// What branches are worth. Leaves are drawn whatever the level of the wood, so their areas do not count.
    pub metric: Metric,
    /// How wood and leaves are drawn.
    pub mesh: MeshParams,
    /// How leaves are put into boxes.
    pub boxes: BoxParams,
    /// The pictures of the boxes.
    pub cards: CardParams,
    /// When pictures take the place of leaves.
    pub choose: ChooseParams,
    /// Side in pixels, 0.01 to 100, of the square that a path must cover, seen from the side, to be drawn. Less shows finer twigs, more saves triangles.
    /// Default 0.5.
    pub wood_pixels: f32,
}

impl Default for HybridParams {
    fn default() -> Self {
        Self {
            metric: Metric::default(),
            mesh: MeshParams::default(),
            boxes: BoxParams::default(),
            cards: CardParams::default(),
            choose: ChooseParams::default(),
            wood_pixels: 0.5,
        }
    }
}

impl HybridParams {
    /// Checks every field.
    ///
    /// # Errors
    /// [`LodError::Parameter`](crate::LodError::Parameter) or [`LodError::Mesh`](crate::LodError::Mesh), naming the
    /// field.
    pub fn validate(&self) -> Result<()> {
        self.mesh.validate()?;
        self.boxes.validate()?;
        self.cards.validate()?;
        self.choose.validate()?;
        check_range("wood_pixels", self.wood_pixels.into(), 0.01, 100.0)
    }
}

/// Branches by prefix, and leaves by geometry or by images.
#[derive(Clone, Debug, PartialEq)]
pub struct Hybrid {
    pub(super) multires: Multires,
    pub(super) wood: MultiMesh,
    /// Surface 0 is the wood, the others hold leaves in the order of the boxes.
    pub(super) mesh: Mesh,
    /// For each surface of leaves: its first index for each row of the order of the boxes, and the end.
    pub(super) starts: Vec<Vec<u32>>,
    /// None for a tree without leaves.
    pub(super) cards: Option<Cards>,
    /// For each path: the side of the square that covers as much as it does, smoothed to fall, in metres.
    pub(super) sizes: Vec<f32>,
    pub(super) bounds: Aabb,
    pub(super) choose: ChooseParams,
    pub(super) wood_pixels: f32,
}

impl Hybrid {
    /// Makes the model of a tree: sorts its branches, draws them, puts its leaves into boxes and takes their
    /// pictures.
    ///
    /// # Errors
    /// As [`HybridParams::validate`], [`paths`], [`MultiMesh::new`], [`Boxes::along`] and [`Cards::bake`].
    ///
    /// # Complexity
    /// Dominated by the pictures: O(boxes · samples + levels · triangles).
    pub fn make(
        tree: &Tree,
        look: &Look,
        params: &HybridParams,
        control: &Control,
    ) -> Result<Self> {
        params.validate()?;
        let adt = Adt::of_skeleton(tree.skeleton());
        let paths = paths(&adt, &params.metric, &control.part(0.0, 0.1))?;
        let (multires, _) = Multires::of_paths(tree, &adt, &paths)?;
        let wood = MultiMesh::new(&multires, look, &params.mesh, &control.part(0.1, 0.3))?;
        let mut mesh = wood.mesh().clone();
        let surfaces: Vec<u32> = (1..mesh.surfaces.len() as u32)
            .filter(|&surface| !mesh.surfaces[surface as usize].indices.is_empty())
            .collect();
        let (mut cards, mut starts) = (None, vec![Vec::new(); mesh.surfaces.len()]);
        if !surfaces.is_empty() {
            let foliage = LeafSurfaces::Surfaces(surfaces);
            let part = control.part(0.3, 0.4);
            let elements = Elements::of_mesh(&mesh, &foliage, Grain::Leaf, &part)?;
            let bearers = Bearers::of_tree(multires.tree(), &mesh, &elements)?;
            let skeleton = multires.tree().skeleton();
            let part = control.part(0.4, 0.5);
            let boxes = Boxes::along(skeleton, &mesh, &elements, &bearers, &params.boxes, &part)?;
            starts = sort_leaves(&mut mesh, &elements, &boxes);
            let part = control.part(0.5, 1.0);
            cards = Some(Cards::bake(wood.mesh(), &elements, &boxes, &params.cards, &part)?);
        }
        let (sizes, bounds) = (sizes(&multires), bounds(&mesh, &multires));
        let (choose, wood_pixels) = (params.choose, params.wood_pixels);
        Ok(Self { multires, wood, mesh, starts, cards, sizes, bounds, choose, wood_pixels })
    }

    /// The sorted tree.
    #[must_use]
    pub fn multires(&self) -> &Multires {
        &self.multires
    }

    /// The wood and its levels.
    #[must_use]
    pub fn wood(&self) -> &MultiMesh {
        &self.wood
    }

    /// What to upload: surface 0 is the wood, of which a level is a prefix; the others are leaves, kind by kind,
    /// sorted such that each box has one window ([`leaf_window`](Self::leaf_window)).
    #[must_use]
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Boxes and pictures of the leaves; none when the tree has no leaves.
    #[must_use]
    pub fn cards(&self) -> Option<&Cards> {
        self.cards.as_ref()
    }

    /// The window of a surface's index buffer that holds a range of leaves, as
    /// [`Choice::leaves`](crate::impostor::choose::Choice::leaves) has them: first index and number. Nothing for
    /// wood, and for rows that are not there.
    ///
    /// # Complexity
    /// O(1).
    #[must_use]
    pub fn leaf_window(&self, surface: usize, rows: std::ops::Range<u32>) -> (u32, u32) {
        let starts = self.starts.get(surface).map_or(&[][..], |starts| starts);
        match (starts.get(rows.start as usize), starts.get(rows.end as usize)) {
            (Some(&first), Some(&end)) if first <= end => (first, end - first),
            _ => (0, 0),
        }
    }
}

/// Brings the triangles of leaves into the order of the boxes; tells where those of each row begin.
fn sort_leaves(mesh: &mut Mesh, elements: &Elements, boxes: &Boxes) -> Vec<Vec<u32>> {
    let mut starts = vec![Vec::new(); mesh.surfaces.len()];
    for &surface in &elements.surfaces {
        let surface = surface as usize;
        let old = std::mem::take(&mut mesh.surfaces[surface].indices);
        let mut new = Vec::with_capacity(old.len());
        let mut rows = Vec::with_capacity(boxes.order().len() + 1);
        for &element in boxes.order() {
            rows.push(new.len() as u32);
            if elements.surface[element as usize] as usize == surface {
                for &triangle in elements.triangles_of(element as usize) {
                    new.extend_from_slice(&old[3 * triangle as usize..][..3]);
                }
            }
        }
        rows.push(new.len() as u32);
        mesh.surfaces[surface].indices = new;
        starts[surface] = rows;
    }
    starts
}

/// A tree of one node has no triangles, but a place.
fn bounds(mesh: &Mesh, multires: &Multires) -> Aabb {
    mesh.bounds().union(multires.tree().skeleton().bounds())
}

/// For each path the side of the square that it covers, smoothed so that it falls from path to path.
fn sizes(multires: &Multires) -> Vec<f32> {
    let skeleton = multires.tree().skeleton();
    let (positions, radii) = (skeleton.positions(), skeleton.radii());
    let area = |path: usize| {
        let first = if path == 0 { 1 } else { multires.counts(path).0 };
        (first..multires.counts(path + 1).0).fold(0.0, |area, node| {
            let parent = skeleton.parent(node as u32).unwrap_or(0) as usize;
            let radius = if node == first { radii[node] } else { radii[parent] };
            let length = f64::from(positions[node].distance(positions[parent]));
            area + length * f64::from(radius + radii[node])
        })
    };
    falling((0..multires.n_levels()).map(area)).map(|area| area.max(0.0).sqrt() as f32).collect()
}

/// The falling numbers that fit these best: neighbours that rise are pooled (isotonic regression, Ayer et al. 1955),
/// and between the middles of pools numbers fall evenly, so that no two paths come at once.
fn falling(values: impl Iterator<Item = f64>) -> impl Iterator<Item = f64> {
    // Sum and number of each pool.
    let mut pools: Vec<(f64, f64)> = Vec::new();
    for value in values {
        let mut last = (value, 1.0);
        while let Some(&(sum, n)) = pools.last().filter(|(sum, n)| sum / n <= last.0 / last.1) {
            last = (last.0 + sum, last.1 + n);
            pools.pop();
        }
        pools.push(last);
    }
    let mut points = Vec::with_capacity(pools.len() + 1);
    let mut before = 0.0;
    for (sum, n) in &pools {
        points.push((before + 0.5 * n, sum / n));
        before += n;
    }
    // The last pool falls to half of itself.
    points.extend(points.last().map(|&(_, value)| (before, 0.5 * value)));
    let mut at = 0;
    (0..before as usize).map(move |path| {
        let middle = path as f64 + 0.5;
        while at + 1 < points.len() && points[at + 1].0 <= middle {
            at += 1;
        }
        let (x, value) = points[at];
        match points.get(at + 1) {
            Some(&(next, lower)) if middle > x => {
                value + (lower - value) * (middle - x) / (next - x)
            }
            _ => value,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::falling;

    #[test]
    fn numbers_that_fall_stay_and_odd_ones_are_spread() {
        let fit = |values: &[f64]| falling(values.iter().copied()).collect::<Vec<_>>();
        assert_eq!(fit(&[8.0, 4.0, 2.0]), [8.0, 4.0, 2.0]);
        assert!(fit(&[]).is_empty());
        let spread = fit(&[8.0, 1.0, 1.0, 1.0, 5.0, 0.5]);
        assert!(spread.windows(2).all(|pair| pair[0] > pair[1]), "{spread:?}");
        assert_eq!((spread[0], spread[5]), (8.0, 0.5));
    }
}
