//! Several trees that compete, grown iteration by iteration.

use super::grown::tree_grown;
use super::params::{plants, tree_growth_plant, world};
use super::world::tree_growth_world;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_PARAMETER, Versioned, call, fill, free, get, lock_now, out,
    tree_status, vec3s, write,
};
use crate::control::{limits, run, tree_control};
use std::sync::{Mutex, MutexGuard};
use tree_model::growth::{MAX_ITERATIONS, Plant, Simulation, World};
use tree_model::tree_core::{Control, Resource, Seed};

/// Trees that compete for the same light or space, in the middle of their growth.
///
/// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work on it,
/// from a progress callback too, is `TREE_ERROR_ORDER`. The trees it hands out do not change with it.
pub struct tree_growth(Mutex<Simulation>);

impl Handle for tree_growth {
    const NAME: &'static str = "tree_growth";
}

/// How far trees have grown.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_growth_counts {
    /// `sizeof(tree_growth_counts)`.
    pub struct_size: usize,
    /// Iterations done.
    pub n_iterations: usize,
    /// Number of trees.
    pub n_plants: usize,
    /// Nodes of all trees, bases included.
    pub n_nodes: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_growth_counts {
    const NAME: &'static str = "tree_growth_counts";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self { struct_size: size_of::<Self>(), n_iterations: 0, n_plants: 0, n_nodes: 0 }
    }
}

unsafe fn lock<'a>(growth: *const tree_growth) -> Result<MutexGuard<'a, Simulation>> {
    lock_now(&unsafe { get(growth, "growth") }?.0, "growth")
}

/// What trees grow in, and which.
unsafe fn given(
    world: *const tree_growth_world,
    first: *const tree_growth_plant,
    n_plants: usize,
) -> Result<(World, Vec<Plant>)> {
    let world = unsafe { self::world(world, "world") }?;
    Ok((world, unsafe { plants(first, n_plants) }?))
}

/// Does `n` iterations.
fn iterate(mut simulation: Simulation, n: u32, control: &Control) -> Result<Simulation> {
    let left = MAX_ITERATIONS.saturating_sub(simulation.iteration());
    if n > left {
        let text = format!(
            "iterations is {n}, allowed is 0 to {left}: no more than {MAX_ITERATIONS} in all"
        );
        return Err(Failure::new(TREE_ERROR_PARAMETER, text));
    }
    for done in 0..n {
        control.report("growth", done as f32 / n as f32)?;
        simulation.step(control)?;
    }
    Ok(simulation)
}

/// Plants seedlings: a base and one internode each, 1 to 100,000 of them. `world` and `control` may be NULL. Free it with
/// `tree_growth_free`. `TREE_ERROR_PARAMETER` names what is out of range; `TREE_ERROR_NO_RESULT` for a seedling in the
/// obstacle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_new(
    world: *const tree_growth_world,
    plants: *const tree_growth_plant,
    n_plants: usize,
    seed: u64,
    control: *const tree_control,
    growth: *mut *mut tree_growth,
) -> tree_status {
    unsafe { tree_growth_stand(world, plants, n_plants, 0, seed, control, growth) }
}

/// As `tree_growth_new`, and grows them for `iterations`, 0 to 10,000. `tree_growth_grown` hands out the trees.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_stand(
    world: *const tree_growth_world,
    plants: *const tree_growth_plant,
    n_plants: usize,
    iterations: u32,
    seed: u64,
    control: *const tree_control,
    growth: *mut *mut tree_growth,
) -> tree_status {
    call(|| {
        let place = unsafe { out(growth, "growth") }?;
        let (world, plants) = unsafe { given(world, plants, n_plants) }?;
        let body = |control: &Control| {
            iterate(Simulation::new(&world, &plants, Seed(seed), control)?, iterations, control)
        };
        place.put(tree_growth(Mutex::new(unsafe { run(control, body) }?)));
        Ok(())
    })
}

/// Goes on for `iterations`: in each, buds sense, vigour is shared out, shoots grow, weak branches are shed. `control` may
/// be NULL. After an error all is as it was: the iterations are done on a copy, which takes as much memory again.
/// `TREE_ERROR_PARAMETER` beyond 10,000 iterations in all; `TREE_ERROR_LIMIT` comes before more nodes or voxels are made
/// than allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_step(
    growth: *mut tree_growth,
    iterations: u32,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(growth) }?;
        let copy = held.clone();
        *held = unsafe { run(control, |control| iterate(copy, iterations, control)) }?;
        Ok(())
    })
}

/// Counts iterations, trees and nodes. Set `counts->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_measure(
    growth: *const tree_growth,
    counts: *mut tree_growth_counts,
) -> tree_status {
    call(|| {
        let held = unsafe { lock(growth) }?;
        let value = tree_growth_counts {
            n_iterations: held.iteration() as usize,
            n_plants: held.n_plants(),
            n_nodes: held.n_nodes(),
            ..tree_growth_counts::default_value()
        };
        unsafe { write(counts, "counts", &value) }
    })
}

/// The light as it is now at `n_points` points, three floats each in metres: 0 to the world's brightness, into `light`,
/// which has room for as many. `control` may be NULL; `nodes` of its limits caps the points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_light(
    growth: *const tree_growth,
    points: *const f32,
    n_points: usize,
    control: *const tree_control,
    light: *mut f32,
) -> tree_status {
    call(|| {
        let held = unsafe { lock(growth) }?;
        let limits = unsafe { limits(control) }?;
        let points = unsafe { vec3s(points, n_points, &limits, Resource::Nodes, "points") }?;
        if let Some(at) = points.iter().position(|point| !point.is_finite()) {
            let text = format!("points[{at}] is not finite");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        let found: Vec<f32> = points.iter().map(|&point| held.light(point)).collect();
        if found.is_empty() {
            return Ok(());
        }
        unsafe { fill(light, n_points, &found, "light") }
    })
}

/// A tree as it is now, with radii, leaves and ages. `index` is its place among the plants. `control` may be NULL. Free it
/// with `tree_grown_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_grown(
    growth: *const tree_growth,
    index: usize,
    control: *const tree_control,
    grown: *mut *mut tree_grown,
) -> tree_status {
    call(|| {
        let place = unsafe { out(grown, "grown") }?;
        let held = unsafe { lock(growth) }?;
        let held = &*held;
        let found = unsafe { run(control, |control| Ok(held.grown(index, control)?)) }?;
        place.put(tree_grown::new(found));
        Ok(())
    })
}

/// A second one in the state of the first, to try something. Free it too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_copy(
    growth: *const tree_growth,
    copy: *mut *mut tree_growth,
) -> tree_status {
    call(|| {
        let place = unsafe { out(copy, "copy") }?;
        let simulation = unsafe { lock(growth) }?.clone();
        place.put(tree_growth(Mutex::new(simulation)));
        Ok(())
    })
}

/// Frees growing trees. Trees handed out live on. `TREE_ERROR_ORDER` while a call is at work on them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_free(growth: *mut tree_growth) -> tree_status {
    call(|| {
        if !growth.is_null() {
            // Waits for no one: who holds it would go on with what is freed.
            drop(unsafe { lock(growth) }?);
        }
        unsafe { free(growth, "growth") }
    })
}
