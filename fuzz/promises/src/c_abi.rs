//! The C ABI: the input is a program of calls, each on objects that calls before have made, freed ones among them. What the generated
//! caller in `tree-ffi/tests/hostile.rs` does to each function alone, this does in orders that nobody has thought of.

use crate::script::Script;
use std::ffi::{CStr, c_char, c_void};
use std::ptr::{null, null_mut};
use tree_ffi::*;

/// Calls of one input: each is quick, many are not.
const MOST_CALLS: usize = 24;

/// A program of calls: no call panics, each tells what became of it, and all that was made can be freed.
pub fn c_abi(data: &[u8]) {
    let before = tree_live_objects();
    let mut script = Script(data);
    let mut world = World::default();
    for _ in 0..MOST_CALLS {
        if !script.goes_on() {
            break;
        }
        world.call(&mut script);
    }
    world.end();
    assert_eq!(tree_live_objects(), before, "objects are left");
}

/// Objects of one kind, whether they live or not.
struct Objects<T>(Vec<*mut T>);

impl<T> Default for Objects<T> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<T> Objects<T> {
    /// One that was made before; NULL, or what never was an object, where there is none.
    fn pick(&self, script: &mut Script<'_>) -> *mut T {
        match (usize::from(script.byte()), self.0.len()) {
            (at, n) if n > 0 && at < 250 => self.0[n - 1 - at % n],
            (255, _) => 16 as *mut T,
            _ => null_mut(),
        }
    }

    /// Takes in what a call handed out: an object if it succeeded, else NULL.
    fn put(&mut self, status: tree_status, made: *mut T) {
        told(status);
        assert_eq!(status == TREE_OK, !made.is_null(), "status {status}");
        if !made.is_null() {
            self.0.push(made);
        }
    }
}

/// What every call promises of its status.
fn told(status: tree_status) {
    assert_ne!(status, TREE_ERROR_PANIC, "{}", text());
    assert!(status == TREE_OK || !text().is_empty(), "status {status} has no text");
}

fn text() -> String {
    // SAFETY: the text lives until this thread's next call.
    unsafe { CStr::from_ptr(tree_error_text()) }.to_string_lossy().into_owned()
}

/// Structs without pointers: any bits are a value that the library must judge.
///
/// # Safety
/// Only for those.
unsafe trait Plain: Copy {
    const INIT: unsafe extern "C" fn(*mut Self, usize) -> tree_status;
}

macro_rules! plain {
    ($($name:ident $init:ident),*) => {
        // SAFETY: numbers alone.
        $(unsafe impl Plain for $name {
            const INIT: unsafe extern "C" fn(*mut Self, usize) -> tree_status = $init;
        })*
    };
}

plain!(
    tree_mesh_params tree_mesh_params_init,
    tree_clean_params tree_clean_params_init,
    tree_plastic_params tree_plastic_params_init,
    tree_scan_params tree_scan_params_init,
    tree_edit_params tree_edit_params_init,
    tree_limits tree_limits_init
);

/// The defaults with up to three words changed, its size among them.
fn params<T: Plain>(script: &mut Script<'_>) -> T {
    let size = size_of::<T>();
    let mut params = std::mem::MaybeUninit::<T>::zeroed();
    // SAFETY: room for one, which init fills.
    assert_eq!(unsafe { T::INIT(params.as_mut_ptr(), size) }, TREE_OK);
    for _ in 0..script.byte() % 4 {
        let (at, value) = (usize::from(script.byte()) % (size / 4), script.float());
        // A size that is too large would promise memory that is not there.
        if at >= 2 {
            // SAFETY: within the struct, whose fields are numbers of four bytes and more.
            unsafe { params.as_mut_ptr().cast::<f32>().add(at).write(value) };
        }
    }
    // SAFETY: any bits are a value.
    unsafe { params.assume_init() }
}

/// Ends work that has become long.
unsafe extern "C" fn patience(told: *mut c_void, _: *const c_char, _: f32) -> i32 {
    // SAFETY: the counter of the call; one report at a time.
    let told = unsafe { &mut *told.cast::<u32>() };
    *told += 1;
    i32::from(*told > 200)
}

#[derive(Default)]
struct World {
    skeletons: Objects<tree_skeleton>,
    swcs: Objects<tree_swc>,
    trees: Objects<tree_tree>,
    looks: Objects<tree_look>,
    meshes: Objects<tree_mesh>,
    bytes: Objects<tree_bytes>,
    grammars: Objects<tree_grammar>,
    words: Objects<tree_word>,
    drawings: Objects<tree_drawing>,
    plans: Objects<tree_plan>,
    multires: Objects<tree_multires>,
    clouds: Objects<tree_cloud>,
    scans: Objects<tree_scanned>,
    volumes: Objects<tree_volume>,
    plastics: Objects<tree_plastic>,
    scenes: Objects<tree_plastic_scene>,
    adapted: Objects<tree_adapted>,
    ids: Vec<u64>,
}

