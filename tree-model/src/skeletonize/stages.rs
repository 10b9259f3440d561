//! The stages of [`skeletonize`](super::skeletonize()), one by one: to look at what lies between them, to
//! change it, or to stop there.
//!
//! [`Separation`] sorts triangles into wood and leaves, [`Separation::follow`] makes a [`Piece`] of
//! every connected wood, [`link`] makes one skeleton of the pieces, and [`Separation::leaves`] hangs
//! leaves on it. Up to there all is in units of the mesh's longest side, about its middle, whatever
//! the mesh's own unit; [`Separation::outward`] brings a skeleton back.
//!
//! ```
//! use tree_model::glam::Vec3;
//! use tree_model::skeletonize::{Class, Part, SkeletonizeParams, stages};
//! use tree_model::tree_core::Control;
//!
//! # fn main() -> Result<(), tree_model::ModelError> {
//! // A square post: four sides, no caps.
//! let corner = |i: u32| {
//!     Vec3::new((i % 4 / 2) as f32, 10.0 * (i / 4) as f32, ((i + 1) % 4 / 2) as f32)
//! };
//! let positions: Vec<Vec3> = (0..8).map(corner).collect();
//! let side = |i: u32| [i, (i + 1) % 4, i + 4, (i + 1) % 4, (i + 1) % 4 + 4, i + 4];
//! let indices: Vec<u32> = (0..4).flat_map(side).collect();
//! let parts = [Part { positions: &positions, indices: &indices, ..Default::default() }];
//! let (params, control) = (SkeletonizeParams::default(), Control::default());
//!
//! let mut separation = stages::Separation::new(&parts, &params, &control)?;
//! assert_eq!(separation.n_components(), 1);
//! separation.classes[0] = Class::Wood; // whatever it was taken for
//! let pieces = separation.follow(&params, &control)?;
//! let linked = stages::link(&pieces, &params, &control)?;
//! let skeleton = separation.outward(linked.skeleton)?;
//! assert!((skeleton.bounds().size().y - 10.0).abs() < 0.1);
//! # Ok(())
//! # }
//! ```

use super::params::SkeletonizeParams;
use super::separate::{Class, Separated};
use super::weld::Soup;
use super::{assemble, ends, leaves, link, separate, shape, slices, surface, trace, weld};
use crate::error::{ModelError, Result, check};
use rayon::prelude::*;
use std::sync::Arc;
use tree_core::{Control, Foliage, Part, Resource, Skeleton};

/// Levels that cross an edge on average.
const DENSITY: f32 = 8.0;
/// A piece stands on the ground when its lowest vertex is within this share of the mesh's size of
/// the lowest wood.
const GROUND: f32 = 0.02;
/// Largest coordinate, in sizes of the mesh, of skeletons that come in.
const FAR: f32 = 1e6;

/// The triangles of a mesh, welded and sorted into connected components (steps 1 and 2). Cheap to clone
/// but for the classes.
#[derive(Clone, Debug)]
pub struct Separation<'a> {
    /// What each component is taken for. What is changed here holds from then on.
    pub classes: Vec<Class>,
    parts: &'a [Part<'a>],
    pub(super) soup: Arc<Soup>,
    separated: Arc<Separated>,
}

/// One connected piece of wood, followed from its base (steps 3 and 4).
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Nodes and radii, from the base of the piece.
    pub skeleton: Skeleton,
    /// Area of the surface that it stands for.
    pub area: f32,
    /// Bumps of the bark dropped.
    pub n_bumps: usize,
    /// Branches cut where they had grown together.
    pub n_cut: usize,
}

/// One skeleton of all pieces that could be reached (steps 5 and 6).
#[derive(Clone, Debug, PartialEq)]
pub struct Linked {
    /// The skeleton, seen from its lowest thick end.
    pub skeleton: Skeleton,
    /// Whether each piece is part of it.
    pub reached: Vec<bool>,
}

/// Leaves (step 7), in the units of the mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Leaves {
    /// The leaves.
    pub foliage: Foliage,
    /// Names of their kinds: those of the parts they come from.
    pub kinds: Vec<String>,
    /// Mean width of each kind as a share of its length.
    pub widths: Vec<f32>,
}

