//! Writes small files of every sort for other people's readers and validators.
//!
//! ```sh
//! cargo run --release --example samples -- /tmp/samples
//! node examples/validate/validate.mjs /tmp/samples/*.gl*
//! ```

use std::error::Error;
use std::path::PathBuf;
use std::sync::Arc;
use tree_core::glam::{EulerRot, Quat, Vec3};
use tree_core::glam::{Vec2, Vec4};
use tree_core::{Control, Foliage, Leaf, Skeleton, Species, Tree};
use tree_mesh::io::gltf::{
    Attribute, GlbOptions, Level, OcclusionAs, instanced, write_glb, write_glb_levels, write_gltf,
};
use tree_mesh::io::obj::write_obj;
use tree_mesh::io::ply::{PlyOptions, write_ply};
use tree_mesh::pack::gltf_wind;
use tree_mesh::{Alpha, Look, Mesh, MeshParams, Texture, build};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "samples".into()));
    std::fs::create_dir_all(&folder)?;
    for (name, tree, params) in [
        ("small", whorls(4, 200)?, MeshParams::default()),
        ("bent", whorls(4, 200)?, MeshParams::default()),
        ("large", whorls(60, 40_000)?, MeshParams::default()),
        ("nasty", nasty()?, MeshParams::default()),
    ] {
        for textured in [false, true] {
            let mut look = Look::plain(tree.species());
            if textured {
                dress(&mut look);
            }
            if name == "bent" {
                look.leaves.iter_mut().for_each(|leaf| leaf.bend = 0.6);
            }
            let built = build(&tree, &look, &params, &Control::default())?;
            let stem = format!("{name}{}", if textured { "_textured" } else { "" });
            let options = GlbOptions { name: stem.clone(), ..Default::default() };
            let path = |ending: &str| folder.join(format!("{stem}{ending}"));
            write_glb(&built.mesh, path(".glb"), &options)?;
            write_obj(&built.mesh, path(".obj"))?;
            write_ply(&built.mesh, path(".ply"), &PlyOptions::default())?;
            if name != "large" {
                variants(&tree, &look, &params, &built.mesh, &options, &path)?;
            }
            println!("{stem}: {:?}", built.report);
        }
    }
    Ok(())
}

/// One file for every option of the glTF writer.
fn variants(
    tree: &Tree,
    look: &Look,
    params: &MeshParams,
    mesh: &Mesh,
    options: &GlbOptions,
    path: &dyn Fn(&str) -> PathBuf,
) -> Result<(), Box<dyn Error>> {
    let quantized = GlbOptions { quantize: true, ..options.clone() };
    write_glb(mesh, path("_quantized.glb"), &quantized)?;
    write_gltf(&[mesh.into()], path("_beside.gltf"), options)?;

    let full = completed(mesh);
    let first = &full.surfaces[0];
    let wind = Attribute {
        surface: 0,
        name: "_WIND".into(),
        components: 2,
        values: first.positions.iter().flat_map(|p| [p.y, p.x]).collect(),
    };
    let everything = GlbOptions { translucency: true, ..options.clone() };
    let all = Level::from(&full);
    write_glb_levels(&[all], path("_full.glb"), &everything)?;
    write_glb_levels(&[all], path("_full_quantized.glb"), &quantized)?;
    let grey = GlbOptions { occlusion: OcclusionAs::Color, ..quantized.clone() };
    write_glb_levels(&[all], path("_grey.glb"), &grey)?;
    let windy = Level { attributes: &[wind], ..all };
    let without = GlbOptions { occlusion: OcclusionAs::Omit, ..options.clone() };
    write_glb_levels(&[windy], path("_wind.glb"), &without)?;
    let mut winds = Vec::new();
    for (surface, _) in full.surfaces.iter().enumerate().filter(|(_, s)| !s.indices.is_empty()) {
        winds.extend(gltf_wind::attributes(&full, surface)?);
    }
    let colored = GlbOptions { occlusion: OcclusionAs::Color, ..options.clone() };
    let windy = Level { attributes: &winds, ..all };
    write_glb_levels(&[windy], path("_wind_all.glb"), &colored)?;
    // Attributes of different widths, which Blender mixes up.
    write_glb_levels(&[windy], path("_wind_mixed.glb"), options)?;

    let parts = instanced(tree, look, params, &Control::default())?;
    if parts.leaves.is_empty() {
        return Ok(());
    }
    let leaves = Level { instances: &parts.leaves, ..Level::from(&parts.mesh) };
    write_glb_levels(&[leaves], path("_instanced.glb"), options)?;
    write_glb_levels(&[leaves], path("_instanced_quantized.glb"), &quantized)?;
    let bare = Level { coverage: 0.1, ..Level::from(&parts.mesh) };
    let fine = Level { coverage: 0.5, ..leaves };
    write_glb_levels(&[fine, bare], path("_levels.glb"), options)?;
    Ok(())
}

