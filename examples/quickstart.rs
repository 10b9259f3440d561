//! The main job: grow an oak, mesh it, write `out/oak.glb` and a picture of it, `out/oak.png`.

use std::error::Error;
use std::path::Path;
use std::time::Instant;
use tree_core::{Control, Seed};
use tree_lod::preview::{self, Style, View};
use tree_mesh::io::gltf::{GlbOptions, write_glb};
use tree_mesh::{Look, MeshParams};
use tree_model::path::PathParams;

fn main() -> Result<(), Box<dyn Error>> {
    let control = Control::default();
    let out = Path::new("out");
    std::fs::create_dir_all(out)?;

    let start = Instant::now();
    let tree = PathParams::oak()?.grow(Seed(7), &control)?.tree;
    let grown = start.elapsed();

    let look = Look::built_in(tree.species())?;
    let dressed = start.elapsed();

    let mesh = tree_mesh::build(&tree, &look, &MeshParams::default(), &control)?.mesh;
    let meshed = start.elapsed();

    write_glb(&mesh, out.join("oak.glb"), &GlbOptions::default())?;
    let written = start.elapsed();

    let picture = preview::render(&mesh, &View::default(), &Style::default(), &control)?;
    picture.save_png(out.join("oak.png"))?;
    let pictured = start.elapsed();

    println!(
        "out/oak.glb, out/oak.png: {} nodes, {} leaves, {} vertices, {} triangles; \
         grown in {:.0?}, textures {:.0?}, meshed {:.1?}, written {:.0?}, pictured {:.0?}",
        tree.skeleton().len(),
        tree.foliage().len(),
        mesh.n_vertices(),
        mesh.n_triangles(),
        grown,
        dressed - grown,
        meshed - dressed,
        written - meshed,
        pictured - written,
    );
    Ok(())
}
