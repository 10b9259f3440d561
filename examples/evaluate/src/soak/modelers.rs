//! Trees of every modeler, of parameters that chance has had its hands on.

use super::dice::Dice;
use super::drawn;
use crate::mesh::skeletons;
use std::sync::{Arc, OnceLock};
use tree_core::glam::{DVec3, Vec3};
use tree_core::{Control, Seed, Skeleton, Species, Tree, UpAxis, Volume};
use tree_mesh::{Look, MeshParams};
use tree_model::foliage::{SPECIES, grow_leaves_and_report, grow_leaves_with_stalks, grow_twigs};
use tree_model::lsystem::{LSystem, presets};
use tree_model::particle::session::{PhotoModel, PhotoParams, Shot};
use tree_model::plastic::{
    PlasticParams, PlasticTree, Pose, Regrowth, Response, Scene, Sky, TreeId,
};
use tree_model::silhouette::session::{SilhouetteModel, SilhouetteParams};
use tree_model::skeletonize::{Part, ScanParams, SkeletonizeParams, skeletonize, skeletonize_scan};
use tree_model::sketch::session::{SketchModel, SketchParams};
use tree_model::{ModelError, Modeler, growth, path};

/// What came of a case.
pub(super) type Made = Result<Vec<Tree>, ModelError>;
/// Trees, or an error with a type.
pub(super) type Make = fn(&mut Dice, &Control) -> Made;

/// Every modeler, its share of a thousand, and how it is called.
pub(super) const MODELERS: [(&str, usize, Make); 11] = [
    ("path", 90, path),
    ("growth", 90, growth),
    ("lsystem, presets", 90, lsystem),
    ("lsystem, random grammars", 180, grammar),
    ("silhouette", 80, silhouette),
    ("sketch", 90, sketch),
    ("particle", 50, particle),
    ("skeletonize", 110, mesh),
    ("skeletonize, scans", 40, scan),
    ("plastic", 60, plastic),
    ("foliage", 120, foliage),
];

fn one(tree: Tree) -> Made {
    Ok(vec![tree])
}

/// Small graphs and few levels, else as a preset has it.
fn path(dice: &mut Dice, control: &Control) -> Made {
    let Some(preset) = dice.pick(&path::PRESETS[..]) else { return Ok(Vec::new()) };
    let mut params = preset.params()?;
    params.graph_nodes = 150;
    params.endpoints.random = params.endpoints.random.min(6);
    params.levels.truncate(1 + dice.below(2));
    for level in &mut params.levels {
        level.graph_nodes = 20;
        level.branching = level.branching.min(3);
    }
    if let Some(roots) = &mut params.roots {
        roots.graph_nodes = 100;
        roots.levels.truncate(1);
        roots.levels.iter_mut().for_each(|level| level.graph_nodes = 20);
    }
    if dice.chance(0.5) {
        params.leaves = None;
    }
    let params = dice.changed(&params);
    one(params.model(dice.seed(), control)?)
}

fn growth(dice: &mut Dice, control: &Control) -> Made {
    let Some(preset) = dice.pick(&growth::PRESETS) else { return Ok(Vec::new()) };
    let mut params = preset.params();
    params.iterations = 3 + dice.below(5) as u32;
    if dice.chance(0.3) {
        params.world.obstacle = volume(dice)
            .map(|volume| path::Obstacle { volume, clearance: dice.coordinate(0.1, 0.2) });
    }
    if dice.chance(0.2) {
        let mut space = growth::Space::default();
        (space.occupancy, space.perception) =
            (2.0 * params.habit.internode, 5.0 * params.habit.internode);
        params.world.environment = growth::Environment::Space(space);
    }
    let params = dice.changed(&params);
    one(params.model(dice.seed(), control)?)
}

fn lsystem(dice: &mut Dice, control: &Control) -> Made {
    let all: Vec<_> = presets().collect();
    let Some(preset) = all.get(dice.below(all.len())) else { return Ok(Vec::new()) };
    let mut system = preset.system()?;
    let usual = system.steps.unwrap_or(4).min(6);
    system.steps = Some(dice.below(usual as usize + 1) as u32);
    turtle(&mut system, dice);
    one(system.model(dice.seed(), control)?)
}

fn turtle(system: &mut LSystem, dice: &mut Dice) {
    if dice.chance(0.6) {
        return;
    }
    for _ in 0..=dice.below(2) {
        let nasty = dice.nasty();
        let turtle = &mut system.turtle;
        match dice.below(10) {
            0 => turtle.step = nasty,
            1 => turtle.width = nasty,
            2 => turtle.angle = nasty,
            3 => turtle.width_ratio = nasty,
            4 => turtle.leaf_size = nasty,
            5 => turtle.tropism.x = nasty as f32,
            6 => turtle.elasticity = nasty,
            7 => turtle.unit = nasty,
            8 => turtle.height = Some(nasty as f32),
            _ => turtle.trunk_radius = Some(nasty as f32),
        }
    }
}

