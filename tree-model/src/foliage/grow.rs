//! Leaves on all shoots.

use super::blade::{Bearer, Whole};
use super::form::Layout;
use super::sites::{Budget, DensityField, Tally, Walk};
use super::{LeafForm, LeafParams};
use crate::error::Result;
use std::sync::atomic::AtomicU64;
use tree_core::{Continuation, Control, Foliage, Leaf, Resource, Seed, Skeleton, SkeletonColumns};

/// Leaves and how they came about.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Leaves {
    /// The leaves, a row for each blade.
    pub foliage: Foliage,
    /// What was grown and what was not.
    pub report: LeafReport,
}

/// Leaves with their petioles and rachises as branches.
#[derive(Clone, Debug, PartialEq)]
pub struct StalkedLeaves {
    /// The old skeleton, node for node, then the stalks.
    pub skeleton: Skeleton,
    /// The leaves, borne by the stalks.
    pub foliage: Foliage,
    /// What was grown and what was not.
    pub report: LeafReport,
}

/// What growing leaves did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct LeafReport {
    /// Leaf-bearing nodes of the shoots (a whorl is one, a tip's leaf too).
    pub n_bearing: u64,
    /// Leaves; a compound leaf and a fascicle is one.
    pub n_leaves: u64,
    /// Blades: rows of the foliage.
    pub n_blades: u64,
    /// Bearing nodes that the density left out.
    pub n_thinned: u64,
    /// Bearing nodes where the density was negative or not a number, and counted as 0.
    pub n_bad_density: u64,
    /// Axes without a leaf.
    pub n_barren: u64,
    /// Nodes added for petioles and rachises.
    pub n_stalk_nodes: u64,
}

/// Grows leaves on `skeleton`.
///
/// Leaflets of a compound leaf name the shoot's node, so that a mesher that draws petioles leads each to
/// the shoot; [`grow_leaves_with_stalks`] gives them their rachis.
///
/// # Errors
/// [`ModelError::Parameter`](crate::ModelError::Parameter) or
/// [`ModelError::NotFinite`](crate::ModelError::NotFinite) for parameters out of range, where a kind
/// counts as valid whatever it is (the tree knows its kinds, see
/// [`Tree::new`](tree_core::Tree::new)); [`ModelError::Limit`](crate::ModelError::Limit) before
/// memory is taken; [`ModelError::Cancelled`](crate::ModelError::Cancelled);
/// [`ModelError::Core`](crate::ModelError::Core) where a leaf would end beyond what an f32 holds.
///
/// # Complexity
/// O(nodes + leaves).
pub fn grow_leaves(
    skeleton: &Skeleton,
    params: &LeafParams,
    seed: Seed,
    control: &Control,
) -> Result<Foliage> {
    Ok(grow(skeleton, params, None, false, seed, control)?.0.foliage)
}

/// Grows leaves where `density` asks for them: 0 none, 1 as many as `params` say, and so on in
/// proportion up to [`DENSITY_CAP`](super::DENSITY_CAP) times as many.
///
/// The density is asked once for every leaf-bearing node, from any thread, so that whorls stay whole.
/// Below 1 it is the chance that the node bears, above 1 further nodes stand between: the expected
/// number is proportional to it. Negative and NaN count as 0 and are reported.
///
/// # Errors
/// As [`grow_leaves`]. The limit on leaves holds for what the density leaves, but also for the number of
/// bearing nodes at density 1.
///
/// # Complexity
/// As [`grow_leaves`], and one call of `density` for each bearing node.
pub fn grow_leaves_in(
    skeleton: &Skeleton,
    params: &LeafParams,
    density: &DensityField<'_>,
    seed: Seed,
    control: &Control,
) -> Result<Leaves> {
    Ok(grow(skeleton, params, Some(density), false, seed, control)?.0)
}

/// Grows leaves as [`grow_leaves`] does, or with a density as [`grow_leaves_in`] does, and reports either
/// way.
///
/// # Errors
/// As [`grow_leaves`].
///
/// # Complexity
/// As [`grow_leaves_in`].
pub fn grow_leaves_and_report(
    skeleton: &Skeleton,
    params: &LeafParams,
    density: Option<&DensityField<'_>>,
    seed: Seed,
    control: &Control,
) -> Result<Leaves> {
    Ok(grow(skeleton, params, density, false, seed, control)?.0)
}

/// Grows leaves together with their petioles and rachises as thin branches, for close-ups: a mesher
/// draws them without knowing what a compound leaf is.
///
/// Stalks start at the nearer end of the segment that bears the leaf, so that no old node changes; each
/// leaflet names the stalk node it stands on as [`Leaf::node`]. `density` as in [`grow_leaves_in`].
///
/// # Errors
/// As [`grow_leaves`]; the limit on nodes holds for old and new together.
///
/// # Complexity
/// As [`grow_leaves`]; a node for each petiole and for each pair of leaflets.
pub fn grow_leaves_with_stalks(
    skeleton: &Skeleton,
    params: &LeafParams,
    density: Option<&DensityField<'_>>,
    seed: Seed,
    control: &Control,
) -> Result<StalkedLeaves> {
    let (leaves, wholes) = grow(skeleton, params, density, true, seed, control)?;
    let layout = params.form.layout();
    if params.petiole <= 0.0 && layout.stalks.len() < 2 {
        let Leaves { foliage, report } = leaves;
        return Ok(StalkedLeaves { skeleton: skeleton.clone(), foliage, report });
    }
    add_stalks(skeleton, params, &layout, &leaves, &wholes, control)
}

