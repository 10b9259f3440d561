//! Branches find their places: the Gibbs process, and the test of what it gives.

use super::place::arrangement_of;
use super::{tree_arrangement, tree_domain, tree_site};
use crate::border::{
    Handle, Versioned, call, foresee, free, get, init, out, out_value, read, read_or_default,
    slice, tree_status, view, write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use tree_model::silhouette::place::concentration::BINS;
use tree_model::silhouette::place::{
    Arranged, Concentration, Domain, GibbsParams, Site, arrange, privileged, ready,
};
use tree_model::tree_core::{Resource, Seed};

/// How places are found. Begin with `tree_gibbs_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_gibbs_params {
    /// `sizeof(tree_gibbs_params)`.
    pub struct_size: usize,
    /// How quickly branches stop to keep others away, 0 to 1000 for a distance of the whole length. Default 20.
    pub reach: f32,
    /// Weight of closeness, 0 to 1000. Default 2.
    pub closeness: f32,
    /// Weight of the pattern, 0 to 1000. Default 1.
    pub pattern: f32,
    /// Most moves, 0 to 1,000,000. Default 3000.
    pub moves: u32,
    /// The process ends when four moves of each branch lower the cost by less than this share, 0 to 1. Default 0.0001.
    /// 0 makes all moves.
    pub quiet: f32,
    /// How far branches of a node stand off from it along the parent, as a share of the average node length, 0 to 0.5.
    /// Default 0.06.
    pub scatter: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_gibbs_params {
    const NAME: &'static str = "tree_gibbs_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&GibbsParams::default())
    }
}

impl tree_gibbs_params {
    pub(crate) fn of(params: &GibbsParams) -> Self {
        let GibbsParams { reach, closeness, pattern, moves, quiet, scatter } = *params;
        let struct_size = size_of::<Self>();
        Self { struct_size, reach, closeness, pattern, moves, quiet, scatter }
    }

    pub(crate) fn rust(&self) -> GibbsParams {
        let Self { reach, closeness, pattern, moves, quiet, scatter, .. } = *self;
        GibbsParams { reach, closeness, pattern, moves, quiet, scatter }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_gibbs_params_init(
    params: *mut tree_gibbs_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_gibbs_params_check(params: *const tree_gibbs_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// How places came about.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_arranged_report {
    /// `sizeof(tree_arranged_report)`.
    pub struct_size: usize,
    /// The total cost of the places.
    pub cost: f32,
    /// Moves tried.
    pub moves: u32,
    /// Moves kept.
    pub accepted: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_arranged_report {
    const NAME: &'static str = "tree_arranged_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self { struct_size: size_of::<Self>(), cost: 0.0, moves: 0, accepted: 0, reserved: 0 }
    }
}

/// Places that branches found.
pub struct tree_arranged {
    sites: Vec<tree_site>,
    trace: Vec<f32>,
}

impl Handle for tree_arranged {
    const NAME: &'static str = "tree_arranged";
}

impl tree_arranged {
    fn new(sites: &[Site], trace: Vec<f32>) -> Self {
        Self { sites: sites.iter().map(tree_site::of).collect(), trace }
    }
}

/// Finds a place in each of `n_domains` domains, at most 20,000, by a Gibbs process: branches keep apart, and keep to the
/// pattern of `arrangement`. The same seed gives the same places. `params`, `control` and `report` may be NULL. Free the
/// places with `tree_arranged_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_arranged_new(
    domains: *const tree_domain,
    n_domains: usize,
    arrangement: *const tree_arrangement,
    params: *const tree_gibbs_params,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_arranged_report,
    arranged: *mut *mut tree_arranged,
) -> tree_status {
    call(|| {
        let place = unsafe { out(arranged, "arranged") }?;
        unsafe { foresee(report, "report") }?;
        let limits = unsafe { limits(control) }?;
        let rows = unsafe { slice(domains, n_domains, &limits, Resource::Nodes, "domains") }?;
        let domains: Vec<Domain> = rows.iter().map(|row: &tree_domain| row.rust()).collect();
        let arrangement = unsafe { arrangement_of(arrangement) }?;
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let made = unsafe {
            run(control, |control| {
                Ok(arrange(&domains, &arrangement, &params, Seed(seed), control)?)
            })
        }?;
        let Arranged { sites, cost, moves, accepted, trace } = made;
        let told = tree_arranged_report { cost, moves, accepted, ..Versioned::default_value() };
        unsafe { view(report, "report", &told) }?;
        place.put(tree_arranged::new(&sites, trace));
        Ok(())
    })
}

/// A ready pattern of `n` branches, at most 20,000, that may stand anywhere, sorted along the parent. Other variants are
/// other draws of the same seed. It has no trace. `control` may be NULL. Free the places with `tree_arranged_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_arranged_ready(
    n: u32,
    arrangement: *const tree_arrangement,
    variant: u64,
    seed: u64,
    control: *const tree_control,
    arranged: *mut *mut tree_arranged,
) -> tree_status {
    call(|| {
        let place = unsafe { out(arranged, "arranged") }?;
        let arrangement = unsafe { arrangement_of(arrangement) }?;
        unsafe { limits(control) }?.check(Resource::Nodes, n.into())?;
        let body = |_: &_| Ok(ready(n, &arrangement, variant, Seed(seed))?);
        place.put(tree_arranged::new(&unsafe { run(control, body) }?, Vec::new()));
        Ok(())
    })
}

/// Views the places, one for each domain in their order: where they begin and how many there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_arranged_sites(
    arranged: *const tree_arranged,
    sites: *mut *const tree_site,
    n_sites: *mut usize,
) -> tree_status {
    call(|| {
        let found = &unsafe { get(arranged, "arranged") }?.sites;
        unsafe { out_value(sites, column(found), "sites") }?;
        unsafe { out_value(n_sites, found.len(), "n_sites") }
    })
}