impl World {
    fn call(&mut self, script: &mut Script<'_>) {
        let mut limits: tree_limits = params(&mut Script(&[]));
        limits.nodes = 500;
        limits.triangles = 5_000;
        limits.leaves = 500;
        limits.modules = 2_000;
        limits.pixels = 1 << 12;
        limits.voxels = 1 << 12;
        limits.pairs = 100_000;
        let mut n_told = 0_u32;
        let control = tree_control {
            struct_size: size_of::<tree_control>(),
            progress: Some(patience),
            user: (&raw mut n_told).cast(),
            cancel: null(),
            limits: &raw const limits,
            pool: null(),
        };
        match script.byte() % 8 {
            0 => self.wood(script, &control),
            1 => self.grammar(script, &control),
            2 => self.drawing(script, &control),
            3 => self.mesh(script, &control),
            4 => self.levels(script, &control),
            5 => self.scan(script, &control),
            6 => self.plastic(script, &control),
            _ => self.free(script),
        }
    }

    fn wood(&mut self, script: &mut Script<'_>, control: &tree_control) {
        // SAFETY (here and below): pointers are NULL, of the kind asked for, or refused; arrays are as long as is said.
        unsafe {
            match script.byte() % 6 {
                how @ 0..=1 => {
                    let n = usize::from(script.byte() % 24);
                    let positions = script.floats(3 * n);
                    let radii = script.floats(n);
                    let parent = |_| match script.byte() {
                        255 => TREE_NO_PARENT,
                        other => other.into(),
                    };
                    let parents: Vec<u32> = (0..n).map(parent).collect();
                    let columns = tree_skeleton_columns {
                        struct_size: size_of::<tree_skeleton_columns>(),
                        n_nodes: n,
                        positions: positions.as_ptr(),
                        radii: radii.as_ptr(),
                        parents: parents.as_ptr(),
                    };
                    let (mut made, mut rows) = (null_mut(), vec![0_u32; n]);
                    let status = if how == 0 {
                        tree_skeleton_from_columns(&columns, control, &mut made)
                    } else {
                        let rows = rows.as_mut_ptr();
                        tree_skeleton_from_unordered(&columns, control, rows, &mut made)
                    };
                    self.skeletons.put(status, made);
                }
                2 => {
                    let (text, mut made) = (script.part(), null_mut());
                    let (at, len) = (text.as_ptr().cast(), text.len());
                    let status = tree_swc_from_text(at, len, null(), control, &mut made);
                    self.swcs.put(status, made);
                }
                3 => {
                    let mut made = null_mut();
                    let status = tree_swc_skeleton(self.swcs.pick(script), &mut made);
                    self.skeletons.put(status, made);
                }
                4 => {
                    let params: tree_edit_params = params(script);
                    let (one, two) = (self.skeletons.pick(script), self.skeletons.pick(script));
                    let mut distance = tree_edit_distance {
                        struct_size: size_of::<tree_edit_distance>(),
                        ..std::mem::zeroed()
                    };
                    told(tree_skeleton_distance(one, two, &params, control, &mut distance));
                }
                _ => self.tree(script, control),
            }
        }
    }

    fn tree(&mut self, script: &mut Script<'_>, control: &tree_control) {
        let skeleton = self.skeletons.pick(script);
        let n = usize::from(script.byte() % 8);
        let nodes: Vec<u32> = (0..n).map(|_| script.byte().into()).collect();
        let (positions, rotations) = (script.floats(3 * n), script.floats(4 * n));
        let (sizes, kinds) = (script.floats(n), vec![0_u16; n]);
        let foliage = tree_foliage {
            struct_size: size_of::<tree_foliage>(),
            n_leaves: n,
            nodes: nodes.as_ptr(),
            positions: positions.as_ptr(),
            rotations: rotations.as_ptr(),
            sizes: sizes.as_ptr(),
            kinds: kinds.as_ptr(),
        };
        let mut made = null_mut();
        let status = unsafe { tree_tree_new(skeleton, &foliage, null(), control, &mut made) };
        self.trees.put(status, made);
    }

