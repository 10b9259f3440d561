//! C and C++ programs against the library, with the machine's compilers; under valgrind and gcc's
//! sanitizers where they are installed.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a test says what failed by failing"
)]

mod common;

use common::compile::{self, C11, CPP17, SANITIZE, files, here, root};
use common::header;
use glam::Vec3;
use std::path::PathBuf;
use std::process::Command;
use std::sync::Arc;
use tree_core::{Control, Seed, Tree, Volume};
use tree_lod::cover::Around;
use tree_lod::order::CoverageParams;
use tree_lod::prune::{MakeParams, PrunedModel};
use tree_mesh::{Look, MeshParams};
use tree_model::Modeler;
use tree_model::particle::Matte;
use tree_model::particle::session::{PhotoModel, PhotoParams, Shot};
use tree_model::path::PathParams;
use tree_model::plastic::{PlasticParams, PlasticTree, Pose, Response, Scene, Sky};

fn c_tests() -> Vec<PathBuf> {
    files(&here().join("tests/c"), "c")
}

fn alone(name: &str) -> Vec<PathBuf> {
    vec![here().join("tests/c_alone").join(name)]
}

fn oaks() -> [(&'static str, &'static [&'static str], PathBuf, &'static str); 2] {
    [
        ("cc", C11, root().join("examples/c/oak.c"), "oak_c"),
        ("c++", CPP17, root().join("examples/cpp/oak.cpp"), "oak_cpp"),
    ]
}

#[test]
fn every_function_works_from_c() {
    let program = compile::compile("cc", C11, &c_tests(), "c_test");
    let said = compile::run(&mut compile::command(&program));
    assert!(said.contains("all is well"), "{said}");
}

#[test]
fn every_function_is_called_by_a_c_test() {
    let sources: String =
        c_tests().iter().map(|path| std::fs::read_to_string(path).unwrap()).collect();
    let header = header::parse(&header::text());
    let names = header.functions.iter().map(|function| function.name.as_str());
    let missing: Vec<_> = names.filter(|name| !sources.contains(&format!("{name}("))).collect();
    assert!(missing.is_empty(), "tests/c calls none of {missing:?}");
}

/// A field that comes later must not lie in bytes that old programs never set.
#[test]
fn no_struct_has_padding() {
    let source = compile::folder("c_programs").join("padded.c");
    std::fs::write(&source, "#include \"tree.h\"\nint main(void) { return 0; }\n").unwrap();
    let flags = [C11, &["-Wpadded"]].concat();
    compile::compile("cc", &flags, &[source], "padded");
}

#[test]
fn a_host_brings_its_allocator() {
    let program = compile::compile("cc", C11, &alone("allocator.c"), "allocator");
    compile::run(&mut compile::command(&program));
}

#[test]
fn a_frame_of_a_scene_takes_no_memory() {
    let program = compile::compile("cc", C11, &alone("frame.c"), "frame");
    compile::run(&mut compile::command(&program));
}

#[test]
fn a_thousand_cycles_leave_nothing() {
    let program = compile::compile("cc", C11, &alone("soak.c"), "soak");
    compile::run(&mut compile::command(&program));
}

#[test]
fn c_cpp_and_rust_make_the_same_oak() {
    let tree = PathParams::oak().unwrap().grow(Seed(1), &Control::default()).unwrap().tree;
    let look = Look::built_in(tree.species()).unwrap();
    let mesh = tree_mesh::build(&tree, &look, &MeshParams::default(), &Control::default());
    let mesh = mesh.unwrap().mesh;
    let (mut positions, mut indices) = (FNV_BEGIN, FNV_BEGIN);
    for surface in &mesh.surfaces {
        positions = fnv1a(positions, bytemuck::cast_slice(&surface.positions));
        indices = fnv1a(indices, bytemuck::cast_slice(&surface.indices));
    }
    let expected = format!("oak seed 1\npositions {positions:016x} indices {indices:016x}\n");
    for (compiler, flags, source, name) in oaks() {
        let program = compile::compile(compiler, flags, &[source], name);
        let mut command = compile::command(&program);
        let folder = command.get_current_dir().unwrap().to_path_buf();
        let said = compile::run(&mut command);
        assert!(said.ends_with(&expected), "{name} says {said}not {expected}");
        let glb = std::fs::read(folder.join("oak.glb")).unwrap();
        assert_eq!(glb[..4], *b"glTF", "{name}");
        assert_eq!(glb.len(), u32::from_le_bytes(glb[8..12].try_into().unwrap()) as usize);
    }
}

#[test]
fn a_wall_moves_a_tree_and_leaves_no_trace() {
    let source = root().join("examples/c/wall.c");
    let program = compile::compile("cc", C11, &[source], "wall");
    let said = compile::run(compile::command(&program).args(["birch", "7"]));
    let rows = said.lines().skip_while(|line| !line.contains("farthest")).skip(1);
    let rows: Vec<Vec<&str>> = rows.map(|line| line.split_whitespace().collect()).collect();
    assert_eq!(rows.len(), 8, "{said}");
    let number = |row: usize, column: usize| rows[row][column].parse::<f32>().unwrap();
    for row in 0..7 {
        assert!(number(row, 2) <= number(row, 0) + 0.01, "through the wall: {said}");
    }
    assert!(number(6, 4) > 0.0 && number(6, 6) > number(0, 6), "{said}");
    assert_eq!(rows[7], ["without:", "moved", "0.000", "m,", "0", "pruned"], "{said}");
}

/// The photograph of `c_alone/workflow.c`: a round crown on a trunk.
fn photographed() -> Shot {
    let (width, height) = (60, 80);
    let covered = |i: u32| {
        let (x, y) = ((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
        let crown = (x - 30.0) * (x - 30.0) + (y - 28.0) * (y - 28.0) < 22.0 * 22.0;
        crown || ((28.0..32.0).contains(&x) && (28.0..74.0).contains(&y))
    };
    let alpha = (0..width * height).map(|i| if covered(i) { 1.0 } else { 0.0 }).collect();
    Shot::new(Matte::new(width, height, alpha).unwrap(), None, 0.0)
}

/// What `c_alone/workflow.c` does, in Rust.
fn photographed_beside_a_wall() -> Tree {
    let control = Control::default();
    let mut params = PhotoParams { height: 8.0, branches: 8, ..PhotoParams::default() };
    params.flow.particles = 60;
    params.density.resolution = 16;
    params.field.rows = 24;
    params.livewire.rows = 64;
    let model = PhotoModel { shots: vec![photographed()], params };
    let tree = model.model(Seed(1), &control).unwrap();
    let side = 0.4 * tree.skeleton().bounds().max.x;
    let plastic = PlasticTree::new(tree, &PlasticParams::default(), &control).unwrap();
    let mut scene = Scene::new(Sky::default(), Response::default()).unwrap();
    let id = scene.add_tree(Arc::new(plastic), Pose::default()).unwrap();
    let wall = Volume::box_solid(Vec3::new(0.0, -1.0, -50.0), Vec3::new(1.0, 50.0, 50.0)).unwrap();
    scene.add_obstacle(wall, Pose::at(Vec3::X * side)).unwrap();
    scene.update(&control).unwrap();
    scene.adapted(id, &control).unwrap().tree
}

#[test]
fn a_photographed_tree_beside_a_wall_has_the_same_levels_in_c_and_rust() {
    let tree = photographed_beside_a_wall();
    let look = Look::built_in(tree.species()).unwrap();
    let mesh = tree_mesh::build(&tree, &look, &MeshParams::default(), &Control::default());
    let around = Around { azimuths: 3, size: 64, ..Around::default() };
    let order = CoverageParams { around, ..CoverageParams::default() };
    let params = MakeParams { order: Some(order), ..MakeParams::default() };
    let model = PrunedModel::make(&mesh.unwrap().mesh, &params, &Control::default()).unwrap();
    let level = model.mesh_at(0.2).unwrap();
    let (mut positions, mut indices) = (FNV_BEGIN, FNV_BEGIN);
    for surface in &level.surfaces {
        positions = fnv1a(positions, bytemuck::cast_slice(&surface.positions));
        indices = fnv1a(indices, bytemuck::cast_slice(&surface.indices));
    }
    let n = level.n_triangles();
    let expected = format!("triangles {n} positions {positions:016x} indices {indices:016x}\n");
    let program = compile::compile("cc", C11, &alone("workflow.c"), "workflow");
    let said = compile::run(&mut compile::command(&program));
    assert_eq!(said, expected);
}

const FNV_BEGIN: u64 = 0xcbf2_9ce4_8422_2325;

fn fnv1a(hash: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(hash, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3))
}

/// With exceptions, and without, and without names of types.
fn cpp_tests(more: &[&'static str]) -> Vec<PathBuf> {
    let source = here().join("tests/cpp/wrapper.cpp");
    [("wrapper", &[][..]), ("wrapper_no_exceptions", &["-fno-exceptions", "-fno-rtti"][..])]
        .iter()
        .map(|(name, own)| {
            let flags = [CPP17, *own, more].concat();
            let name = if more.is_empty() { (*name).to_owned() } else { format!("{name}_more") };
            compile::compile("c++", &flags, std::slice::from_ref(&source), &name)
        })
        .collect()
}

#[test]
fn the_cpp_wrapper_works_with_and_without_exceptions() {
    for program in cpp_tests(&[]) {
        compile::run(&mut compile::command(&program));
    }
}

#[test]
fn an_installed_library_is_found_by_make_cmake_and_pkg_config() {
    let examples = root().join("examples/c");
    let folder = compile::folder("installed");
    let prefix = folder.join("prefix");
    let lib = prefix.join("lib");
    let install = |command: &mut Command| compile::run(command.current_dir(&folder));
    install(
        Command::new("bash")
            .arg(examples.join("install.sh"))
            .arg(&prefix)
            .arg(compile::library_folder()),
    );
    if compile::has("pkg-config") {
        let flags = install(
            Command::new("pkg-config")
                .args(["--cflags", "--libs", "tree"])
                .env("PKG_CONFIG_PATH", lib.join("pkgconfig")),
        );
        let built = Command::new("cc")
            .args(C11)
            .arg(examples.join("oak.c"))
            .args(flags.split_whitespace())
            .args(["-o", "oak_pkg_config"])
            .current_dir(&folder)
            .status();
        assert!(built.unwrap().success());
        let made = Command::new("make")
            .arg("-C")
            .arg(&examples)
            .args(["-n", "INSTALLED=1"])
            .env("PKG_CONFIG_PATH", lib.join("pkgconfig"))
            .output()
            .unwrap();
        assert!(String::from_utf8_lossy(&made.stdout).contains("-ltree_ffi"));
    }
    if compile::has("cmake") {
        let build = folder.join("build");
        let _ = std::fs::remove_dir_all(&build);
        install(
            Command::new("cmake")
                .arg("-S")
                .arg(&examples)
                .arg("-B")
                .arg(&build)
                .arg(format!("-DCMAKE_PREFIX_PATH={}", prefix.display())),
        );
        install(Command::new("cmake").arg("--build").arg(&build));
        for program in ["oak", "oak_cpp", "oak_static"] {
            // An unknown preset ends it at once, with the library's own words.
            let said = Command::new(build.join(program)).arg("no such tree").output().unwrap();
            let text = String::from_utf8_lossy(&said.stderr).into_owned();
            assert!(text.contains("TREE_ERROR_UNKNOWN_NAME"), "{program}: {text}");
        }
    }
}

#[test]
#[ignore = "slow: .ci/run does it"]
fn valgrind_finds_nothing() {
    if !compile::has("valgrind") {
        return;
    }
    let program = compile::compile("cc", C11, &c_tests(), "c_test_valgrind");
    compile::run(&mut compile::valgrind(&program));
    let program = compile::compile("cc", C11, &alone("soak.c"), "soak_valgrind");
    let ran = compile::output(compile::valgrind(&program).arg("20"));
    // valgrind's own memory grows: only its verdict counts.
    assert_ne!(ran.status.code(), Some(9), "{}", compile::said(&ran));
    let program = compile::compile("cc", C11, &alone("allocator.c"), "allocator_valgrind");
    compile::run(&mut compile::valgrind(&program));
}

#[test]
#[ignore = "slow: .ci/run does it"]
fn valgrind_would_find_misuse() {
    if !compile::has("valgrind") {
        return;
    }
    for name in ["misuse_leak.c", "misuse_freed_view.c"] {
        let program = compile::compile("cc", C11, &alone(name), &name.replace(".c", "_valgrind"));
        let ran = compile::output(&mut compile::valgrind(&program));
        assert_eq!(ran.status.code(), Some(9), "{name}: {}", compile::said(&ran));
        let said = compile::said(&ran);
        let expected = if name.contains("leak") { "definitely lost" } else { "Invalid read" };
        assert!(said.contains(expected), "{name}: {said}");
    }
}

#[test]
#[ignore = "slow: .ci/run does it"]
fn sanitizers_find_nothing() {
    if !has_sanitizers() {
        return;
    }
    let c = [C11, SANITIZE].concat();
    compile::run(&mut compile::command(&compile::compile("cc", &c, &c_tests(), "c_test_asan")));
    for program in cpp_tests(SANITIZE) {
        compile::run(&mut compile::command(&program));
    }
    for (compiler, flags, source, name) in oaks() {
        let flags = [flags, SANITIZE].concat();
        let program = compile::compile(compiler, &flags, &[source], &format!("{name}_asan"));
        compile::run(&mut compile::command(&program));
    }
}

#[test]
#[ignore = "slow: .ci/run does it"]
fn sanitizers_would_find_misuse() {
    if !has_sanitizers() {
        return;
    }
    for name in ["misuse_leak.c", "misuse_freed_view.c"] {
        let c = [C11, SANITIZE].concat();
        let program = compile::compile("cc", &c, &alone(name), &name.replace(".c", "_asan"));
        let ran = compile::output(&mut compile::command(&program));
        let said = compile::said(&ran);
        assert!(!ran.status.success(), "{name}: {said}");
        let expected = if name.contains("leak") { "LeakSanitizer" } else { "heap-use-after-free" };
        assert!(said.contains(expected), "{name}: {said}");
    }
}

fn has_sanitizers() -> bool {
    let source = compile::folder("c_programs").join("sanitizers.c");
    std::fs::write(&source, "int main(void) { return 0; }\n").unwrap();
    let program = source.with_extension("");
    let built = Command::new("cc").args(SANITIZE).arg(&source).arg("-o").arg(&program).output();
    built.is_ok_and(|output| output.status.success())
        && Command::new(&program).output().is_ok_and(|output| output.status.success())
}
