//! Writes small valid files to start from: `cargo run -p tree-promises --example seeds`, when a target reads something new. They are part
//! of the repository; `fuzz/run` and this crate's tests start from them.

use std::error::Error;
use std::fs;
use std::path::Path;
use tree_core::glam::{Quat, Vec3};
use tree_core::{Control, Foliage, Leaf, Skeleton, Species, Tree, swc};
use tree_lod::multires::stream::{StreamParams, encode};
use tree_lod::multires::{Metric, Multires};
use tree_mesh::io::gltf::{self, GlbOptions, Level};
use tree_mesh::io::{obj, ply};
use tree_mesh::{Alpha, Look, MeshParams, Texture, build};

fn main() -> Result<(), Box<dyn Error>> {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.2)?;
    builder.add(0, Vec3::Y, 0.1)?;
    let skeleton = builder.finish();
    save("swc", "tree", swc::write(&skeleton, &swc::SwcOptions::default())?.as_bytes())?;
    let leaf = Leaf { node: 1, position: Vec3::Y, rotation: Quat::IDENTITY, size: 0.2, kind: 0 };
    let species = Species { leaf_kinds: vec!["leaf".into()], ..Default::default() };
    let tree = Tree::new(skeleton, Foliage::try_from(vec![leaf, leaf])?, species)?;
    let mut look = Look::plain(tree.species());
    let texture = Texture { name: "t".into(), width: 2, height: 2, pixels: vec![128; 16] };
    save("picture", "png", &texture.to_png()?)?;
    save("photo", "png", &texture.to_png()?)?;
    look.leaves[0].material.texture = Some(texture.into());
    look.leaves[0].material.alpha = Alpha::Mask(0.5);
    let params = MeshParams { leaf_rounding: 0.0, ..Default::default() };
    let control = Control::default();
    let mesh = build(&tree, &look, &params, &control)?.mesh;
    let parts = gltf::instanced(&tree, &look, &params, &control)?;
    let instanced = Level { instances: &parts.leaves, ..Level::from(&parts.mesh) };
    for (name, level, quantize) in [
        ("plain", Level::from(&mesh), false),
        ("small", Level::from(&mesh), true),
        ("instanced", instanced, true),
    ] {
        let options = GlbOptions { quantize, ..Default::default() };
        save("gltf", name, &gltf::to_glb_levels(&[level], &options)?)?;
    }
    let (text, mtl) = obj::to_strings(&mesh, "tree")?;
    save("obj", "alone", text.as_bytes())?;
    save("obj", "both", [text.as_bytes(), b"\0", mtl.as_bytes()].concat().as_slice())?;
    save("obj", "quads", b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv .2 .2 0\nf -4 -3 -2 -1\nl 1 2\n")?;
    for ascii in [false, true] {
        let bytes = ply::to_bytes(&mesh, &ply::PlyOptions { ascii })?;
        save("ply", if ascii { "text" } else { "binary" }, &bytes)?;
    }
    let cloud: String = (0..60).map(|i| format!("{} {} {}\n", i % 3, i % 5, i)).collect();
    save("points", "text", format!("\u{1}# x y z\n{cloud}").as_bytes())?;
    let header = "ply\nformat ascii 1.0\nelement vertex 60\nproperty float x\nproperty double y\n\
                  property int z\nend_header\n";
    save("points", "ply", format!("\0{header}{cloud}").as_bytes())?;
    let svg = r#"<svg viewBox="0 0 10 10"><path d="M2 8 L8 8 C9 2 1 2 2 8 Z" transform="scale(2)"/></svg>"#;
    save("svg", "closed", svg.as_bytes())?;
    let svg = r#"<svg viewBox="0 0 64 48"><path d="M32 46 L32 20 L20 8"/><polyline points="32,24 44,9"/></svg>"#;
    save("svg", "strokes", svg.as_bytes())?;
    let svg = r##"<svg><g id="crown"><circle cx="5" cy="3" r="4" fill="none" stroke="#0a0"/></g><path id="trunk" d="M5 10 L5 3 M5 6 L8 2"/></svg>"##;
    save("sketch", "svg", svg.as_bytes())?;
    let json = r#"{"strokes":[{"points":[[5,10],[5,2]],"role":"trunk"},{"points":[[5,6],[8,3]]}]}"#;
    save("sketch", "json", json.as_bytes())?;
    save("sketch", "bare", b"[[[5,10],[5,2]],[[5,6],[8,3]]]")?;
    save(
        "sketch",
        "quickdraw",
        br#"{"word":"tree","drawing":[[[5,5],[10,2]],[[1,9,9],[3,0,3]]]}"#,
    )?;
    let svg = r##"<svg viewBox="0 0 20 20"><path id="trunk" d="M10 20 L10 10"/><path d="M4 10 C0 4 6 0 10 1 C15 0 20 5 16 10 C14 12 6 12 4 10 Z"/></svg>"##;
    save("silhouette", "svg", svg.as_bytes())?;
    save("lsystem", "signal", b"#ignore +-F\naxiom: J[+I]I[-I]FI\nJ < I > [I] -> J\nI -> I")?;
    save("lsystem", "tree", b"#define r .7\nsteps: 4\nangle: 25.7\naxiom: A(1)\np1: A(l) : l > .1 && itNum < maxIt -> F(l)[+(ran(30))A(l*r)]A(if(l>.5,l/2,sin(l))) : .7\nA(l) -(.3)-> B(nran(l,.1))\ndecomposition\nmaximum depth: 3\nB(x) -> [C]B(x^2)\nhomomorphism\nC -> /* leaf */ \\\n~L\nendlsystem\n")?;
    save("lsystem", "names", b"#symbols Apex Fl\n\xcf\x89 : Apex(1)\nl : * < Apex(t) > * : * \xe2\x86\x92 Fl[Apex(-t%2)] // end")?;
    streams(&tree)?;
    programs()
}