/// Leaves, and if they are wanted the leaves as wholes.
fn grow(
    skeleton: &Skeleton,
    params: &LeafParams,
    density: Option<&DensityField<'_>>,
    keep_wholes: bool,
    seed: Seed,
    control: &Control,
) -> Result<(Leaves, Vec<Whole>)> {
    params.validate(usize::from(u16::MAX) + 1)?;
    let axes = skeleton.axes(Continuation::Thickest);
    let to_tip = skeleton.distances_to_tip();
    let walk = Walk {
        skeleton,
        axes: &axes,
        to_tip: &to_tip,
        spacing: params.spacing,
        bearing: params.bearing,
        arrangement: params.arrangement,
        terminal: params.terminal,
        density,
    };
    let n_blades = u64::from(params.form.n_leaflets());
    let per_site = u64::from(params.arrangement.per_node()).saturating_mul(n_blades);
    let n_sites = walk.n_sites();
    control.limits.check(Resource::Leaves, n_sites)?;
    let budget = Budget {
        control,
        resource: Resource::Leaves,
        used: AtomicU64::new(0),
        most: n_sites.saturating_mul(per_site).saturating_mul(walk.most_each()),
    };
    let layout = params.form.layout();
    let light = params.light.normalize_or(glam::Vec3::Y);
    let bearer = Bearer { params, layout: &layout, light };
    let (parts, tally) = walk.parts(seed, &budget, |sites| {
        let n_terminal = sites.iter().filter(|site| site.terminal).count() as u64;
        let asked = (sites.len() as u64 - n_terminal) * per_site + n_terminal * n_blades;
        budget.ask(asked)?;
        let mut leaves = Vec::with_capacity(asked as usize);
        let mut wholes = Vec::new();
        for site in sites {
            bearer.bear(site, &mut leaves, keep_wholes.then_some(&mut wholes));
        }
        Ok((leaves, wholes))
    })?;
    let mut foliage = Foliage::with_capacity(parts.iter().map(|(leaves, _)| leaves.len()).sum());
    let mut all = Vec::with_capacity(parts.iter().map(|(_, wholes)| wholes.len()).sum());
    for (leaves, wholes) in parts {
        for leaf in leaves {
            foliage.push(leaf)?;
        }
        all.extend(wholes);
        control.check()?;
    }
    let report = report(&foliage, params.form, tally);
    Ok((Leaves { foliage, report }, all))
}

fn report(foliage: &Foliage, form: LeafForm, tally: Tally) -> LeafReport {
    let n_blades = foliage.len() as u64;
    LeafReport {
        n_bearing: tally.sites,
        n_leaves: n_blades / u64::from(form.n_leaflets()).max(1),
        n_blades,
        n_thinned: tally.thinned,
        n_bad_density: tally.bad_density,
        n_barren: tally.barren,
        n_stalk_nodes: 0,
    }
}

/// Appends a petiole, and a rachis where there is one, for every whole leaf.
fn add_stalks(
    skeleton: &Skeleton,
    params: &LeafParams,
    layout: &Layout,
    leaves: &Leaves,
    wholes: &[Whole],
    control: &Control,
) -> Result<StalkedLeaves> {
    let n_old = skeleton.len();
    let n_new = (wholes.len() as u64).saturating_mul(layout.stalks.len() as u64);
    control.limits.check(Resource::Nodes, (n_old as u64).saturating_add(n_new))?;
    let mut columns = SkeletonColumns::from(skeleton.clone());
    let mut foliage = Foliage::with_capacity(leaves.foliage.len());
    let mut rows = leaves.foliage.iter();
    for whole in wholes {
        let first = columns.parents.len() as u32;
        let host = whole.host;
        let host_radius = skeleton.radii().get(host as usize).copied().unwrap_or(0.0);
        let thickest = (params.petiole_radius * whole.size).min(host_radius);
        for stalk in &layout.stalks {
            let offset = whole.rotation * (stalk.offset * whole.size);
            columns.positions.push(whole.base + offset);
            columns.radii.push(thickest * stalk.radius);
            columns.parents.push(stalk.below.map_or(host, |below| first.saturating_add(below)));
        }
        for (leaflet, leaf) in layout.leaflets.iter().zip(rows.by_ref()) {
            foliage.push(Leaf { node: first.saturating_add(leaflet.stalk), ..leaf })?;
        }
    }
    let skeleton = Skeleton::try_from(columns)?;
    let report = LeafReport { n_stalk_nodes: n_new, ..leaves.report };
    Ok(StalkedLeaves { skeleton, foliage, report })
}