impl<'a> Separation<'a> {
    /// Welds the parts and says of each connected component what it is.
    ///
    /// # Errors
    /// As [`skeletonize`](super::skeletonize()).
    ///
    /// # Complexity
    /// O(n log n) in vertices and triangles.
    pub fn new(
        parts: &'a [Part<'a>],
        params: &SkeletonizeParams,
        control: &Control,
    ) -> Result<Self> {
        params.validate()?;
        let soup = weld::weld(parts, params.weld, control)?;
        control.check()?;
        let (separated, classes) = separate::separate(&soup, parts);
        Ok(Self { classes, parts, soup: Arc::new(soup), separated: Arc::new(separated) })
    }

    /// Number of components; each lies within one part.
    #[must_use]
    pub fn n_components(&self) -> usize {
        self.separated.shapes.len()
    }

    /// Triangles of a component, as the number of the part and that of the triangle in the part.
    pub fn triangles(&self, component: usize) -> impl Iterator<Item = (u32, u32)> + '_ {
        let known = component < self.n_components();
        let of = if known { self.separated.triangles.of(component as u32) } else { &[] };
        of.iter().map(|&triangle| self.soup.sources[triangle as usize])
    }

    /// The components of a class.
    pub(super) fn are(&self, class: Class) -> impl Iterator<Item = u32> + '_ {
        let all = 0..self.n_components() as u32;
        all.zip(&self.classes)
            .filter(move |(_, own)| **own == class)
            .map(|(component, _)| component)
    }

    /// The name of the part with most wood.
    pub(super) fn bark(&self) -> &'a str {
        let mut areas = vec![0.0; self.parts.len()];
        for component in self.are(Class::Wood) {
            if let Some((part, _)) = self.triangles(component as usize).next() {
                areas[part as usize] += self.separated.shapes[component as usize].area;
            }
        }
        let most = (0..areas.len()).reduce(|a, b| if areas[b] > areas[a] { b } else { a });
        most.and_then(|part| self.parts.get(part)).map_or("bark", |part| part.name)
    }

    /// Triangles of wood, rising.
    pub(super) fn wood(&self) -> Result<Vec<u32>> {
        separate::wood(&self.soup, &self.classes)
    }

    /// Follows every connected piece of wood, in parallel.
    ///
    /// # Errors
    /// [`NoWood`](ModelError::NoWood), [`Limit`](ModelError::Limit) for nodes,
    /// [`Cancelled`](ModelError::Cancelled), [`Parameter`](ModelError::Parameter).
    ///
    /// # Complexity
    /// O(n log n) in triangles.
    pub fn follow(&self, params: &SkeletonizeParams, control: &Control) -> Result<Vec<Piece>> {
        self.follow_wood(&self.wood()?, params, control)
    }

    pub(super) fn follow_wood(
        &self,
        wood: &[u32],
        params: &SkeletonizeParams,
        control: &Control,
    ) -> Result<Vec<Piece>> {
        params.validate()?;
        let soup = &*self.soup;
        let groups = surface::connect(soup, wood);
        let height = |&triangle: &u32| {
            soup.corners(triangle).iter().fold(f32::INFINITY, |low, corner| low.min(corner.y))
        };
        let ground = wood.iter().map(height).fold(f32::INFINITY, f32::min) + GROUND;
        let found = (0..groups.len() as u32)
            .into_par_iter()
            .map(|group| {
                control.check()?;
                let triangles = groups.of(group);
                let corners = triangles.iter().map(|&triangle| soup.triangles[triangle as usize]);
                let surface = surface::Surface::new(&soup.positions, corners);
                let fans = surface.fans();
                let grounded = triangles.iter().any(|triangle| height(triangle) < ground);
                let distances = ends::from_base(&surface, &fans, grounded);
                control.check()?;
                let slices = slices::Slices::new(&surface, &distances, DENSITY);
                let traced = trace::trace(&slices, params);
                let area = shape::Shape::of(triangles.iter().map(|&t| soup.corners(t))).area;
                Ok((traced, area))
            })
            .collect::<Result<Vec<_>>>()?;
        let n_nodes: usize = found.iter().flat_map(|(t, _)| t).map(|t| t.parents.len()).sum();
        control.limits.check(Resource::Nodes, n_nodes as u64)?;
        let mut pieces = Vec::with_capacity(found.len());
        for (traced, area) in found {
            let area = area / traced.len().max(1) as f32;
            for trace::Traced { positions, radii, parents, n_bumps, n_cut } in traced {
                let skeleton = Skeleton::from_columns(positions, radii, parents)?;
                pieces.push(Piece { skeleton, area, n_bumps, n_cut });
            }
        }
        Ok(pieces)
    }

    /// Makes a leaf of each leaf component, on the nearest wood of a skeleton as [`link`] returns it.
    ///
    /// # Errors
    /// [`Limit`](ModelError::Limit) for leaves, [`Cancelled`](ModelError::Cancelled),
    /// [`Parameter`](ModelError::Parameter) for a skeleton that is far from unit size.
    ///
    /// # Complexity
    /// O(n log n) in leaves and nodes where both are spread out.
    pub fn leaves(&self, skeleton: &Skeleton, control: &Control) -> Result<Leaves> {
        check_size(skeleton)?;
        let components: Vec<u32> = self.are(Class::Leaf).collect();
        leaves::leaves(&self.soup, &self.separated, &components, self.parts, skeleton, control)
    }

    /// Brings a skeleton back to the units of the mesh.
    ///
    /// # Errors
    /// [`Core`](ModelError::Core) when numbers run over.
    pub fn outward(&self, skeleton: Skeleton) -> Result<Skeleton> {
        assemble::outward(skeleton, &self.soup)
    }
}

/// Links pieces over gaps of at most [`SkeletonizeParams::bridge`].
///
/// # Errors
/// [`NoWood`](ModelError::NoWood) without pieces, [`Limit`](ModelError::Limit) for nodes,
/// [`Cancelled`](ModelError::Cancelled), [`Parameter`](ModelError::Parameter), also for pieces
/// that are far from unit size.
///
/// # Complexity
/// O(n log n) in nodes where pieces are spread out.
pub fn link(pieces: &[Piece], params: &SkeletonizeParams, control: &Control) -> Result<Linked> {
    params.validate()?;
    if pieces.is_empty() {
        return Err(ModelError::NoWood { problem: "there are no pieces to link" });
    }
    pieces.iter().try_for_each(|piece| check_size(&piece.skeleton))?;
    let n_nodes: usize = pieces.iter().map(|piece| piece.skeleton.len()).sum();
    control.limits.check(Resource::Nodes, n_nodes as u64)?;
    let forest = link::link(pieces, params.bridge, control)?;
    let skeleton = assemble::assemble(&forest, control)?;
    Ok(Linked { skeleton, reached: forest.reached })
}

/// Searching runs over cells of unit-sized things.
fn check_size(skeleton: &Skeleton) -> Result<()> {
    let places = skeleton.positions().iter().map(|p| p.abs().max_element());
    let most = places.chain(skeleton.radii().iter().copied()).fold(0.0, f32::max);
    check("skeleton.positions", most, 0.0, FAR)
}

#[cfg(test)]
#[path = "stages_tests.rs"]
mod tests;