/// Views the cost at the start and after each kept move, which never rises: where the numbers begin and how many there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_arranged_trace(
    arranged: *const tree_arranged,
    costs: *mut *const f32,
    n_costs: *mut usize,
) -> tree_status {
    call(|| {
        let found = &unsafe { get(arranged, "arranged") }?.trace;
        unsafe { out_value(costs, column(found), "costs") }?;
        unsafe { out_value(n_costs, found.len(), "n_costs") }
    })
}

/// Frees places.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_arranged_free(arranged: *mut tree_arranged) -> tree_status {
    call(|| unsafe { free(arranged, "arranged") })
}

/// Number of bins in `tree_concentration`.
pub const TREE_CONCENTRATION_BINS: usize = 12;
const _: () = assert!(TREE_CONCENTRATION_BINS == BINS);

/// How closely branches gather at the privileged positions of a pattern.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_concentration {
    /// `sizeof(tree_concentration)`.
    pub struct_size: usize,
    /// Angles tested.
    pub pairs: u32,
    /// Mean resultant length, 0 (evenly about) to 1 (all alike).
    pub resultant: f32,
    /// Where they gather, as an angle from the privileged position in radians.
    pub offset: f32,
    /// The probability that chance alone gathers them so closely.
    pub p_value: f32,
    /// Angles by twelfths of the angle between neighbours at a node, the first bin centred on the privileged position.
    pub histogram: [u32; TREE_CONCENTRATION_BINS],
    /// 1 where there is a pattern to keep to, else 0.
    pub has_pattern: u32,
    /// 1 where the test is passed: angles gather significantly (p below 0.001) and the fullest bin is the first; without a
    /// pattern, that they do not gather (p at least 0.05). Else 0.
    pub passes: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_concentration {
    const NAME: &'static str = "tree_concentration";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Concentration::default())
    }
}

impl tree_concentration {
    fn of(found: &Concentration) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            pairs: found.pairs,
            resultant: found.resultant,
            offset: found.offset,
            p_value: found.p_value,
            histogram: found.histogram,
            has_pattern: found.has_pattern.into(),
            passes: found.passes().into(),
        }
    }
}

/// Tests whether `n_sites` branches of one parent keep to an arrangement, by Rayleigh's test of the angles between
/// one and the next. `control` may be NULL; `nodes` of its limits caps the places. Set `concentration->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sites_privileged(
    sites: *const tree_site,
    n_sites: usize,
    arrangement: *const tree_arrangement,
    control: *const tree_control,
    concentration: *mut tree_concentration,
) -> tree_status {
    call(|| {
        unsafe { foresee(concentration, "concentration") }?;
        let limits = unsafe { limits(control) }?;
        let rows = unsafe { slice(sites, n_sites, &limits, Resource::Nodes, "sites") }?;
        let sites: Vec<Site> = rows.iter().map(|row: &tree_site| row.rust()).collect();
        let arrangement = unsafe { arrangement_of(arrangement) }?;
        let found = unsafe { run(control, |_| Ok(privileged(&sites, &arrangement))) }?;
        unsafe { write(concentration, "concentration", &tree_concentration::of(&found)) }
    })
}