    fn grammar(&mut self, script: &mut Script<'_>, control: &tree_control) {
        unsafe {
            match script.byte() % 5 {
                0 => {
                    let (text, mut made) = (script.part(), null_mut());
                    let (at, len) = (text.as_ptr().cast(), text.len());
                    let status = tree_grammar_from_text(at, len, control, null_mut(), &mut made);
                    self.grammars.put(status, made);
                }
                1 => {
                    let (text, mut made) = (script.part(), null_mut());
                    let (at, len) = (text.as_ptr().cast(), text.len());
                    let status = tree_word_from_text(at, len, control, null_mut(), &mut made);
                    self.words.put(status, made);
                }
                2 => {
                    let (grammar, steps) = (self.grammars.pick(script), script.byte() % 16);
                    let mut made = null_mut();
                    let status = tree_grammar_derive(grammar, steps.into(), 1, control, &mut made);
                    self.words.put(status, made);
                }
                3 => {
                    let (word, mut made) = (self.words.pick(script), null_mut());
                    let none = null_mut();
                    let status =
                        tree_word_interpret(word, null(), control, none, null_mut(), &mut made);
                    self.trees.put(status, made);
                }
                _ => {
                    let (tree, mut made) = (self.trees.pick(script), null_mut());
                    self.words.put(tree_tree_to_word(tree, null(), control, &mut made), made);
                }
            }
        }
    }

    fn drawing(&mut self, script: &mut Script<'_>, control: &tree_control) {
        unsafe {
            match script.byte() % 3 {
                how @ 0..=1 => {
                    let (text, mut made) = (script.part(), null_mut());
                    let (at, len) = (text.as_ptr().cast(), text.len());
                    let status = if how == 0 {
                        tree_drawing_from_json(at, len, control, &mut made)
                    } else {
                        tree_drawing_from_svg(at, len, control, &mut made)
                    };
                    self.drawings.put(status, made);
                }
                _ => {
                    let params: tree_clean_params = params(script);
                    let (drawing, mut made) = (self.drawings.pick(script), null_mut());
                    self.plans.put(tree_drawing_clean(drawing, &params, control, &mut made), made);
                }
            }
        }
    }

    fn mesh(&mut self, script: &mut Script<'_>, control: &tree_control) {
        unsafe {
            match script.byte() % 4 {
                0 => {
                    let mut made = null_mut();
                    self.looks.put(tree_look_plain(null(), &mut made), made);
                }
                1 => {
                    let params: tree_mesh_params = params(script);
                    let (tree, look) = (self.trees.pick(script), self.looks.pick(script));
                    let mut made = null_mut();
                    let status =
                        tree_mesh_build(tree, look, &params, control, null_mut(), &mut made);
                    self.meshes.put(status, made);
                }
                2 => {
                    let (format, data) = (script.byte() % 4, script.part());
                    let (at, len) = (data.as_ptr(), data.len());
                    let (format, none, mut made) = (format.into(), null_mut(), null_mut());
                    let status =
                        tree_mesh_from_bytes(format, at, len, null(), 0, control, none, &mut made);
                    self.meshes.put(status, made);
                }
                _ => {
                    let (mesh, mut made) = (self.meshes.pick(script), null_mut());
                    let status = tree_mesh_to_glb(mesh, null(), control, &mut made);
                    self.bytes.put(status, made);
                }
            }
        }
    }

    fn levels(&mut self, script: &mut Script<'_>, control: &tree_control) {
        unsafe {
            match script.byte() % 4 {
                0 => {
                    let (tree, mut made) = (self.trees.pick(script), null_mut());
                    let status = tree_multires_new(tree, null(), 1, control, &mut made);
                    self.multires.put(status, made);
                }
                1 => {
                    let (levels, mut made) = (self.multires.pick(script), null_mut());
                    let status =
                        tree_multires_to_stream(levels, usize::MAX, null(), control, &mut made);
                    self.bytes.put(status, made);
                }
                2 => {
                    // What this library wrote, cut and with a byte changed.
                    let (mut at, mut len) = (null(), 0);
                    let status = tree_bytes_view(self.bytes.pick(script), &mut at, &mut len);
                    told(status);
                    let mut data = script.part().to_vec();
                    if status == TREE_OK {
                        data = std::slice::from_raw_parts(at, len).to_vec();
                        let (cut, flipped) = (script.word() as usize, script.word() as usize);
                        data.truncate(len - if cut % 2 == 0 { 0 } else { cut % (len + 1) });
                        if let Some(byte) = data.get_mut(flipped) {
                            *byte ^= 1;
                        }
                    }
                    let (at, len, none) = (data.as_ptr(), data.len(), null_mut());
                    let mut made = null_mut();
                    let status = tree_multires_from_stream(at, len, control, none, &mut made);
                    self.multires.put(status, made);
                }
                _ => {
                    let (levels, n) = (self.multires.pick(script), usize::from(script.byte()));
                    let mut made = null_mut();
                    let status = tree_multires_tree_at(levels, n, control, &mut made);
                    self.trees.put(status, made);
                }
            }
        }
    }

