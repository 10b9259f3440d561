//! Small meshes drawn many times: leaves without a copy of their triangles for each.

use crate::build::build;
use crate::error::{MeshError, Result};
use crate::look::Look;
use crate::mesh::Mesh;
use crate::params::MeshParams;
use glam::{Quat, Vec3};
use tree_core::{Control, Foliage, Leaf, Skeleton, Tree};

/// A mesh and where its copies stand: scaled, turned, then moved.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Instances {
    /// Name of the node and the mesh.
    pub name: String,
    /// What is drawn many times, with materials of its own.
    pub mesh: Mesh,
    /// Where the origin of each copy comes to lie, in metres.
    pub translations: Vec<Vec3>,
    /// How each copy is turned: unit quaternions.
    pub rotations: Vec<Quat>,
    /// Factors along the axes of the mesh, for each copy.
    pub scales: Vec<Vec3>,
}

impl Instances {
    /// Checks that there are copies, the columns have one length, and all numbers are finite and the
    /// rotations of unit length.
    ///
    /// # Errors
    /// [`MeshError::Instances`].
    pub fn check(&self) -> Result<()> {
        let fail = |problem: String| Err(MeshError::Instances { name: self.name.clone(), problem });
        let n = self.translations.len();
        if n == 0 {
            return fail("there are none; leave them out".into());
        }
        for (field, found) in [("rotations", self.rotations.len()), ("scales", self.scales.len())] {
            if found != n {
                return fail(format!("{found} {field}, {n} translations"));
            }
        }
        let vectors = self.translations.iter().zip(&self.scales);
        if let Some(row) = vectors.clone().position(|(t, s)| !t.is_finite() || !s.is_finite()) {
            return fail(format!("row {row} is not finite"));
        }
        let bad = |q: &Quat| !q.is_finite() || (q.length_squared() - 1.0).abs() > 0.01;
        match self.rotations.iter().position(bad) {
            Some(row) => fail(format!("rotation {row} is not of unit length")),
            None => Ok(()),
        }
    }
}

/// A tree as bark and instanced leaves.
#[derive(Clone, Debug, PartialEq)]
pub struct Instanced {
    /// The bark.
    pub mesh: Mesh,
    /// The leaves of each kind that the tree bears.
    pub leaves: Vec<Instances>,
}

/// Share of the progress that is for the bark.
const BARK_SHARE: f32 = 0.9;

/// Builds a tree with one mesh for each kind of leaf instead of a copy for each leaf.
///
/// Normals of instanced leaves are those of the leaf itself: [`MeshParams`] cannot turn them towards
/// the outside of the crown.
///
/// # Errors
/// As [`build`].
///
/// # Complexity
/// O(nodes + leaves); a leaf costs 40 bytes.
pub fn instanced(
    tree: &Tree,
    look: &Look,
    params: &MeshParams,
    control: &Control,
) -> Result<Instanced> {
    let (skeleton, species) = (tree.skeleton(), tree.species());
    let bare = Tree::bare(skeleton.clone(), species.clone());
    // Bark is by far the most work: a leaf of each kind is made once.
    let mut mesh = build(&bare, look, params, &control.part(0.0, BARK_SHARE))?.mesh;
    mesh.surfaces.retain(|surface| surface.n_triangles() > 0);
    let foliage = tree.foliage();
    let mut leaves = Vec::new();
    let n_kinds = look.leaves.len();
    let done = |kinds: usize| BARK_SHARE + (1.0 - BARK_SHARE) * kinds as f32 / n_kinds as f32;
    for kind in 0..n_kinds {
        let rows: Vec<Leaf> = foliage
            .iter()
            .filter(|leaf| usize::from(leaf.kind) == kind && leaf.size > 0.0)
            .collect();
        control.check()?;
        if rows.is_empty() {
            continue;
        }
        let part = control.part(done(kind), done(kind + 1));
        leaves.push(Instances {
            name: species.leaf_kinds.get(kind).cloned().unwrap_or_default(),
            mesh: prototype(tree, look, params, kind, &part)?,
            translations: rows.iter().map(|leaf| leaf.position).collect(),
            rotations: rows.iter().map(|leaf| leaf.rotation).collect(),
            scales: rows.iter().map(|leaf| Vec3::splat(leaf.size)).collect(),
        });
    }
    control.report("done", 1.0)?;
    Ok(Instanced { mesh, leaves })
}

/// One leaf of length 1 in its own frame.
fn prototype(
    tree: &Tree,
    look: &Look,
    params: &MeshParams,
    kind: usize,
    control: &Control,
) -> Result<Mesh> {
    let skeleton = Skeleton::builder(Vec3::ZERO, 0.01)?.finish();
    let leaf = Leaf {
        node: 0,
        position: Vec3::ZERO,
        rotation: Quat::IDENTITY,
        size: 1.0,
        kind: kind as u16,
    };
    let foliage = Foliage::try_from(vec![leaf])?;
    let one = Tree::new(skeleton, foliage, tree.species().clone())?;
    // A crown of one leaf has no outside to turn normals to.
    let mut flat = params.to_owned();
    flat.leaf_rounding = 0.0;
    let mesh = build(&one, look, &flat, control)?.mesh;
    // The surfaces are the bark and then the kinds of leaves.
    let mut surface = mesh.surfaces.into_iter().nth(kind + 1).unwrap_or_default();
    surface.branches.clear();
    Ok(Mesh { surfaces: vec![surface], materials: mesh.materials, branches: Vec::new() })
}
