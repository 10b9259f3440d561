//! The library in other people's hosts: Mono, which is nearest to Unity, and Godot 3. Each builds the same
//! oak, fills the engine's own mesh and says what it got; here are Rust's own numbers to hold that against.
//! Hosts that are not installed are skipped, unless `TREE_HOSTS` is set.

#![allow(clippy::unwrap_used)]

mod host;

use host::programs::{finish, installed, library, skip, succeed, work};
use host::root;
use std::path::PathBuf;
use std::process::Command;
use tree_mesh::{Look, Mesh, MeshParams, build};
use tree_model::path::PathParams;
use tree_model::tree_core::{Control, Seed};

/// FNV-1a, 64 bits, as `Oak.cs` and `botanical_tree.c` have it.
fn fnv(hash: u64, bytes: &[u8]) -> u64 {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.iter().fold(hash, step)
}

/// The line that every host prints of the oak.
fn hashes(mesh: &Mesh) -> String {
    let (mut positions, mut indices) = (0xcbf2_9ce4_8422_2325, 0xcbf2_9ce4_8422_2325);
    for surface in &mesh.surfaces {
        positions = fnv(positions, bytemuck::cast_slice(&surface.positions));
        indices = fnv(indices, bytemuck::cast_slice(&surface.indices));
    }
    format!("positions {positions:016x} indices {indices:016x}")
}

fn oak() -> Mesh {
    let control = Control::default();
    let tree = PathParams::oak().unwrap().grow(Seed(1), &control).unwrap().tree;
    let look = Look::built_in(tree.species()).unwrap();
    build(&tree, &look, &MeshParams::default(), &control).unwrap().mesh
}

fn csharp_files(names: &[&str]) -> Vec<PathBuf> {
    names.iter().map(|name| root().join("examples/csharp").join(name)).collect()
}

const WRAPPERS: &[&str] = &[
    "TreeNative.cs",
    "Border.cs",
    "Library.cs",
    "Defaults.cs",
    "Tree.cs",
    "Columns.cs",
    "Mesh.cs",
    "Surface.cs",
    "Packed.cs",
];

/// Has the warnings of C# 7's compiler as errors.
fn mcs(program: &std::path::Path) -> Command {
    let mut command = Command::new("mcs");
    command.args(["-unsafe", "-langversion:7", "-warnaserror+"]);
    command.arg(format!("-out:{}", program.display()));
    command
}

#[test]
fn csharp_builds_the_same_oak() {
    if !installed(&["mcs", "mono"]) {
        return;
    }
    let work = work("csharp_oak");
    let program = work.join("Oak.exe");
    let compile = &mut mcs(&program);
    succeed(compile.args(csharp_files(WRAPPERS)).args(csharp_files(&["Oak.cs"])), &work);
    let said = succeed(Command::new("mono").arg(&program), &work);
    let lines: Vec<&str> = said.lines().collect();
    let mesh = oak();
    assert_eq!(lines.first(), Some(&"oak seed 1"), "{said}");
    assert!(lines.contains(&hashes(&mesh).as_str()), "{said}\nRust: {}", hashes(&mesh));
    for (number, surface) in mesh.surfaces.iter().enumerate() {
        let (vertices, indices) = (surface.positions.len(), surface.indices.len());
        let line = format!("surface {number}: {vertices} vertices, {indices} indices, ");
        assert!(lines.iter().any(|said| said.starts_with(&line)), "{said}\nRust: {line}");
    }
    assert_eq!(lines.last(), Some(&"done"), "{said}");
}

/// A game's scripts are another assembly than the wrappers: what they need is public.
#[test]
fn csharp_wrappers_are_enough_from_outside() {
    if !installed(&["mcs", "mono"]) {
        return;
    }
    let work = work("csharp_whole");
    let (wrappers, program) = (work.join("Tree.dll"), work.join("Whole.exe"));
    let compile = &mut mcs(&wrappers);
    succeed(compile.arg("-target:library").args(csharp_files(WRAPPERS)), &work);
    let compile = &mut mcs(&program);
    compile.arg(format!("-r:{}", wrappers.display()));
    succeed(compile.arg(root().join("tree-ffi/tests/csharp/WholeCheck.cs")), &work);
    let said = succeed(Command::new("mono").arg(&program).arg(&work), &work);
    assert!(said.lines().any(|line| line == "whole check passed"), "{said}");
}

#[test]
fn csharp_structs_are_laid_out_as_in_c() {
    if !installed(&["mcs", "mono", "cc"]) {
        return;
    }
    let header = host::header();
    assert!(header.structs.len() > 20, "{} structs", header.structs.len());
    let work = work("csharp_layout");
    let (c, csharp) = (work.join("layout.c"), work.join("Layout.cs"));
    std::fs::write(&c, host::layout::c_program(&header)).unwrap();
    std::fs::write(&csharp, host::layout::csharp_program(&header)).unwrap();

    let program = work.join("layout");
    let include = root().join("include");
    let compile = &mut Command::new("cc");
    succeed(compile.arg("-I").arg(include).arg(&c).arg("-o").arg(&program), &work);
    let in_c = succeed(&mut Command::new(&program), &work);

    let program = work.join("Layout.exe");
    let compile = &mut mcs(&program);
    // CS0168, CS0649: nothing is ever put into these structs.
    compile.arg("-nowarn:0168,0649").args(csharp_files(&["TreeNative.cs"])).arg(&csharp);
    succeed(compile, &work);
    let in_csharp = succeed(Command::new("mono").arg(&program), &work);
    for (c, csharp) in in_c.lines().zip(in_csharp.lines()) {
        assert_eq!(c, csharp);
    }
    assert_eq!(in_c.lines().count(), in_csharp.lines().count());
}

#[test]
fn unity_is_handed_its_own_axes() {
    if !installed(&["mcs", "mono"]) {
        return;
    }
    let work = work("csharp_unity");
    let program = work.join("Unity.exe");
    let here = root().join("tree-ffi/tests/csharp");
    let compile = &mut mcs(&program);
    compile.arg("-define:UNITY_5_3_OR_NEWER").args(csharp_files(WRAPPERS));
    compile.args(csharp_files(&["UnityTree.cs", "UnityTreeMesh.cs", "UnityTreeMaterials.cs"]));
    compile.args([here.join("FakeUnity.cs"), here.join("UnityCheck.cs")]);
    succeed(compile, &work);
    let said = succeed(Command::new("mono").arg(&program), &work);
    assert!(said.lines().any(|line| line == "unity check passed"), "{said}");
}

#[test]
fn godot_3_fills_an_array_mesh() {
    if !installed(&["godot3-server", "cc", "bash"]) {
        return;
    }
    let work = work("godot3");
    let script = root().join("examples/godot/godot3/run.sh");
    let run = &mut Command::new("bash");
    let (status, said) = finish(run.arg(script).arg(library()).arg(work.join("project")), &work);
    if status == Some(3) {
        return skip("Godot's headers could not be fetched");
    }
    assert_eq!(status, Some(0), "{said}");
    let mesh = oak();
    assert!(said.lines().any(|line| line == hashes(&mesh)), "{said}\nRust: {}", hashes(&mesh));
    assert!(said.lines().any(|line| line == "TREE TEST PASSED"), "{said}");
}
