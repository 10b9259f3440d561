//! What is measured.

use super::elements::tree_elements;
use super::score::{fill_scores, tree_score};
use super::take::{few, fill_some, room_for};
use super::tiers::{TIERS_MAX, tree_tiers};
use super::views::tree_around;
use crate::border::{
    Failure, Result, TREE_ERROR_INVALID, Versioned, call, get, get_opt, init, read, slice,
    tree_status, vec3s,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::tree_mesh;
use std::borrow::Cow;
use std::ptr::null;
use tree_lod::Elements;
use tree_lod::order::Ranking;
use tree_lod::outline::Tier;
use tree_lod::prune::plan;
use tree_lod::quality::{Subject, scores_at};
use tree_lod::tree_mesh::Mesh;
use tree_model::tree_core::Resource;

/// What is measured: a model, its elements, in which order they are dropped, and what they are drawn with. Begin with
/// `tree_lod_subject_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_lod_subject {
    /// `sizeof(tree_lod_subject)`.
    pub struct_size: usize,
    /// The full model. No default: NULL, which is refused.
    pub mesh: *const tree_mesh,
    /// Its elements. No default: NULL, which is refused.
    pub elements: *const tree_elements,
    /// All elements, the most important first, such as `tree_order_coverage` writes them.
    pub order: *const u32,
    /// Number of rows of `order`: the number of elements.
    pub n_order: usize,
    /// Three floats for each element (not rank): the point it is scaled about, in metres. NULL, the default: its
    /// centre.
    pub pivots: *const f32,
    /// Number of pivots: the number of elements, or 0 for the default.
    pub n_pivots: usize,
    /// What the elements are drawn with. NULL, the default: the full model alone.
    pub tiers: *const tree_tiers,
    /// Number of elements with which each tier begins, such as `tree_lod_plan` writes them: of the first all, then
    /// never more than before. NULL, the default: each begins with all.
    pub kept: *const u32,
    /// Number of rows of `kept`: the number of tiers, or 0 for the default.
    pub n_kept: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_lod_subject {
    const NAME: &'static str = "tree_lod_subject";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            mesh: null(),
            elements: null(),
            order: null(),
            n_order: 0,
            pivots: null(),
            n_pivots: 0,
            tiers: null(),
            kept: null(),
            n_kept: 0,
        }
    }
}

/// A subject with what it is made of.
pub(super) struct Held<'a> {
    mesh: &'a Mesh,
    elements: &'a Elements,
    tiers: Cow<'a, [Tier]>,
    ranking: Ranking,
    kept: &'a [u32],
}

impl Held<'_> {
    pub(super) fn rust(&self) -> Subject<'_> {
        Subject {
            mesh: self.mesh,
            elements: self.elements,
            tiers: &self.tiers,
            ranking: &self.ranking,
            kept: self.kept,
        }
    }
}

impl tree_lod_subject {
    pub(super) unsafe fn read<'a>(
        subject: *const Self,
        control: *const tree_control,
    ) -> Result<Held<'a>> {
        let limits = unsafe { limits(control) }?;
        let given = unsafe { read(subject, "subject") }?;
        let mesh = unsafe { get(given.mesh, "subject.mesh") }?.rust();
        let elements = unsafe { get(given.elements, "subject.elements") }?.rust();
        let rows = Resource::Triangles;
        let order = unsafe { slice(given.order, given.n_order, &limits, rows, "subject.order") }?;
        let pivots = (given.pivots, given.n_pivots);
        let pivots = unsafe { vec3s(pivots.0, pivots.1, &limits, rows, "subject.pivots") }?;
        let pivots = if pivots.is_empty() { &elements.centers } else { pivots };
        let ranking = Ranking { order: order.to_vec(), pivots: pivots.to_vec() };
        let tiers = match unsafe { get_opt(given.tiers, "subject.tiers") }? {
            Some(tiers) => Cow::Borrowed(tiers.rust()),
            None => Cow::Owned(vec![Tier::full(mesh, elements)]),
        };
        let kept = unsafe { few(given.kept, given.n_kept, TIERS_MAX, "subject.kept") }?;
        Ok(Held { mesh, elements, tiers, ranking, kept })
    }
}

/// Makes `subject`, of `size` bytes, the default: its mesh, elements and order must be set.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_subject_init(
    subject: *mut tree_lod_subject,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(subject, size) })
}

/// Scores of a pruned model against the full one, which is drawn once, for each of `n_lambdas` shares one for each view:
/// with `lambdas[i]` of the foliage's triangles, 0 to 1, and elements grown to `scales[i]` times their area, 0.01 to
/// 10,000 (lengths grow by its square root); `n_scales` is `n_lambdas`. `around` says from where to look, NULL for the
/// default; `scores` has room for `capacity` scores, at least `n_lambdas` times `tree_around_count`, those of
/// `lambdas[0]` first. `control` may be NULL.
///
/// `TREE_ERROR_INVALID` when the parts of the subject do not belong together,
/// `TREE_ERROR_PARAMETER` names what is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_subject_scores(
    subject: *const tree_lod_subject,
    lambdas: *const f32,
    n_lambdas: usize,
    scales: *const f32,
    n_scales: usize,
    around: *const tree_around,
    control: *const tree_control,
    scores: *mut tree_score,
    capacity: usize,
) -> tree_status {
    call(|| {
        let held = unsafe { tree_lod_subject::read(subject, control) }?;
        let around = unsafe { tree_around::read(around) }?;
        let limits = unsafe { limits(control) }?;
        let rows = Resource::Pixels;
        let lambdas = unsafe { slice(lambdas, n_lambdas, &limits, rows, "lambdas") }?;
        let scales = unsafe { slice(scales, n_scales, &limits, rows, "scales") }?;
        if n_scales != n_lambdas {
            let problem = format!("scales: {n_scales} rows, {n_lambdas} are needed");
            return Err(Failure::new(TREE_ERROR_INVALID, problem));
        }
        let at: Vec<(f32, f32)> = lambdas.iter().copied().zip(scales.iter().copied()).collect();
        room_for(around.cameras().len().saturating_mul(n_lambdas), capacity, "scores")?;
        let body = |control: &_| Ok(scores_at(&held.rust(), &at, &around, control)?);
        unsafe { fill_scores(scores, capacity, &run(control, body)?.concat()) }
    })
}

/// Finds when outlines should become simpler, and when elements should go: writes the number of elements with which
/// each tier should begin, for `kept` of a subject. Tiers that are better left out begin with one. `kept` has room
/// for `capacity` numbers, at least one for each tier of the subject (1 where it has none); what the subject has as
/// `kept` is not looked at. It takes about as long as a table for each tier. `control` may be NULL.
///
/// `TREE_ERROR_INVALID` when the parts of the subject do not belong together.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_plan(
    subject: *const tree_lod_subject,
    control: *const tree_control,
    kept: *mut u32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let held = unsafe { tree_lod_subject::read(subject, control) }?;
        room_for(held.tiers.len(), capacity, "kept")?;
        let found = unsafe { run(control, |control| Ok(plan(&held.rust(), control)?)) }?;
        unsafe { fill_some(kept, capacity, &found, "kept") }
    })
}
