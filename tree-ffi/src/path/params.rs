//! What a path-planned tree is made of.

use super::level::{placing, tree_path_level, tree_path_placing};
use super::preset;
use super::terrain::{cost_field, obstacle, paints, tree_cost_fn, tree_paint};
use crate::allometry::tree_radius_rule;
use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, Versioned, call, get, init, out_value, read,
    read_or_default, read_rows, tree_status, vec3s,
};
use crate::control::{limits, tree_control};
use crate::foliage::tree_leaf_params;
use crate::tree::tree_species;
use crate::volume::tree_volume;
use std::ffi::c_void;
use tree_model::path::{Endpoints, Lifespan, LinkParams, MAX_LEVELS, PathParams};
use tree_model::tree_core::{Limits, Resource};

/// How many levels a branch goes on for: one of the `TREE_PATH_LIFESPAN_` constants.
pub type tree_path_lifespan = u32;
/// Through all levels.
pub const TREE_PATH_LIFESPAN_FULL: u32 = 0;
/// At each level a branch ends with the chance `lifespan_stop`; else the number of levels left, L, falls
/// by a number drawn from 0 to L. Makes irregular, livelier trees.
pub const TREE_PATH_LIFESPAN_RANDOM: u32 = 1;

/// Everything that shapes a tree of least-cost paths. Lengths in metres, angles in radians. Begin with
/// `tree_path_params_init`, which makes it an oak, or with `tree_path_preset`. What the structs of presets
/// point at belongs to the library, lives for ever and is not to be written: to alter levels, copy them
/// to an array of your own and point at that.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct tree_path_params {
    /// `sizeof(tree_path_params)`.
    pub struct_size: usize,
    /// The volume of level 1: trunk and crown, or root ball; bounded. It decides the shape of the tree
    /// more than all else. Oak: a trunk of 3 m under a round crown, 10.4 m high.
    pub volume: *const tree_volume,
    /// Where all paths end; inside `volume` or within linking distance. Oak: the origin.
    pub root: [f32; 3],
    /// Nodes of the level 1 graph, 8 to `tree_limits.graph_nodes`; the graph has this many within about a
    /// tenth. More make branches finer and cost time in proportion. Oak: 5000.
    pub graph_nodes: u32,
    /// Endpoints of level 1 drawn at random, at most 10,000. Oak: 24.
    pub endpoints_random: u32,
    /// Where random endpoints may lie. Oak: `TREE_PATH_PLACING_VOLUME`.
    pub endpoints_placing: tree_path_placing,
    /// Candidates drawn for each random endpoint, of which the one farthest from all others is taken, 1
    /// to 64. More spread the branches evenly and cost time with the square of `endpoints_random`. Oak: 4.
    pub endpoints_candidates: u32,
    /// Random endpoints lie above this share of the volume's height, 0 to 0.95; keeps main branches off
    /// the trunk. Oak: 0.25.
    pub endpoints_above: f32,
    /// Endpoints placed by hand, three floats each. Oak: NULL.
    pub placed: *const f32,
    /// Number of endpoints placed by hand.
    pub n_placed: usize,
    /// Radius of the subgraphs of level 2 in metres, above 0. Oak: 2.2.
    pub size: f32,
    /// Ratio of the subgraph radii of successive levels, 0.05 to 2. Oak: 0.62.
    pub shrink: f32,
    /// Levels 2 and on. Oak: three.
    pub levels: *const tree_path_level,
    /// Number of those levels, at most 16.
    pub n_levels: usize,
    /// How long branches live. Oak: `TREE_PATH_LIFESPAN_FULL`.
    pub lifespan: tree_path_lifespan,
    /// Random lifespan: chance to end at each level, 0 to 1; the authors use 0.3. Oak: 0.
    pub lifespan_stop: f32,
    /// Linking distance in separations, 1.2 to 4. Oak: 2. More links make straighter paths and cost time
    /// and memory with the third power; under 1.6 graphs fall apart.
    pub linking_reach: f32,
    /// An edge costs its length times a random weight from this to 1; 0.01 to 1. Low values make crooked
    /// branches that run together, 1 makes straight ones. Oak: 0.2.
    pub linking_low: f32,
    /// Weights are `low + (1 - low) * u^bias` with u uniform in 0 to 1; 0.1 to 10. Above 1 cheap edges
    /// are many, below 1 few. Oak: 1.
    pub linking_bias: f32,
    /// Smoothing passes over the branches, 0 to 50; each takes away some of the zigzag from node to node.
    /// Oak: 3.
    pub smoothing: u32,
    /// Painted edge costs; where several overlap, they multiply. Oak: NULL.
    pub paints: *const tree_paint,
    /// Number of paints, at most 65,536.
    pub n_paints: usize,
    /// A cost factor for every point, multiplied with the paints. Oak: NULL.
    pub cost: tree_cost_fn,
    /// Handed to `cost`.
    pub cost_user: *mut c_void,
    /// What no path may enter. Oak: NULL.
    pub obstacle: *const tree_volume,
    /// How thick branches are; NULL for the defaults of `tree_radius_rule_init`. Oak: the pipe model,
    /// scaled to its trunk.
    pub radii: *const tree_radius_rule,
    /// Leaves; NULL for none. Oak: clusters of oak leaves.
    pub leaves: *const tree_leaf_params,
    /// Names of species, bark and leaves; NULL for an oak's. With leaves it must have the kind that they
    /// name.
    pub species: *const tree_species,
    /// A root system, grown by the same method from the same root. Its own `root` and `leaves` are
    /// ignored; its own `roots` must be NULL. Oak: NULL.
    pub roots: *const tree_path_params,
    /// Distance to keep from the obstacle in metres, 0 or more. Oak: 0.
    pub clearance: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_path_params {
    const NAME: &'static str = "tree_path_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        preset::oak()
    }
}

