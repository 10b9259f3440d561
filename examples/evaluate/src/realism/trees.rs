//! Trees of every modeler, one of each kind.

use super::Outcome;
use crate::references::data;
use crate::{particle, silhouette};
use std::sync::Arc;
use tree_core::glam::Vec3;
use tree_core::{Control, Seed, Skeleton, Tree, Volume};
use tree_mesh::io::{self, ImportOptions, points};
use tree_model::plastic::{PlasticParams, PlasticTree, Pose, Response, Scene, Sky};
use tree_model::skeletonize::{ScanParams, SkeletonizeParams, skeletonize, skeletonize_scan};
use tree_model::sketch::session::{Session, SketchParams};
use tree_model::sketch::template::{EXEMPLARS, Exemplar, MainBranchParams, main_branches, project};
use tree_model::{growth, lsystem, path};

/// What takes a tree's name and its wood.
type Sink<'a> = dyn FnMut(&str, &Skeleton) + 'a;

/// All of them.
pub(super) fn each(sink: &mut Sink<'_>) -> Outcome {
    paths(sink)?;
    photographs(sink)?;
    sketches(sink)?;
    silhouettes(sink)?;
    grammars(sink)?;
    grown(sink)?;
    adapted(sink)?;
    meshes(sink)?;
    scans(sink)
}

/// Roots are no crowns.
fn paths(sink: &mut Sink<'_>) -> Outcome {
    let roots = ["taproot", "heartroot"];
    for preset in path::PRESETS.iter().filter(|preset| !roots.contains(&preset.name())) {
        let params = path::PathParams { leaves: None, ..preset.params()? };
        let tree = params.grow(Seed(1), &Control::default())?.tree;
        sink(&format!("path {}, {}", preset.name(), params.species.name), tree.skeleton());
    }
    Ok(())
}

/// The cut-outs: they need no matting.
fn photographs(sink: &mut Sink<'_>) -> Outcome {
    for name in ["cutout_holm_oak", "cutout_birch_winter", "cutout_pinnate_tree"] {
        if let Some(tree) = particle::tree(&format!("{name}.png"))? {
            sink(&format!("photograph {name}"), tree.skeleton());
        }
    }
    Ok(())
}

/// Drawings of the main branches and the crown of a few trees.
fn sketches(sink: &mut Sink<'_>) -> Outcome {
    /// Where they are drawn from: between the views of the templates.
    const YAW: f32 = 0.2;
    let control = Control::default();
    for name in ["oak", "birch", "spruce", "apple"] {
        let exemplar: Exemplar =
            EXEMPLARS.into_iter().find(|e| e.name() == name).ok_or("no exemplar")?;
        let tree = exemplar.tree(tree_model::sketch::template::EXEMPLAR_SEED, &control)?;
        let branches = main_branches(tree.skeleton(), &MainBranchParams::default())?;
        let drawing = project(&branches, YAW, &crate::sketch::crown_of(&tree, YAW));
        let mut session = Session::new(drawing, SketchParams::default(), Seed(1))?;
        sink(&format!("sketch of the exemplar {name}"), session.tree(&control)?.tree.skeleton());
    }
    Ok(())
}

fn silhouettes(sink: &mut Sink<'_>) -> Outcome {
    for name in ["poplar", "pine", "christmas_tree", "palm", "willow", "eucalyptus"] {
        sink(&format!("silhouette {name}"), silhouette::tree(name)?.skeleton());
    }
    Ok(())
}

/// Trees only: the books' plane plants, weeds and bushes are no trees.
fn grammars(sink: &mut Sink<'_>) -> Outcome {
    let herbs = ["fern", "thesis-", "abop-"];
    for preset in lsystem::presets() {
        if herbs.iter().any(|herb| preset.name().starts_with(herb)) {
            continue;
        }
        let tree = preset.system()?.grow(Seed(1), &Control::default())?.tree;
        sink(&format!("lsystem {}", preset.name()), tree.skeleton());
    }
    Ok(())
}

fn grown(sink: &mut Sink<'_>) -> Outcome {
    for preset in growth::PRESETS {
        sink(&format!("growth {}", preset.name()), grow(preset)?.skeleton());
    }
    Ok(())
}

fn grow(preset: growth::Preset) -> Outcome<Tree> {
    let mut params = preset.params();
    params.habit.leaves = None;
    Ok(params.grow(Seed(1), &Control::default())?.tree)
}

/// Trees that stand beside a wall.
fn adapted(sink: &mut Sink<'_>) -> Outcome {
    let control = Control::default();
    let oak = path::PathParams { leaves: None, ..path::Preset::find("oak")?.params()? };
    let trees = [
        ("path oak", oak.grow(Seed(1), &control)?.tree),
        ("growth oak", grow(growth::Preset::find("oak")?)?),
    ];
    for (name, tree) in trees {
        let size = tree.skeleton().bounds().size();
        let model = Arc::new(PlasticTree::new(tree, &PlasticParams::default(), &control)?);
        let mut scene = Scene::new(Sky::default(), Response::default())?;
        let id = scene.add_tree(model, Pose::default())?;
        let half = Vec3::new(0.1, 1.2 * size.y, size.z);
        let wall = Volume::box_solid(Vec3::new(-0.1, 0.0, -size.z), half)?;
        scene.add_obstacle(wall, Pose::at(Vec3::X * (0.3 * size.x)))?;
        scene.update(&control)?;
        let case = format!("plastic {name} beside a wall");
        sink(&case, scene.adapted(id, &control)?.tree.skeleton());
    }
    Ok(())
}

fn meshes(sink: &mut Sink<'_>) -> Outcome {
    let control = Control::default();
    let params = SkeletonizeParams { leaves: false, ..SkeletonizeParams::default() };
    for name in ["walnut_wood", "fuji43_wood", "appletree_amap", "eztree_oak_medium"] {
        let path = data().join("meshes").join(name).with_extension("glb");
        if !path.is_file() {
            eprintln!("{}: not there, left out", path.display());
            continue;
        }
        let mesh = io::read(&path, &ImportOptions { external: true }, &control)?.mesh;
        let made = skeletonize(&mesh.parts(), &params, &control)?;
        sink(&format!("mesh {name}"), made.tree.skeleton());
    }
    Ok(())
}

fn scans(sink: &mut Sink<'_>) -> Outcome {
    let control = Control::default();
    let params = ScanParams { foliage: false, ..ScanParams::default() };
    for name in ["archi_tree1", "itsme_tree2", "puu1_crown", "adtree_tree7"] {
        let path = data().join("pointclouds").join(name).with_extension("ply");
        if !path.is_file() {
            eprintln!("{}: not there, left out", path.display());
            continue;
        }
        let cloud = points::read(path, &control)?.positions;
        let made = skeletonize_scan(&cloud, &params, &control)?;
        let tree = made.trees.first().ok_or("no tree")?;
        sink(&format!("scan {name}"), &tree.skeleton);
    }
    Ok(())
}