fn grammar(dice: &mut Dice, control: &Control) -> Made {
    let text = drawn::grammar(dice);
    let mut system = LSystem::parse(&text, &control.limits)?;
    system.steps = Some(1 + dice.below(5) as u32);
    turtle(&mut system, dice);
    one(system.model(dice.seed(), control)?)
}

fn silhouette(dice: &mut Dice, control: &Control) -> Made {
    let mut params = SilhouetteParams::default();
    params.grow.depth = Some(1 + dice.below(2) as u32);
    if dice.chance(0.5) {
        params.grow.leaves = None;
    }
    let (strokes, params) = (drawn::outlines(dice), dice.changed(&params));
    one(SilhouetteModel { strokes, params }.model(dice.seed(), control)?)
}

fn sketch(dice: &mut Dice, control: &Control) -> Made {
    let mut params = SketchParams { height: Some(5.0), ..SketchParams::default() };
    if dice.chance(0.5) {
        params.finish.leaves = false;
    }
    let (drawing, params) = (drawn::sketch(dice), dice.changed(&params));
    one(SketchModel { drawing, params, ..SketchModel::default() }.model(dice.seed(), control)?)
}

fn particle(dice: &mut Dice, control: &Control) -> Made {
    let mut params = PhotoParams { branches: 3, ..PhotoParams::default() };
    params.flow.particles = 20;
    params.density.resolution = 8;
    params.field.rows = 12;
    params.livewire.rows = 24;
    if dice.chance(0.6) {
        params.finish.leaves = None;
    }
    let mut shots = Vec::new();
    for _ in 0..=dice.below(3) / 2 {
        let yaw = dice.coordinate(3.0, 0.05);
        shots.push(Shot::new(drawn::matte(dice)?, None, yaw));
    }
    let params = dice.changed(&params);
    one(PhotoModel { shots, params }.model(dice.seed(), control)?)
}

/// A skeleton as a modeler makes it, or as none should.
fn any_skeleton(dice: &mut Dice) -> Skeleton {
    let seed = dice.seed();
    if dice.chance(0.5) { skeletons::tame(seed) } else { skeletons::nasty(seed) }
}

/// A mesh of ours, with holes and broken corners.
fn mesh(dice: &mut Dice, control: &Control) -> Made {
    let tree = Tree::bare(any_skeleton(dice), Species::default());
    let params = MeshParams { max_sides: 6, ..MeshParams::default() };
    let built = tree_mesh::build(&tree, &Look::plain(tree.species()), &params, control);
    let Ok(mut built) = built else { return Ok(Vec::new()) };
    let Some(mut surface) = built.mesh.surfaces.drain(..).next() else { return Ok(Vec::new()) };
    for _ in 0..dice.below(6) {
        let (n, corners) = (surface.positions.len(), surface.indices.len());
        let (vertex, corner) = (dice.below(n), dice.below(corners));
        match dice.below(6) {
            0 => surface
                .positions
                .iter_mut()
                .skip(vertex)
                .take(1)
                .for_each(|p| p.x = dice.nasty() as f32),
            1 => surface.indices.truncate(corner),
            2 => surface
                .indices
                .iter_mut()
                .skip(corner)
                .take(1)
                .for_each(|i| *i = dice.below(2 * n) as u32),
            3 => surface.indices.iter_mut().skip(corner).take(30).for_each(|i| *i = vertex as u32),
            4 => surface.uvs.clear(),
            _ => surface.positions.iter_mut().for_each(|p| *p *= 1e-6),
        }
    }
    let part = Part {
        positions: &surface.positions,
        uvs: &surface.uvs,
        indices: &surface.indices,
        name: "bark",
        ..Part::default()
    };
    let params = dice.changed(&SkeletonizeParams::default());
    one(skeletonize(&[part], &params, control)?.tree)
}

/// Points on branches, and points that are nowhere.
fn scan(dice: &mut Dice, control: &Control) -> Made {
    let skeleton = any_skeleton(dice);
    let mut points: Vec<DVec3> = Vec::new();
    for (a, b) in skeleton.segments() {
        let [p, q] = [a, b].map(|node| skeleton.positions()[node as usize]);
        for _ in 0..dice.below(30) {
            let at = p.lerp(q, dice.between(0.0, 1.0));
            let radius = skeleton.radii()[b as usize];
            points.push((at + radius * dice.direction()).as_dvec3());
        }
    }
    for _ in 0..dice.below(10) {
        points.push(dice.point(10.0, 0.03).as_dvec3());
    }
    let several = dice.chance(0.3);
    let params = dice.changed(&ScanParams { up: UpAxis::Y, several, ..ScanParams::default() });
    let trees = skeletonize_scan(&points, &params, control)?.trees;
    Ok(trees.into_iter().map(|tree| Tree::bare(tree.skeleton, Species::default())).collect())
}

