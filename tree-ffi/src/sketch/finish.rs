//! From branches to a tree: wood, twigs, leaves.

use super::branches::tree_sketch_branches;
use super::tree_crown;
use crate::border::{
    Result, Versioned, call, foresee, get, get_opt, init, out, read_or_default, tree_status,
    tree_str, view,
};
use crate::control::{run, tree_control};
use crate::particle::Kept;
use crate::skeleton::tree_skeleton;
use crate::tree::tree_tree;
use tree_model::sketch::finish::{FinishParams, FinishReport, grow_crown, grow_wood};
use tree_model::tree_core::{Control, Seed};

/// How branches become a tree. Begin with `tree_sketch_finish_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sketch_finish_params {
    /// `sizeof(tree_sketch_finish_params)`.
    pub struct_size: usize,
    /// Whose twigs and leaves: one of the names that `tree_foliage_preset_name` gives. Default "oak", which an empty text
    /// is too.
    pub species: tree_str,
    /// Whether there are leaves. Default 1.
    pub leaves: u32,
    /// Whether there are twigs. Default 1.
    pub twigs: u32,
    /// Radius of the trunk as a share of the height, 1e-4 to 0.2. Default 0.018.
    pub slenderness: f32,
    /// How radii add up at forks: Δ of the pipe model, 1 to 10. Default Murray's.
    pub exponent: f32,
    /// Leaves against those of a tree in full leaf, 0 to 10. Default 1.
    pub fullness: f32,
    /// Length of twigs against the usual of the species, 0.05 to 20. Default 1.
    pub twig_length: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_sketch_finish_params {
    const NAME: &'static str = "tree_sketch_finish_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::with_species(&FinishParams::default(), tree_str::of("oak"))
    }
}

impl tree_sketch_finish_params {
    fn with_species(params: &FinishParams, species: tree_str) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            species,
            leaves: params.leaves.into(),
            twigs: params.twigs.into(),
            slenderness: params.slenderness,
            exponent: params.exponent,
            fullness: params.fullness,
            twig_length: params.twig_length,
        }
    }

    /// In C's form; the species' name is kept in `kept`.
    pub(super) fn of(params: &FinishParams, kept: &mut Kept) -> Self {
        Self::with_species(params, kept.text(&params.species))
    }

    /// In Rust's form, its ranges not yet checked.
    pub(super) unsafe fn rust(&self, name: &str) -> Result<FinishParams> {
        let species = unsafe { self.species.get(&format!("{name}.species")) }?;
        let default = FinishParams::default().species;
        Ok(FinishParams {
            species: if species.is_empty() { default } else { species.to_owned() },
            leaves: self.leaves != 0,
            twigs: self.twigs != 0,
            slenderness: self.slenderness,
            exponent: self.exponent,
            fullness: self.fullness,
            twig_length: self.twig_length,
        })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_finish_params_init(
    params: *mut tree_sketch_finish_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// What the finish did.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sketch_finish_report {
    /// `sizeof(tree_sketch_finish_report)`.
    pub struct_size: usize,
    /// Nodes of branches.
    pub n_wood_nodes: u64,
    /// Nodes of twigs.
    pub n_twig_nodes: u64,
    /// Nodes of twigs cut off because they left the crown or entered the ground.
    pub n_twig_nodes_cut: u64,
    /// Blades that stayed: rows of the foliage.
    pub n_leaves: u64,
    /// Blades left out because they left the crown or entered the ground.
    pub n_leaves_outside: u64,
    /// How much larger leaves are than the species', because there would be too many; a factor.
    pub leaves_larger: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_sketch_finish_report {
    const NAME: &'static str = "tree_sketch_finish_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&FinishReport::default())
    }
}

impl tree_sketch_finish_report {
    pub(super) fn of(report: &FinishReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_wood_nodes: report.n_wood_nodes,
            n_twig_nodes: report.n_twig_nodes,
            n_twig_nodes_cut: report.n_twig_nodes_cut,
            n_leaves: report.n_leaves,
            n_leaves_outside: report.n_leaves_outside,
            leaves_larger: report.leaves_larger,
            reserved: 0,
        }
    }
}

/// The branches as a skeleton with radii by the pipe model. Every point stays where it is: seen from the front,
/// sketched branches are the strokes. `params` and `control` may be NULL. Free it with `tree_skeleton_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_branches_wood(
    branches: *const tree_sketch_branches,
    params: *const tree_sketch_finish_params,
    control: *const tree_control,
    wood: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let place = unsafe { out(wood, "wood") }?;
        let branches = unsafe { get(branches, "branches") }?.rust();
        let params = unsafe { read_or_default(params, "params")?.rust("params") }?;
        let body = |control: &Control| Ok(grow_wood(branches, &params, control)?);
        place.put(tree_skeleton::own(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Grows twigs and leaves of a species on wood, as many leaves as cover its crown like those of a tree in full leaf;
/// with a `crown`, which may be NULL, both stay in it but for half a leaf. `params`, `control` and `report` may be
/// NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_PARAMETER` names what is out of range,
/// `TREE_ERROR_UNKNOWN_NAME` a species that is none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_grow_crown(
    wood: *const tree_skeleton,
    crown: *const tree_crown,
    params: *const tree_sketch_finish_params,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_sketch_finish_report,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        unsafe { foresee(report, "report") }?;
        let wood = unsafe { get(wood, "wood") }?.rust();
        let crown = unsafe { get_opt(crown, "crown") }?.map(tree_crown::rust);
        let params = unsafe { read_or_default(params, "params")?.rust("params") }?;
        let body = |control: &Control| Ok(grow_crown(wood, crown, &params, Seed(seed), control)?);
        let (made, told) = unsafe { run(control, body) }?;
        unsafe { view(report, "report", &tree_sketch_finish_report::of(&told)) }?;
        place.put(tree_tree::new(made));
        Ok(())
    })
}