/// Streams as they are, which begin with an even number, and without their checks, which begin with an odd one.
fn streams(tree: &Tree) -> Result<(), Box<dyn Error>> {
    let multires = Multires::new(tree, &Metric::default(), &Control::default())?;
    for (name, precision) in [("exact", 0.0), ("millimetres", 0.001)] {
        let bytes = encode(&multires, multires.n_levels(), &StreamParams { precision })?;
        save("stream", name, &[&[8][..], &bytes].concat())?;
        // Exact, no names, one kind of leaves; levels, nodes, leaves.
        let mut parts = [&f32::to_le_bytes(precision)[..], &[0, 0, 1, 1, b'k', 3, 5, 2]].concat();
        let turn = match precision {
            0.0 => Quat::IDENTITY.to_array().map(f32::to_le_bytes).concat(),
            _ => vec![7; 4],
        };
        // Two nodes on the way, and a leaf on the second; then a fork, nodes and leaves.
        let trunk = [&[2, 0, 0, 0, 9, 0, 20, 0, 1, 1, 1, 0, 2, 2, 2, 40][..], &turn].concat();
        let branch = [&[0, 2, 8, 8, 1, 0, 8, 8, 0, 2, 1, 0, 0, 0, 1, 1, 6][..], &turn].concat();
        let twig = [3, 1, 1, 2, 3, 4, 0];
        let mut sealed = vec![9];
        sealed.extend([parts.len() as u8, 0]);
        sealed.append(&mut parts);
        for level in [&trunk[..], &branch, &twig] {
            sealed.extend([level.len() as u8, 0]);
            sealed.extend_from_slice(level);
        }
        save("stream", &format!("{name}_sealed"), &sealed)?;
    }
    Ok(())
}

fn save(target: &str, name: &str, bytes: &[u8]) -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../corpus").join(target);
    fs::create_dir_all(&folder)?;
    fs::write(folder.join(name), bytes)?;
    Ok(())
}

/// Programs of calls, as `c_abi` reads them.
fn programs() -> Result<(), Box<dyn Error>> {
    let stick = [0, 0, 3, 0, 0, 0, 0, 4, 0, 4, 8, 0, 1, 1, 1, 255, 0, 1];
    let tree = [0, 5, 0, 1, 2, 4, 8, 0, 0, 0, 0, 4, 1];
    let meshed = [3, 0, 3, 1, 0, 0, 0, 3, 3, 0, 7, 2, 0, 7, 0, 0];
    save("c_abi", "mesh", &[&stick[..], &tree, &meshed].concat())?;
    let levels = [4, 0, 0, 4, 1, 0, 4, 2, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 4, 3, 0, 1];
    save("c_abi", "levels", &[&stick[..], &tree, &levels].concat())?;
    let wall = [6, 0, 1, 0, 252, 2, 8, 4, 6, 3, 0, 0, 6, 4, 6, 5, 0, 0, 0, 6, 5, 0, 1, 0, 6, 6, 0];
    save("c_abi", "wall", &[&stick[..], &tree, &wall, &[6, 7, 0, 0, 0]].concat())?;
    let text = |group: u8, call: u8, text: &str| {
        let len = (text.len() as u16).to_le_bytes();
        [&[group, call], &len[..], text.as_bytes()].concat()
    };
    let grammar = text(1, 0, "axiom: A\nA -> F[+A]A");
    save("c_abi", "grammar", &[&grammar[..], &[1, 2, 0, 4, 1, 3, 0, 1, 4, 0]].concat())?;
    let drawing = text(2, 0, "[[[5,10],[5,2]],[[5,6],[8,3]]]");
    save("c_abi", "drawing", &[&drawing[..], &[2, 2, 0, 0]].concat())?;
    save("c_abi", "swc", &[&text(0, 2, "1 1 0 0 0 1 -1\n2 1 0 1 0 1 1")[..], &[0, 3, 0]].concat())
}
