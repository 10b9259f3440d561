//! Base and twigs as trees of their own, and as meshes.

use super::cluster::Groups;
use super::cut::{BASE, Cut};
use super::describe::Form;
use super::{InstancedTree, Scene, Twig};
use crate::build::{build, build_numbered};
use crate::error::Result;
use crate::mesh::Mesh;
use crate::params::MeshParams;
use glam::Vec3;
use tree_core::{Control, Foliage, Leaf, Skeleton, Tree};

/// What is left of the tree without its occurrences.
pub(super) struct Base {
    pub(super) mesh: Mesh,
    /// Branch of each node of the whole tree that is part of the base; 0 for others.
    branch_of: Vec<u32>,
}

/// The base as a mesh.
pub(super) fn base(scene: Scene<'_>, cut: &Cut, control: &Control) -> Result<Base> {
    let (tree, numbers) = base_tree(scene.tree, cut)?;
    let (built, branch_of) = build_numbered(&tree, scene.look, scene.params, &quiet(control))?;
    let axes = tree.skeleton().axes(scene.params.continuation);
    let branch = |&number: &u32| {
        let axis = axes.axis_of().get(number as usize)?;
        branch_of.get(*axis as usize).copied()
    };
    let branch = |number: &u32| branch(number).unwrap_or(0);
    Ok(Base { mesh: built.mesh, branch_of: numbers.iter().map(branch).collect() })
}

/// Callbacks hear of the whole, not of its parts.
fn quiet(control: &Control) -> Control {
    control.clone().with_progress(|_| {})
}

/// Base, twigs and instances; without a report.
pub(super) fn assemble(
    scene: Scene<'_>,
    base: &Base,
    cut: &Cut,
    forms: &[Form],
    groups: &Groups,
    control: &Control,
) -> Result<InstancedTree> {
    let Scene { tree, look, params } = scene;
    let params = MeshParams { flare: 0.0, ..*params };
    let axes = tree.skeleton().axes(params.continuation);
    let mut twigs = Vec::with_capacity(groups.medoids.len());
    for &medoid in &groups.medoids {
        control.check()?;
        let twig = twig(tree, cut, forms, medoid as usize, axes.axis_of())?;
        let mesh = build(&twig, look, &params, &quiet(control))?.mesh;
        twigs.push(Twig { mesh, ..Twig::default() });
    }
    for (number, (form, &group)) in forms.iter().zip(&groups.of).enumerate() {
        let medoid = groups.medoids.get(group as usize).and_then(|&m| forms.get(m as usize));
        if let (Some(twig), Some(medoid)) = (twigs.get_mut(group as usize), medoid) {
            let bearer = cut.bearer(tree.skeleton(), number);
            twig.translations.push(form.origin);
            twig.rotations.push(form.rotation);
            twig.scales.push(Vec3::splat(form.size / medoid.size));
            twig.branches.push(base.branch_of.get(bearer as usize).copied().unwrap_or(0));
        }
    }
    Ok(InstancedTree { base: base.mesh.clone(), twigs, ..Default::default() })
}

/// The tree without occurrences, and the new number of each node.
fn base_tree(tree: &Tree, cut: &Cut) -> Result<(Tree, Vec<u32>)> {
    let skeleton = tree.skeleton();
    let mut numbers = vec![0_u32; skeleton.len()];
    let mut builder = Skeleton::builder(skeleton.positions()[0], skeleton.radii()[0])?;
    for (parent, node) in skeleton.segments() {
        let n = node as usize;
        if cut.owner[n] == BASE {
            let below = numbers[parent as usize];
            numbers[n] = builder.add(below, skeleton.positions()[n], skeleton.radii()[n])?;
        }
    }
    let mut foliage = Foliage::default();
    for leaf in tree.foliage().iter().filter(|leaf| cut.owner[leaf.node as usize] == BASE) {
        foliage.push(Leaf { node: numbers[leaf.node as usize], ..leaf })?;
    }
    Ok((Tree::new(builder.finish(), foliage, tree.species().clone())?, numbers))
}

/// An occurrence in its own frame.
fn twig(tree: &Tree, cut: &Cut, forms: &[Form], number: usize, axis_of: &[u32]) -> Result<Tree> {
    let (skeleton, foliage) = (tree.skeleton(), tree.foliage());
    let species = tree.species().clone();
    let (Some(form), Some(&root)) = (forms.get(number), cut.roots.get(number)) else {
        return Ok(Tree::bare(Skeleton::builder(Vec3::ZERO, 0.0)?.finish(), species));
    };
    let bearer = cut.bearer(skeleton, number);
    let back = form.rotation.inverse();
    let own = |p: Vec3| back * (p - form.origin);
    // A lateral starts as thin as it is, the end of an axis as thick as the axis.
    let goes_on = axis_of[root as usize] == axis_of[bearer as usize];
    let foot = skeleton.radii()[if goes_on { bearer } else { root } as usize];
    let mut builder = Skeleton::builder(Vec3::ZERO, foot)?;
    let nodes = cut.nodes(number);
    // Nodes of an occurrence are in ascending order: places in it are found by search.
    let place = |node: u32| nodes.binary_search(&node).map_or(0, |at| at as u32 + 1);
    for &node in nodes {
        let parent = skeleton.parent(node).map_or(0, place);
        let i = node as usize;
        builder.add(parent, own(skeleton.positions()[i]), skeleton.radii()[i])?;
    }
    let mut leaves = Foliage::default();
    for leaf in cut.leaves(number).iter().filter_map(|&leaf| foliage.get(leaf as usize)) {
        leaves.push(Leaf {
            node: place(leaf.node),
            position: own(leaf.position),
            rotation: back * leaf.rotation,
            ..leaf
        })?;
    }
    Ok(Tree::new(builder.finish(), leaves, species)?)
}