    fn scan(&mut self, script: &mut Script<'_>, control: &tree_control) {
        unsafe {
            match script.byte() % 3 {
                0 => {
                    let (format, data) = (script.byte() % 4, script.part());
                    let (at, len, mut made) = (data.as_ptr(), data.len(), null_mut());
                    let status = tree_cloud_from_bytes(format.into(), at, len, control, &mut made);
                    self.clouds.put(status, made);
                }
                1 => {
                    let params: tree_scan_params = params(script);
                    let (cloud, mut made) = (self.clouds.pick(script), null_mut());
                    let status =
                        tree_skeletonize_cloud(cloud, &params, control, null_mut(), &mut made);
                    self.scans.put(status, made);
                }
                _ => {
                    let (scan, at) = (self.scans.pick(script), usize::from(script.byte() % 4));
                    let mut made = null_mut();
                    self.skeletons.put(tree_scanned_skeleton(scan, at, &mut made), made);
                }
            }
        }
    }

    fn plastic(&mut self, script: &mut Script<'_>, control: &tree_control) {
        unsafe {
            match script.byte() % 8 {
                0 => {
                    let (min, max) = (script.point(), script.point());
                    let mut made = null_mut();
                    let status = tree_volume_box(min.as_ptr(), max.as_ptr(), &mut made);
                    self.volumes.put(status, made);
                }
                1 => {
                    let (center, radius, mut made) = (script.point(), script.float(), null_mut());
                    let status = tree_volume_sphere(center.as_ptr(), radius, &mut made);
                    self.volumes.put(status, made);
                }
                2 => {
                    let several = [self.volumes.pick(script), self.volumes.pick(script)];
                    let several = several.map(<*mut tree_volume>::cast_const);
                    let mut made = null_mut();
                    self.volumes.put(tree_volume_union(several.as_ptr(), 2, &mut made), made);
                }
                3 => {
                    let params: tree_plastic_params = params(script);
                    let (tree, mut made) = (self.trees.pick(script), null_mut());
                    let status = tree_plastic_new(tree, &params, control, null_mut(), &mut made);
                    self.plastics.put(status, made);
                }
                4 => {
                    let mut made = null_mut();
                    let status = tree_plastic_scene_new(null(), null(), &mut made);
                    self.scenes.put(status, made);
                }
                5 => {
                    let (scene, mut id) = (self.scenes.pick(script), 0);
                    let status = if script.byte().is_multiple_of(2) {
                        let tree = self.plastics.pick(script);
                        tree_plastic_scene_add_tree(scene, tree, null(), &mut id)
                    } else {
                        let volume = self.volumes.pick(script);
                        tree_plastic_scene_add_obstacle(scene, volume, null(), &mut id)
                    };
                    told(status);
                    self.ids.push(id);
                }
                6 => {
                    let scene = self.scenes.pick(script);
                    told(tree_plastic_scene_update(scene, control, null_mut()));
                }
                _ => {
                    let (scene, at) = (self.scenes.pick(script), usize::from(script.byte()));
                    let id = self.ids.get(at).copied().unwrap_or(at as u64);
                    let (none, mut made) = (null_mut(), null_mut());
                    let status = tree_plastic_scene_adapted(scene, id, control, none, &mut made);
                    self.adapted.put(status, made);
                    let mut tree = null_mut();
                    let status = tree_adapted_tree(self.adapted.pick(script), &mut tree);
                    self.trees.put(status, tree);
                }
            }
        }
    }
}

/// `free` frees one object of a kind that the script names, which stays among the objects; `end` frees all.
macro_rules! freed {
    ($($field:ident $free:ident),* $(,)?) => {
        impl World {
            fn free(&mut self, script: &mut Script<'_>) {
                let kind = script.byte() % [$(stringify!($field)),*].len() as u8;
                let mut number = 0;
                $(
                    if kind == number {
                        // SAFETY: freed, foreign and NULL are refused or do nothing.
                        told(unsafe { $free(self.$field.pick(script)) });
                    }
                    number += 1;
                )*
                assert!(kind < number);
            }

            fn end(self) {
                $(
                    for object in self.$field.0 {
                        // SAFETY: as above.
                        told(unsafe { $free(object) });
                    }
                )*
            }
        }
    };
}

freed!(
    skeletons tree_skeleton_free,
    swcs tree_swc_free,
    trees tree_tree_free,
    looks tree_look_free,
    meshes tree_mesh_free,
    bytes tree_bytes_free,
    grammars tree_grammar_free,
    words tree_word_free,
    drawings tree_drawing_free,
    plans tree_plan_free,
    multires tree_multires_free,
    clouds tree_cloud_free,
    scans tree_scanned_free,
    volumes tree_volume_free,
    plastics tree_plastic_free,
    scenes tree_plastic_scene_free,
    adapted tree_adapted_free,
);