/// The mesh with made-up optional columns, where it has none.
fn completed(mesh: &Mesh) -> Mesh {
    let mut mesh = mesh.clone();
    for surface in &mut mesh.surfaces {
        let n = surface.positions.len();
        if surface.tangents.is_empty() {
            let tangent = |n: &Vec3| n.any_orthonormal_vector().extend(1.0);
            surface.tangents = surface.normals.iter().map(tangent).collect::<Vec<Vec4>>();
        }
        if surface.uvs2.is_empty() {
            surface.uvs2 = (0..n).map(|i| Vec2::splat(i as f32 / n as f32)).collect();
        }
        if surface.occlusion.is_empty() {
            surface.occlusion = (0..n).map(|i| (i % 5) as f32 / 4.0).collect();
        }
    }
    mesh
}

/// A chequered bark, and one lens-shaped leaf shared by all kinds.
fn dress(look: &mut Look) {
    let picture = |name: &str, n: u32, color: fn(f32, f32) -> [u8; 4]| {
        let at = |i: u32| (i as f32 + 0.5) / n as f32 * 2.0 - 1.0;
        Arc::new(Texture {
            name: name.into(),
            width: n,
            height: n,
            pixels: (0..n * n).flat_map(|i| color(at(i % n), at(i / n))).collect(),
        })
    };
    look.bark.base_color = [1.0; 4];
    look.bark.texture = Some(picture("bark", 64, |x, y| {
        let dark = (x > 0.0) != (y > 0.0);
        if dark { [90, 70, 50, 255] } else { [110, 90, 70, 255] }
    }));
    let leaf = picture("leaf", 128, |x, y| {
        let inside = 2.0 * x.abs() < 1.0 - y * y;
        [60, if x < 0.0 { 120 } else { 140 }, 40, if inside { 255 } else { 0 }]
    });
    for material in look.leaves.iter_mut().map(|leaf| &mut leaf.material) {
        material.base_color = [1.0; 4];
        material.texture = Some(Arc::clone(&leaf));
        material.alpha = Alpha::Mask(0.5);
    }
}

/// A bent trunk with whorls of five boughs and leaves along them.
fn whorls(n: u32, n_leaves: u32) -> Result<Tree, Box<dyn Error>> {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.25)?;
    let mut trunk = 0;
    let mut places = Vec::new();
    for whorl in 1..=n {
        let share = whorl as f32 / n as f32;
        let foot = Vec3::new(0.15 * (whorl % 3) as f32, 6.0 * share, 0.1 * (whorl % 2) as f32);
        trunk = builder.add(trunk, foot, 0.25 * (1.02 - share))?;
        for bough in 0..5 {
            let turn = Quat::from_rotation_y(1.256 * bough as f32 + whorl as f32);
            let mut node = trunk;
            for step in 1..=6_u32 {
                let s = step as f32;
                let reach = Vec3::new(0.3 * s, 0.03 * s * s, 0.05 * (step % 2) as f32);
                let at = foot + turn * reach * (1.1 - share);
                node = builder.add(node, at, 0.08 * (1.05 - share) * (1.0 - s / 7.0))?;
                places.push((node, at));
            }
        }
    }
    let mut foliage = Foliage::default();
    for (i, &(node, position)) in places.iter().cycle().take(n_leaves as usize).enumerate() {
        foliage.push(Leaf {
            node,
            position,
            rotation: Quat::from_euler(EulerRot::YXZ, 2.4 * i as f32, 0.9, 0.1 * i as f32),
            size: 0.18,
            kind: (i % 2) as u16,
        })?;
    }
    let species = Species { leaf_kinds: vec!["sun".into(), "shade".into()], ..Default::default() };
    Ok(Tree::new(builder.finish(), foliage, species)?)
}

/// Everything a skeleton may be and should not: doubled nodes, turns back, steps in radius, no
/// radius, segments far shorter than wide.
fn nasty() -> Result<Tree, Box<dyn Error>> {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.0)?;
    let mut node = 0;
    for (x, y, radius) in [
        (0.0, 0.0, 0.5),
        (0.0, 0.01, 0.4),
        (0.0, 1.0, 0.0),
        (0.0, 2.0, 0.3),
        (0.0, 1.0, 0.3),
        (1.0, 1.0, 0.05),
        (1.0, 1.0, 0.2),
        (1.0, 1.000_000_1, 1.0),
        (0.5, 3.0, 0.0),
    ] {
        node = builder.add(node, Vec3::new(x, y, 0.0), radius)?;
        builder.add(node, Vec3::new(x, y, 0.001), 2.0)?;
        builder.add(node, Vec3::new(x, y + 0.3, 0.5), 0.01)?;
    }
    Ok(Tree::bare(builder.finish(), Species::default()))
}
