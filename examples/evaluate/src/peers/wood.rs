//! What wood is as a surface: closed or not.

use super::{Outcome, beside};
use crate::table::{Aim, Table};
use std::path::Path;
use tree_core::Control;
use tree_mesh::Surface;
use tree_mesh::io::ply;
use tree_mesh::topology::{Topology, examine, self_intersections};

/// Rows that say whether wood is closed, theirs and ours.
pub(super) struct Wood {
    found: Topology,
    /// Per cent of triangles that cross others.
    crossing: f64,
}

impl Wood {
    /// Copies at one place count as one: what only looks joined is joined, in the peer's favour.
    pub(super) fn of(surface: &Surface) -> Outcome<Self> {
        let crossing = self_intersections(surface, &Control::default())?.n_triangles as f64;
        let n = surface.n_triangles().max(1) as f64;
        Ok(Self { found: examine(surface)?, crossing: 100.0 * crossing / n })
    }

    /// The surface in a PLY file.
    pub(super) fn read(path: &Path) -> Outcome<Surface> {
        let mut mesh = ply::read(path, &Control::default())?.mesh;
        if mesh.surfaces.is_empty() {
            return Err("an empty mesh".into());
        }
        Ok(mesh.surfaces.swap_remove(0))
    }

    fn closed(&self) -> f64 {
        f64::from(u8::from(self.found.is_closed() && self.found.volume > 0.0))
    }

    fn open(&self) -> f64 {
        (self.found.boundary_edges + self.found.non_manifold_edges + self.found.misoriented_edges)
            as f64
    }

    pub(super) fn rows(table: &mut Table, case: &str, peer: &Self, ours: &Self) {
        let mut row = |metric, of: fn(&Self) -> f64, unit, aim| {
            beside(table, case, metric, [of(peer), of(ours)], unit, aim);
        };
        row("wood closed (1) or not (0)", Self::closed, "", Aim::AtLeast(1.0));
        row("open, non-manifold edges", Self::open, "edges", Aim::AtMost(0.0));
        row("pieces of wood", |wood| wood.found.components as f64, "", Aim::None);
        row("self-intersecting faces", |wood| wood.crossing, "%", Aim::None);
    }
}
