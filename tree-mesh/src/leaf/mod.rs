//! Leaves: every kind is one small mesh, set down at each of its leaves.
//!
//! 1. [`form`]: what a user asks for. [`cover`] reads what of a picture is visible, [`chain`] fits
//!    a polygon around it, [`sheet`] makes a leaf of the polygon, flat or folded and bent.
//! 2. [`prototype`]: sheets crossed, factors counted in, tangents, petiole: all counts are known.
//! 3. [`crown`]: where the outside of the crown is.
//! 4. [`fill`]: the columns.
//!
//! A leaf's own frame has its base at the origin, its midrib along +Y and its upper face towards +Z.
//!
//! Cost: O(leaves × vertices of one), in parallel over fixed parts.

mod chain;
mod cover;
mod crown;
mod fill;
mod form;
mod prototype;
mod ring;
mod sheet;

pub use form::{LeafForm, LeafMesh, LeafModel};
pub(crate) use prototype::{Prototype, model};

use crate::error::Result;
use crate::lightmap::LeafCells;
use crate::look::Look;
use crate::mesh::{Alpha, Material, Surface};
use crate::params::MeshParams;
use bytemuck::allocation::zeroed_vec;
use crown::Crown;
use tree_core::{Axes, Control, Tree};

/// Leaves of a tree, counted, and what each kind looks like.
#[derive(Debug)]
pub(crate) struct Leaves {
    prototypes: Vec<Prototype>,
    /// Leaves of each kind that can be seen.
    counts: Vec<u64>,
}

impl Leaves {
    /// Counts the leaves of a tree. The look was checked.
    ///
    /// # Errors
    /// [`MeshError::Texture`](crate::MeshError::Texture).
    pub(crate) fn new(tree: &Tree, look: &Look, params: &MeshParams) -> Result<Self> {
        let prototypes =
            look.leaves.iter().map(|leaf| Prototype::new(leaf, params)).collect::<Result<_>>()?;
        let mut counts = vec![0; tree.species().leaf_kinds.len()];
        let foliage = tree.foliage();
        for (&kind, &size) in foliage.kinds().iter().zip(foliage.sizes()) {
            if size > 0.0
                && let Some(count) = counts.get_mut(usize::from(kind))
            {
                *count += 1;
            }
        }
        Ok(Self { prototypes, counts })
    }

    /// Leaves that are drawn.
    pub(crate) fn len(&self) -> usize {
        self.counts.iter().sum::<u64>() as usize
    }

    /// Vertices and triangles of each kind.
    pub(crate) fn sizes(&self) -> impl Iterator<Item = (u64, u64)> + '_ {
        let size = |(&n, prototype): (&u64, &Prototype)| {
            let each = (prototype.n_vertices() as u64, prototype.n_indices() as u64 / 3);
            (n.saturating_mul(each.0), n.saturating_mul(each.1))
        };
        self.counts.iter().zip(&self.prototypes).map(size)
    }

    /// Kinds whose picture could not be outlined: they are cards.
    pub(crate) fn fallbacks(&self) -> Vec<u32> {
        let kinds = self.prototypes.iter().enumerate();
        kinds.filter(|(_, prototype)| prototype.fallback).map(|(kind, _)| kind as u32).collect()
    }

    /// The look's materials, without a mask where the margin is modelled.
    pub(crate) fn materials<'a>(&'a self, look: &'a Look) -> impl Iterator<Item = Material> + 'a {
        look.leaves.iter().zip(&self.prototypes).map(|(leaf, prototype)| {
            let alpha = if prototype.opaque { Alpha::Opaque } else { leaf.material.alpha };
            Material { alpha, ..leaf.material.clone() }
        })
    }

    /// Appends a surface for each kind. Memory was asked for with [`Leaves::sizes`].
    ///
    /// # Errors
    /// [`Cancelled`](tree_core::Cancelled).
    pub(crate) fn fill(
        &self,
        tree: &Tree,
        axes: &Axes,
        params: &MeshParams,
        control: &Control,
        surfaces: &mut Vec<Surface>,
    ) -> Result<()> {
        let foliage = tree.foliage();
        let crown = if params.leaf_rounding > 0.0 {
            Crown::of(foliage.positions())
        } else {
            Crown::default()
        };
        let scene = fill::Scene {
            skeleton: tree.skeleton(),
            foliage,
            axis_of: axes.axis_of(),
            crown: &crown,
            rounding: params.leaf_rounding,
            cells: LeafCells::new(self.counts.iter().sum()),
        };
        let mut first_cell = 0;
        for (kind, (leaves, prototype)) in
            self.by_kind(tree).iter().zip(&self.prototypes).enumerate()
        {
            control.check()?;
            let mut surface = new_surface(leaves.len(), prototype, kind + 1, params);
            fill::fill(scene, prototype, leaves, first_cell, &mut surface, control)?;
            first_cell += leaves.len() as u64;
            surfaces.push(surface);
        }
        Ok(())
    }

    /// Rows of the foliage, for each kind.
    fn by_kind(&self, tree: &Tree) -> Vec<Vec<u32>> {
        let foliage = tree.foliage();
        let mut of_kind: Vec<Vec<u32>> =
            self.counts.iter().map(|&n| Vec::with_capacity(n as usize)).collect();
        let rows = foliage.kinds().iter().zip(foliage.sizes()).enumerate();
        for (leaf, (&kind, &size)) in rows {
            if size > 0.0
                && let Some(leaves) = of_kind.get_mut(usize::from(kind))
            {
                leaves.push(leaf as u32);
            }
        }
        of_kind
    }
}

/// A surface of zeros: pages are first touched by the thread that fills them.
fn new_surface(
    n_leaves: usize,
    prototype: &Prototype,
    material: usize,
    params: &MeshParams,
) -> Surface {
    let n = n_leaves * prototype.n_vertices();
    let asked = |yes: bool| if yes { n } else { 0 };
    Surface {
        positions: zeroed_vec(n),
        normals: zeroed_vec(n),
        uvs: zeroed_vec(n),
        tangents: zeroed_vec(asked(params.tangents)),
        uvs2: zeroed_vec(asked(params.lightmap)),
        branches: zeroed_vec(n),
        anchors: zeroed_vec(n_leaves),
        indices: zeroed_vec(n_leaves * prototype.n_indices()),
        material: material as u32,
        ..Default::default()
    }
}

#[cfg(test)]
mod tests;
