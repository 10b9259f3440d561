//! Photographs as they go in.

use crate::border::{
    Failure, Result, Versioned, call, get, get_opt, init, read, read_rows, tree_status, vec2s,
};
use crate::particle::view::VIEWS_MAX;
use crate::photo::{
    projection, strokes, tree_attractor, tree_matte, tree_particle_camera, tree_photo,
    tree_strokes_columns,
};
use tree_model::particle::session::{Attractor, Placing, Shot};
use tree_model::tree_core::{Limits, Resource};

/// Where a photograph was taken from: found in the matte, or as the caller knows. Begin with
/// `tree_photo_placing_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_photo_placing {
    /// `sizeof(tree_photo_placing)`.
    pub struct_size: usize,
    /// The camera, where it is known; then the other fields do not count. Default NULL: base, height and
    /// scale are found in the matte.
    pub camera: *const tree_particle_camera,
    /// Where the camera stood around the trunk, in radians: 0, the default, on +Z, a quarter turn on +X.
    pub yaw: f32,
    /// How far it looked down, in radians, -1.5 to 1.5. Default 0.
    pub pitch: f32,
    /// Vertical field of view of the whole picture in radians, 0.017 to 2.8; 0, the default, is parallel
    /// projection.
    pub fov: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_photo_placing {
    const NAME: &'static str = "tree_photo_placing";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            camera: std::ptr::null(),
            yaw: 0.0,
            pitch: 0.0,
            fov: 0.0,
            reserved: 0,
        }
    }
}

/// Makes `placing`, of `size` bytes, the default: aligned, from the front, from afar.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_placing_init(
    placing: *mut tree_photo_placing,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(placing, size) })
}

/// Where a photograph's main branches come from: one of the `TREE_BRANCHES_` constants.
pub type tree_branches_kind = u32;
/// Livewire from points on the silhouette.
pub const TREE_BRANCHES_LIVEWIRE: u32 = 0;
/// Livewire from `seeds`.
pub const TREE_BRANCHES_SEEDS: u32 = 1;
/// `strokes`, as a person drew them.
pub const TREE_BRANCHES_STROKES: u32 = 2;
/// `graph`.
pub const TREE_BRANCHES_GRAPH: u32 = 3;
/// None: this view's branches are left to chance.
pub const TREE_BRANCHES_NONE: u32 = 4;

/// A photograph's main branches. Begin with `tree_photo_branches_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_photo_branches {
    /// `sizeof(tree_photo_branches)`.
    pub struct_size: usize,
    /// Seeds: two floats for each point, in pixels from the top left. Default NULL.
    pub seeds: *const f32,
    /// Number of seeds.
    pub n_seeds: usize,
    /// Strokes: as `tree_attractor_from_strokes` takes them. Default NULL.
    pub strokes: *const tree_strokes_columns,
    /// Graph: the graph. Default NULL.
    pub graph: *const tree_attractor,
    /// Where they come from. Default `TREE_BRANCHES_LIVEWIRE`.
    pub kind: tree_branches_kind,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_photo_branches {
    const NAME: &'static str = "tree_photo_branches";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            seeds: std::ptr::null(),
            n_seeds: 0,
            strokes: std::ptr::null(),
            graph: std::ptr::null(),
            kind: TREE_BRANCHES_LIVEWIRE,
            reserved: 0,
        }
    }
}

/// Makes `branches`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_branches_init(
    branches: *mut tree_photo_branches,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(branches, size) })
}

/// One photograph as it goes in. Begin with `tree_photo_shot_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_photo_shot {
    /// `sizeof(tree_photo_shot)`.
    pub struct_size: usize,
    /// How much of each pixel the tree covers. No default: NULL, which is refused.
    pub matte: *const tree_matte,
    /// The photograph, of the same size, where livewire looks for branches. Default NULL: it looks at the
    /// matte.
    pub photo: *const tree_photo,
    /// Where it was taken from. Default NULL: from the front.
    pub placing: *const tree_photo_placing,
    /// Its main branches. Default NULL: livewire from points on the silhouette.
    pub branches: *const tree_photo_branches,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_photo_shot {
    const NAME: &'static str = "tree_photo_shot";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            matte: std::ptr::null(),
            photo: std::ptr::null(),
            placing: std::ptr::null(),
            branches: std::ptr::null(),
        }
    }
}

/// Makes `shot`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_shot_init(
    shot: *mut tree_photo_shot,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(shot, size) })
}

/// NULL is from the front.
pub(super) unsafe fn placing(placing: *const tree_photo_placing, name: &str) -> Result<Placing> {
    if placing.is_null() {
        return Ok(Placing::at(0.0));
    }
    let tree_photo_placing { camera, yaw, pitch, fov, .. } = unsafe { read(placing, name) }?;
    if camera.is_null() {
        return Ok(Placing::Aligned { yaw, pitch, projection: projection(fov) });
    }
    let name = format!("{name}.camera");
    let camera = unsafe { read(camera, &name) }?.rust();
    camera.validate(&name)?;
    Ok(Placing::Placed(camera))
}

/// NULL is livewire.
pub(super) unsafe fn branches(
    branches: *const tree_photo_branches,
    limits: &Limits,
    name: &str,
) -> Result<Attractor> {
    if branches.is_null() {
        return Ok(Attractor::Livewire);
    }
    let found = unsafe { read(branches, name) }?;
    let part = |field: &str| format!("{name}.{field}");
    match found.kind {
        TREE_BRANCHES_LIVEWIRE => Ok(Attractor::Livewire),
        TREE_BRANCHES_SEEDS => {
            let (n, nodes) = (found.n_seeds, Resource::Nodes);
            let seeds = unsafe { vec2s(found.seeds, n, limits, nodes, &part("seeds")) }?;
            Ok(Attractor::Seeds(seeds.to_vec()))
        }
        TREE_BRANCHES_STROKES => {
            let strokes = unsafe { strokes(found.strokes, limits, &part("strokes")) }?;
            Ok(Attractor::Strokes(strokes))
        }
        TREE_BRANCHES_GRAPH => {
            let graph = unsafe { get(found.graph, &part("graph")) }?.rust();
            Ok(Attractor::Graph(graph.clone()))
        }
        TREE_BRANCHES_NONE => Ok(Attractor::None),
        other => Err(Failure::not_one_of(&part("kind"), other, "TREE_BRANCHES_")),
    }
}

/// Copies of the photographs of an array.
pub(super) unsafe fn shots(
    first: *const tree_photo_shot,
    n: usize,
    limits: &Limits,
) -> Result<Vec<Shot>> {
    let rows = unsafe { read_rows(first, n, VIEWS_MAX, "shots") }?;
    let shot = |(i, row): (usize, &tree_photo_shot)| {
        let part = |field: &str| format!("shots[{i}].{field}");
        let photo = unsafe { get_opt(row.photo, &part("photo")) }?;
        Ok(Shot {
            matte: unsafe { get(row.matte, &part("matte")) }?.rust().clone(),
            photo: photo.map(|photo| photo.rust().clone()),
            placing: unsafe { placing(row.placing, &part("placing")) }?,
            attractor: unsafe { branches(row.branches, limits, &part("branches")) }?,
        })
    };
    rows.iter().enumerate().map(shot).collect()
}
