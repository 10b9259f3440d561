//! Leaves and twigs on whole trees.

use super::leaf_params::tree_leaf_params;
use super::report::{tree_leaf_report, tree_twig_report};
use super::twig_params::tree_twig_params;
use crate::border::{Result, call, foresee, get, out, read_or_default, tree_status, view};
use crate::control::{User, run, tree_control};
use crate::tree::tree_tree;
use glam::Vec3;
use std::ffi::c_void;
use tree_model::foliage::{
    DENSITY_CAP, DensityField, LeafParams, LeafReport, grow_leaves_and_report,
    grow_leaves_with_stalks, grow_twigs, grow_twigs_in,
};
use tree_model::tree_core::{Control, Seed, Tree};

/// Densities above this count as this.
pub const TREE_DENSITY_CAP: f32 = 4.0;

// The header needs a literal; it is the library's own.
const _: () = assert!(TREE_DENSITY_CAP == DENSITY_CAP);

/// How densely leaves or twigs stand at `position`, three floats in metres: 0 none, 1 as the parameters
/// say, 2 twice as many, up to `TREE_DENSITY_CAP`. Less than 1 is the chance that a place bears; whorls stay whole.
/// Negative and not a number count as 0 and are reported. Asked once for each place, from any thread and
/// from several at a time; must give the same answer for the same place, and must not unwind.
pub type tree_density_fn =
    Option<unsafe extern "C" fn(user: *mut c_void, position: *const f32) -> f32>;

/// The caller's function as a field.
fn field(density: tree_density_fn, user: User) -> Option<impl Fn(Vec3) -> f32 + Send + Sync> {
    density.map(|density| {
        move |position: Vec3| {
            let position = position.to_array();
            // SAFETY: the caller's function with the caller's pointer, as the header says.
            unsafe { density(user.get(), position.as_ptr()) }
        }
    })
}

/// Grows leaves on a tree: the new tree has the old skeleton and species, and the new leaves in place of
/// the old ones. For leaves on a bare skeleton, make a tree of it with `tree_tree_new`.
///
/// `params` may be NULL for the default; `kind` must be a leaf kind of the tree's species. `density` may
/// be NULL for 1 everywhere, and is handed `user`. With `with_stalks` (a yes or no) petioles and rachises become thin
/// branches, for close-ups: old nodes keep number, position, radius and parent, stalks come after them,
/// and leaves name the stalk that bears them; without, leaflets name the shoot's node. The same seed
/// gives the same leaves. `report` may be NULL. Free the tree with `tree_tree_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tree_grow_leaves(
    tree: *const tree_tree,
    params: *const tree_leaf_params,
    density: tree_density_fn,
    user: *mut c_void,
    with_stalks: u32,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_leaf_report,
    grown: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(grown, "grown") }?;
        unsafe { foresee(report, "report") }?;
        let tree = unsafe { get(tree, "tree") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust()?;
        params.validate(tree.species().leaf_kinds.len())?;
        let density = field(density, User(user));
        let (grown, told) = unsafe {
            run(control, |control| {
                let density = density.as_ref().map(|density| density as &DensityField<'_>);
                leafy(tree, &params, density, with_stalks != 0, Seed(seed), control)
            })
        }?;
        unsafe { view(report, "report", &tree_leaf_report::of(&told)) }?;
        place.put(tree_tree::new(grown));
        Ok(())
    })
}

fn leafy(
    tree: &Tree,
    params: &LeafParams,
    density: Option<&DensityField<'_>>,
    with_stalks: bool,
    seed: Seed,
    control: &Control,
) -> Result<(Tree, LeafReport)> {
    let (old, species) = (tree.skeleton(), tree.species().clone());
    if with_stalks {
        let made = grow_leaves_with_stalks(old, params, density, seed, control)?;
        return Ok((Tree::new(made.skeleton, made.foliage, species)?, made.report));
    }
    let made = grow_leaves_and_report(old, params, density, seed, control)?;
    Ok((Tree::new(old.clone(), made.foliage, species)?, made.report))
}

/// Grows twigs on the youngest shoots of a tree: the new tree has the old skeleton with twigs, and the
/// old leaves and species. Old nodes keep number, position, radius and parent, so leaves stay where they
/// are; twigs come after them, each starting at the node nearest to its place. What bears twigs is not
/// made thicker: `tree_skeleton_with_rule` does that.
///
/// `params` may be NULL for the default. `density` may be NULL for 1 everywhere, and is handed `user`.
/// The same seed gives the same twigs. `report` may be NULL. Free the tree with `tree_tree_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tree_grow_twigs(
    tree: *const tree_tree,
    params: *const tree_twig_params,
    density: tree_density_fn,
    user: *mut c_void,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_twig_report,
    grown: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(grown, "grown") }?;
        unsafe { foresee(report, "report") }?;
        let tree = unsafe { get(tree, "tree") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust()?;
        let density = field(density, User(user));
        let (old, seed) = (tree.skeleton(), Seed(seed));
        let made = unsafe {
            run(control, |control| {
                Ok(match &density {
                    Some(density) => grow_twigs_in(old, &params, density, seed, control)?,
                    None => grow_twigs(old, &params, seed, control)?,
                })
            })
        }?;
        let (leaves, species) = (tree.foliage().clone(), tree.species().clone());
        let grown = Tree::new(made.skeleton, leaves, species)?;
        unsafe { view(report, "report", &tree_twig_report::of(&made.report)) }?;
        place.put(tree_tree::new(grown));
        Ok(())
    })
}