impl tree_path_params {
    /// The parameters in Rust's form, not yet checked against their ranges; `name` is what they are called
    /// by.
    pub(super) unsafe fn rust(&self, limits: &Limits, name: &str) -> Result<PathParams> {
        let above = unsafe { self.without_roots(limits, name) }?;
        if self.roots.is_null() {
            return Ok(above);
        }
        let name = format!("{name}.roots");
        let roots = unsafe { read(self.roots, &name) }?;
        if !roots.roots.is_null() {
            let text = format!("{name}.roots is not NULL, but roots have no roots");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        let below = unsafe { roots.without_roots(limits, &name) }?;
        Ok(PathParams { roots: Some(Box::new(below)), ..above })
    }

    unsafe fn without_roots(&self, limits: &Limits, name: &str) -> Result<PathParams> {
        let part = |field: &str| format!("{name}.{field}");
        let leaves = if self.leaves.is_null() {
            None
        } else {
            Some(unsafe { read(self.leaves, &part("leaves")) }?.rust()?)
        };
        let species = if self.species.is_null() {
            Default::default()
        } else {
            unsafe { read(self.species, &part("species"))?.rust(&part("species")) }?
        };
        Ok(PathParams {
            volume: unsafe { get(self.volume, &part("volume")) }?.rust().clone(),
            root: self.root.into(),
            graph_nodes: self.graph_nodes,
            endpoints: unsafe { self.endpoints(limits, name) }?,
            size: self.size,
            shrink: self.shrink,
            levels: unsafe { read_rows(self.levels, self.n_levels, MAX_LEVELS, &part("levels")) }?
                .iter()
                .enumerate()
                .map(|(i, level)| unsafe { level.rust(&part(&format!("levels[{i}]"))) })
                .collect::<Result<_>>()?,
            lifespan: self.lifespan(name)?,
            linking: LinkParams {
                reach: self.linking_reach,
                low: self.linking_low,
                bias: self.linking_bias,
            },
            paint: unsafe { paints(self.paints, self.n_paints, &part("paints")) }?,
            cost: cost_field(self.cost, self.cost_user),
            obstacle: unsafe { obstacle(self.obstacle, self.clearance, &part("obstacle")) }?,
            smoothing: self.smoothing,
            radii: unsafe { read_or_default(self.radii, &part("radii")) }?.rust()?,
            leaves,
            species,
            roots: None,
        })
    }

    unsafe fn endpoints(&self, limits: &Limits, name: &str) -> Result<Endpoints> {
        let part = |field: &str| format!("{name}.{field}");
        let (n, resource) = (self.n_placed, Resource::GraphNodes);
        let placed = unsafe { vec3s(self.placed, n, limits, resource, &part("placed")) }?;
        Ok(Endpoints {
            random: self.endpoints_random,
            placing: placing(self.endpoints_placing, &part("endpoints_placing"))?,
            candidates: self.endpoints_candidates,
            above: self.endpoints_above,
            placed: placed.to_vec(),
        })
    }

    fn lifespan(&self, name: &str) -> Result<Lifespan> {
        match self.lifespan {
            TREE_PATH_LIFESPAN_FULL => Ok(Lifespan::Full),
            TREE_PATH_LIFESPAN_RANDOM => Ok(Lifespan::Random { stop: self.lifespan_stop }),
            other => {
                Err(Failure::not_one_of(&format!("{name}.lifespan"), other, "TREE_PATH_LIFESPAN_"))
            }
        }
    }
}

/// Makes `params`, of `size` bytes, an oak: a good tree to begin with.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_path_params_init(
    params: *mut tree_path_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks that all parameters lie in their ranges, as `tree_path_grow` does first. `params` may be NULL for
/// an oak; `control` may be NULL, only its limits matter.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_path_params_check(
    params: *const tree_path_params,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let params = unsafe { read_or_default(params, "params") }?;
        Ok(unsafe { params.rust(&limits(control)?, "params") }?.validate()?)
    })
}

/// Radius in metres of the subgraphs of `params->levels[index]`: its own, or the one that follows from
/// `size` and `shrink`. `params` may be NULL for an oak.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_path_level_radius(
    params: *const tree_path_params,
    index: usize,
    radius: *mut f32,
) -> tree_status {
    call(|| {
        let params = unsafe { read_or_default(params, "params") }?;
        if index >= params.n_levels {
            let text = format!("index is {index}, but there are {} levels", params.n_levels);
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        let params = unsafe { params.rust(&Limits::default(), "params") }?;
        unsafe { out_value(radius, params.level_size(index), "radius") }
    })
}