/// Trees that grew in the open: making them anew for every scene would take all the time.
fn grown() -> &'static [Tree] {
    static GROWN: OnceLock<Vec<Tree>> = OnceLock::new();
    GROWN.get_or_init(|| {
        let trees = growth::PRESETS.iter().filter_map(|preset| {
            let params = growth::GrowthParams { iterations: 6, ..preset.params() };
            params.model(Seed(1), &Control::default()).ok()
        });
        trees.collect()
    })
}

fn volume(dice: &mut Dice) -> Option<Volume> {
    let (a, b) = (dice.point(3.0, 0.01), dice.point(3.0, 0.01));
    let size = dice.coordinate(2.0, 0.1).abs();
    match dice.below(5) {
        0 => Volume::box_solid(a.min(b), a.max(b)).ok(),
        1 => Volume::sphere(a, size).ok(),
        2 => Volume::half_space(a, dice.direction()).ok(),
        3 => Volume::sphere(a, size).ok()?.union(&Volume::sphere(b, 0.5).ok()?).ok(),
        _ => Volume::box_solid(a.min(b), a.max(b))
            .ok()?
            .difference(&Volume::sphere(a, size).ok()?)
            .ok(),
    }
}

fn pose(dice: &mut Dice) -> Pose {
    let position = dice.point(5.0, 0.01) * Vec3::new(1.0, 0.1, 1.0);
    Pose { position, rotation: dice.rotation(0.02) }
}

fn plastic(dice: &mut Dice, control: &Control) -> Made {
    let (mut sky, mut response) = (Sky::default(), Response::default());
    match dice.below(3) {
        0 => sky = dice.changed(&sky),
        1 => response = dice.changed(&response),
        _ => {}
    }
    let mut scene = Scene::new(sky, response)?;
    let mut ids: Vec<TreeId> = Vec::new();
    for _ in 0..=dice.below(2) {
        let trees = grown();
        let tree = match trees.get(dice.below(trees.len() + 2)) {
            Some(tree) => tree.clone(),
            None => Tree::bare(any_skeleton(dice), Species::default()),
        };
        let mut params = PlasticParams::default();
        if dice.chance(0.3) {
            params = dice.changed(&params);
        }
        let model = Arc::new(PlasticTree::new(tree, &params, control)?);
        ids.push(scene.add_tree(model, pose(dice))?);
    }
    for _ in 0..dice.below(3) {
        if let Some(volume) = volume(dice) {
            let obstacle = scene.add_obstacle(volume, pose(dice))?;
            scene.update(control)?;
            scene.move_obstacle(obstacle, pose(dice))?;
        }
    }
    scene.update(control)?;
    let mut trees = Vec::new();
    for id in ids {
        trees.push(scene.adapted(id, control)?.tree);
        if dice.chance(0.3) {
            let params = dice.changed(&Regrowth { years: 2, ..Regrowth::of(scene.model(id)?) });
            trees.push(scene.regrown(id, &params, dice.seed(), control)?.tree);
        }
    }
    Ok(trees)
}

fn foliage(dice: &mut Dice, control: &Control) -> Made {
    let Some(preset) = SPECIES.get(dice.below(SPECIES.len())) else { return Ok(Vec::new()) };
    let (mut twigs, mut leaves) = (preset.twigs.clone(), preset.leaves.clone());
    if dice.chance(0.5) {
        twigs = dice.changed(&twigs);
    } else {
        leaves = dice.changed(&leaves);
    }
    let mut skeleton = any_skeleton(dice);
    if dice.chance(0.5) {
        skeleton = grow_twigs(&skeleton, &twigs, dice.seed(), control)?.skeleton;
    }
    let leaf_kinds = vec![preset.leaf_kind.to_owned(); 1 + usize::from(leaves.kind).min(9)];
    let species = Species { leaf_kinds, ..Species::default() };
    if dice.chance(0.3) {
        let made = grow_leaves_with_stalks(&skeleton, &leaves, None, dice.seed(), control)?;
        return one(Tree::new(made.skeleton, made.foliage, species)?);
    }
    let made = grow_leaves_and_report(&skeleton, &leaves, None, dice.seed(), control)?;
    one(Tree::new(skeleton, made.foliage, species)?)
}
