//! Draft.
use std::error::Error;
use std::time::Instant;
use tree_core::{Control, Seed};
use tree_lod::preview::{self, Style, View};
use tree_mesh::{Look, MeshParams};
use tree_model::sketch::template::EXEMPLARS;
fn main() -> Result<(), Box<dyn Error>> {
    let control = Control::default();
    let only: Vec<String> = std::env::args().skip(1).collect();
    std::fs::create_dir_all("/tmp/tmplpics")?;
    for exemplar in EXEMPLARS {
        if !only.is_empty() && !only.iter().any(|n| n == exemplar.name()) {
            continue;
        }
        let start = Instant::now();
        let tree = exemplar.tree(Seed(1), &control)?;
        let t = start.elapsed();
        let look = Look::built_in(tree.species())?;
        let mesh = tree_mesh::build(&tree, &look, &MeshParams::default(), &control)?.mesh;
        let b = tree.skeleton().bounds();
        println!(
            "{:14} {:.0?} {} nodes {} leaves {} tris, height {:.1} width {:.1}",
            exemplar.name(),
            t,
            tree.skeleton().len(),
            tree.foliage().len(),
            mesh.n_triangles(),
            b.max.y,
            b.size().x
        );
        let view = View { width: 400, height: 400, ..View::default() };
        preview::render(&mesh, &view, &Style::default(), &control)?
            .save_png(format!("/tmp/tmplpics/{}.png", exemplar.name()))?;
    }
    Ok(())
}
