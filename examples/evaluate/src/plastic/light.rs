//! Eq. 3 against rays.

use super::Outcome;
use crate::table::{Aim, Row, Table};
use std::sync::Arc;
use tree_core::glam::{DVec3, Vec3};
use tree_core::{Control, Seed, Volume};
use tree_model::growth::Preset;
use tree_model::plastic::{Ball, PlasticParams, PlasticTree, Pose, Response, Scene, Sky};

/// Rays for one point, as the issue asks for.
const RAYS: u32 = 100_000;

/// Every so many clusters are checked.
const STRIDE: usize = 3;

/// A wall: low and high corner.
type Wall = (Vec3, Vec3);

/// Every scene's light on leaf clusters, against rays through the same clusters.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    let control = Control::default();
    let mut params = Preset::find("oak")?.params();
    params.habit.leaves = None;
    let tree = params.grow(Seed(3), &control)?.tree;
    let model = Arc::new(PlasticTree::new(tree, &PlasticParams::default(), &control)?);
    let size = model.tree().skeleton().bounds().size();
    let reach = 0.5 * size.x.max(size.z);
    let wall = Some((
        Vec3::new(0.6 * reach, 0.0, -2.0 * reach),
        Vec3::new(0.6 * reach + 0.2, 1.5 * size.y, 2.0 * reach),
    ));
    let low = Sky::towards(1.0, 0.6);
    for (case, n_trees, wall, sky) in [
        ("light: a tree alone", 1, None, Sky::default()),
        ("light: a wall beside it", 1, wall, Sky::default()),
        ("light: a low sun and a wall", 1, wall, low),
        ("light: nine trees close together", 9, None, Sky::default()),
        ("light: 49 trees close together", 49, None, Sky::default()),
    ] {
        let mut scene = Scene::new(sky, Response::default())?;
        let side = f64::from(n_trees).sqrt() as i32;
        for k in 0..n_trees {
            let at = Vec3::new((k % side) as f32, 0.0, (k / side) as f32) * (1.4 * reach);
            scene.add_tree(model.clone(), Pose::at(at))?;
        }
        if let Some((low, high)) = wall {
            scene.add_obstacle(Volume::box_solid(low, high)?, Pose::default())?;
        }
        scene.update(&control)?;
        let (mean, worst) = errors(&scene, wall, &sky)?;
        let row = |metric, ours, aim| Row {
            case,
            metric,
            paper: None,
            peer: None,
            ours: 100.0 * ours,
            unit: "% of sky",
            aim,
        };
        table.row(&row("mean error against 1e5 rays", mean, Aim::AtMost(2.0)));
        table.row(&row("largest error", worst, Aim::AtMost(2.0)));
    }
    Ok(())
}

/// Mean and largest error over clusters of the tree in the middle.
fn errors(scene: &Scene, wall: Option<Wall>, sky: &Sky) -> Outcome<(f64, f64)> {
    let ids: Vec<_> = scene.trees().collect();
    let middle = ids[ids.len() / 2];
    let mut balls = Vec::new();
    let mut targets = Vec::new();
    for id in ids {
        let pose = scene.pose(id)?;
        for (ball, light) in scene.clusters(id)? {
            if id == middle {
                targets.push((balls.len(), light.amount));
            }
            balls.push(Ball { center: pose.rotation * ball.center + pose.position, ..ball });
        }
    }
    let (mut sum, mut worst, mut n) = (0.0, 0.0_f64, 0);
    for &(own, amount) in targets.iter().step_by(STRIDE) {
        let error = (f64::from(amount) - by_rays(own, &balls, wall, sky)).abs();
        sum += error;
        worst = worst.max(error);
        n += 1;
    }
    Ok((sum / f64::from(n), worst))
}

/// The share of the sky's light on the middle of a ball, by rays; inside another ball the part of the sky that the family's
/// definition takes for covered.
fn by_rays(own: usize, balls: &[Ball], wall: Option<Wall>, sky: &Sky) -> f64 {
    let at = balls[own].center.as_dvec3();
    let brightest = sky.light.as_dvec3().normalize();
    struct Caster {
        offset: DVec3,
        radius: f64,
        translucency: f64,
    }
    let casters: Vec<Caster> = balls
        .iter()
        .enumerate()
        .filter(|&(index, _)| index != own)
        .map(|(_, ball)| Caster {
            offset: ball.center.as_dvec3() - at,
            radius: f64::from(ball.radius),
            translucency: f64::from(ball.translucency),
        })
        .filter(|caster| caster.offset.y + caster.radius > 0.0)
        .collect();
    let (mut open, mut seen) = (0.0, 0.0);
    for k in 0..RAYS {
        let y = (f64::from(k) + 0.5) / f64::from(RAYS);
        let flat = (1.0 - y * y).sqrt();
        let turn = 2.399_963_229_728_653 * f64::from(k);
        let way = DVec3::new(flat * libm::cos(turn), y, flat * libm::sin(turn));
        let bright = way.dot(brightest).max(0.0);
        let bright = bright * bright;
        if bright == 0.0 {
            continue;
        }
        let mut through = 1.0;
        for caster in &casters {
            let along = caster.offset.dot(way);
            let distance = caster.offset.length();
            let covered = if distance > caster.radius {
                along > 0.0 && distance * distance - along * along < caster.radius * caster.radius
            } else {
                let sin = distance / caster.radius;
                along > -(1.0 - sin * sin).sqrt() * distance
            };
            if covered {
                through *= caster.translucency;
            }
        }
        if wall.is_some_and(|(low, high)| hits(at, way, low.as_dvec3(), high.as_dvec3())) {
            through = 0.0;
        }
        open += bright;
        seen += bright * through;
    }
    seen / open
}

fn hits(at: DVec3, way: DVec3, low: DVec3, high: DVec3) -> bool {
    let (a, b) = ((low - at) / way, (high - at) / way);
    let enter = a.min(b).max_element().max(0.0);
    enter <= a.max(b).min_element()
}
