//! Bark: one closed surface over the wood of the whole tree.
//!
//! Neubert 2012, chapter 5, with another way to build forks. Every axis is a tube of rings along a
//! spline; a lateral stands on a hole in the wall of its parent, and a bridge joins the rim of the hole
//! to the lateral's first ring. The paper joins all branches of a fork over one sphere cut, which takes
//! convexity and room; opening the wall takes neither, works for twigs on trunks, and forks and whorls
//! are but larger and neighbouring holes. The trunk's base and every tip are closed.
//!
//! Why the surface is always closed: a tube with a base and a tip is a sphere. A hole is a disc of
//! triangles, holes share none, and what replaces a disc is a disc: bridge, tube and tip of a lateral.
//! So the whole is a sphere, whatever the skeleton.
//!
//! | file | step |
//! |---|---|
//! | [`curve`], [`curves`] | nodes of each axis, cleaned, on a spline with twist-free frames ([`frame`]) |
//! | [`attach`], [`hosts`] | where a lateral comes out of which axis |
//! | [`storey`] | which part of the wall it gets |
//! | [`rings`], [`circle`] | where rings stand and how many sides they have |
//! | [`plan`] | all of that for all axes, and counts |
//! | [`skin`], [`bridge`], [`flare`] | vertices and triangles |
//! | [`chart`] | light-map coordinates |

mod attach;
mod bridge;
mod chart;
mod circle;
mod curve;
mod curves;
mod flare;
mod frame;
mod hosts;
mod plan;
mod rings;
mod skin;
mod storey;

pub(crate) use plan::{Kind, Plan};

use crate::columns::Columns;
use crate::error::{MeshError, Result};
use crate::mesh::Surface;
use crate::params::MeshParams;
use rayon::prelude::*;
use tree_core::Control;

/// Triangles that one piece of work fills, about.
const TRIANGLES_PER_FILL: u64 = 16_384;

/// Fills a surface of the size that was planned.
///
/// # Errors
/// [`Cancelled`](tree_core::Cancelled).
pub(crate) fn fill(
    plan: &Plan,
    params: &MeshParams,
    surface: &mut Surface,
    control: &Control,
) -> Result<()> {
    let mut rest = Columns::of(surface);
    let mut parts = Vec::new();
    let mut next = 0;
    while next < plan.order.len() {
        let first = next;
        let (mut vertices, mut triangles) = (0, 0);
        while next < plan.order.len() && triangles < TRIANGLES_PER_FILL {
            let axis = &plan.axes[plan.order[next] as usize];
            vertices += axis.n_vertices as usize;
            triangles += u64::from(axis.n_triangles);
            next += 1;
        }
        parts.push((first..next, rest.split(vertices, 3 * triangles as usize)));
    }
    parts.into_par_iter().try_for_each_init(
        bridge::Rims::default,
        |rims, (places, mut part)| {
            for &number in &plan.order[places] {
                control.check()?;
                let axis = &plan.axes[number as usize];
                let (vertices, triangles) = (axis.n_vertices as usize, axis.n_triangles as usize);
                let mut out = part.split(vertices, 3 * triangles);
                skin::Skin::new(plan, number, params).fill(params, rims, &mut out);
                debug_assert_eq!(out.n_vertices, vertices);
                debug_assert_eq!(out.n_indices, 3 * triangles);
            }
            Ok::<(), MeshError>(())
        },
    )?;
    if surface.uvs2.is_empty() { Ok(()) } else { chart::fill(plan, params, surface, control) }
}

#[cfg(test)]
mod tests;
