//! The light map of bark: every axis unrolled into a rectangle of its own.
//!
//! An axis is as wide as its largest girth and as high as it is long; a hole over the seam makes it
//! wider by what reaches beyond. Bridges lie in the holes of their host's rectangle, the trunk's base in
//! a square of its own. Rectangles are laid on shelves, tallest first, at the largest scale at which
//! they fit. So texels have about the same size on thick wood; thin ends get more than their share.
//!
//! Cost: O(axes · log axes), a few rounds of shelves, and one pass over the vertices.

use super::plan::{Kind, NONE, Plan};
use crate::error::Result;
use crate::lightmap::BARK;
use crate::mesh::Surface;
use crate::params::MeshParams;
use glam::Vec2;
use std::f32::consts::TAU;
use tree_core::Control;

/// Empty border of a rectangle as a share of its sides.
const BORDER: f32 = 0.03;
/// Scales are tried in steps of this factor.
const SHRINK: f32 = 0.94;
/// Axes between looks at the cancel flag.
const AXES_PER_CHECK: usize = 1024;

/// A rectangle of texture coordinates, and where in the light map it lies.
#[derive(Clone, Copy, Debug, Default)]
struct Chart {
    /// Lowest texture coordinates, and the extent.
    from: Vec2,
    extent: Vec2,
    /// Size in metres.
    size: Vec2,
    /// Lowest corner in the light map.
    corner: Vec2,
}

impl Chart {
    fn place(&self, uv: Vec2, scale: f32) -> Vec2 {
        let share = (uv - self.from) / self.extent.max(Vec2::splat(f32::MIN_POSITIVE));
        let share = share.clamp(Vec2::ZERO, Vec2::ONE) * (1.0 - 2.0 * BORDER) + BORDER;
        self.corner + share * self.size * scale
    }
}

/// Fills the light-map coordinates of a bark whose other columns are full.
///
/// # Errors
/// [`Cancelled`](tree_core::Cancelled).
pub(super) fn fill(
    plan: &Plan,
    params: &MeshParams,
    surface: &mut Surface,
    control: &Control,
) -> Result<()> {
    let mut charts = charts(plan, params);
    let scale = lay_out(&mut charts);
    let base = charts.len() - 1;
    let mut first = 0;
    for (i, &axis) in plan.order.iter().enumerate() {
        if i % AXES_PER_CHECK == 0 {
            control.check()?;
        }
        let planned = &plan.axes[axis as usize];
        let n_own: u32 = plan.rings(axis).iter().map(|ring| ring.n + 1).sum::<u32>()
            + plan.rings(axis).last().map_or(0, |ring| ring.n);
        let rows = first..first + planned.n_vertices as usize;
        first = rows.end;
        let rest = if planned.kind == Kind::Trunk { base } else { planned.host as usize };
        let uvs = surface.uvs[rows.clone()].iter().zip(&mut surface.uvs2[rows]);
        for (k, (&uv, out)) in uvs.enumerate() {
            let chart = if (k as u32) < n_own { axis as usize } else { rest };
            *out = charts.get(chart).map_or(Vec2::ZERO, |chart| chart.place(uv, scale));
        }
    }
    Ok(())
}

/// A chart for each axis, and one for the trunk's base.
fn charts(plan: &Plan, params: &MeshParams) -> Vec<Chart> {
    let mut beyond = vec![0.0_f32; plan.axes.len()];
    for axis in plan.axes.iter().filter(|axis| axis.host != NONE) {
        let Some(ring) = plan.rings(axis.host).get(axis.hole_ring as usize) else { continue };
        let end = (axis.hole.column + axis.hole.width) as f32 / ring.n as f32;
        let most = &mut beyond[axis.host as usize];
        *most = most.max(end - 1.0);
    }
    let mut charts: Vec<Chart> = (0..plan.axes.len())
        .map(|axis| {
            let rings = plan.rings(axis as u32);
            let (Some(low), Some(high)) = (rings.first(), rings.last()) else {
                return Chart::default();
            };
            let wide = 1.0 + beyond[axis];
            // Room for the cap or the point above the last ring.
            let tip = plan.curves.get(axis as u32).map_or(0.0, |curve| curve.length());
            let top = tip.max(high.station.along) + 2.0 * high.station.radius;
            let rise = top - low.station.along;
            let flare = plan.flare(axis as u32);
            let wide_of = |s: super::curve::Station| s.radius * flare.widest(s.along);
            let widest = rings.iter().map(|ring| wide_of(ring.station)).fold(0.0, f32::max);
            Chart {
                from: Vec2::new(0.0, -top / params.bark_length),
                extent: Vec2::new(plan.axes[axis].repeats * wide, rise / params.bark_length),
                size: Vec2::new(TAU * widest * wide, rise) / (1.0 - 2.0 * BORDER),
                corner: Vec2::ZERO,
            }
        })
        .collect();
    let foot = plan
        .rings(0)
        .first()
        .map_or(0.0, |ring| 2.0 * ring.station.radius * plan.flare.widest(ring.station.along));
    charts.push(Chart {
        from: Vec2::splat(-0.5 * foot / params.bark_width),
        extent: Vec2::splat(foot / params.bark_width),
        size: Vec2::splat(foot / (1.0 - 2.0 * BORDER)),
        corner: Vec2::ZERO,
    });
    charts
}

/// Lays the charts on shelves and returns the scale from metres.
fn lay_out(charts: &mut [Chart]) -> f32 {
    let height = BARK.1 - BARK.0;
    let mut order: Vec<u32> = (0..charts.len() as u32).collect();
    order.sort_by(|&a, &b| {
        charts[b as usize].size.y.total_cmp(&charts[a as usize].size.y).then(a.cmp(&b))
    });
    let most = charts.iter().fold(Vec2::ZERO, |most, chart| most.max(chart.size));
    let area: f64 = charts.iter().map(|chart| f64::from(chart.size.x * chart.size.y)).sum();
    let by_area = libm::sqrt(f64::from(height) / area.max(f64::MIN_POSITIVE)) as f32;
    let mut scale = by_area.min(1.0 / most.x).min(height / most.y);
    while !shelve(charts, &order, scale, height) && scale > f32::MIN_POSITIVE {
        scale *= SHRINK;
    }
    scale
}

/// Sets corners, shelf by shelf. Returns false where the height does not suffice.
fn shelve(charts: &mut [Chart], order: &[u32], scale: f32, height: f32) -> bool {
    let (mut x, mut y, mut shelf) = (0.0_f32, 0.0_f32, 0.0_f32);
    for &number in order {
        let chart = &mut charts[number as usize];
        let size = chart.size * scale;
        if x + size.x > 1.0 {
            (x, y, shelf) = (0.0, y + shelf, 0.0);
        }
        if y + size.y > height {
            return false;
        }
        chart.corner = Vec2::new(x, BARK.0 + y);
        x += size.x;
        shelf = shelf.max(size.y);
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn charts_lie_in_the_lower_half_and_apart() {
        let mut charts: Vec<Chart> = (0..200)
            .map(|i| Chart {
                size: Vec2::new(0.1 + (i % 7) as f32, 0.2 + (i % 11) as f32),
                ..Default::default()
            })
            .collect();
        let scale = lay_out(&mut charts);
        let ends: Vec<(Vec2, Vec2)> =
            charts.iter().map(|c| (c.corner, c.corner + c.size * scale)).collect();
        let covered: f32 = ends.iter().map(|(a, b)| (b.x - a.x) * (b.y - a.y)).sum();
        assert!(covered > 0.6 * 0.5, "only {covered} of a half is used");
        for (i, (low, high)) in ends.iter().enumerate() {
            assert!(high.x <= 1.0001 && high.y <= 0.5001);
            for (other_low, other_high) in &ends[..i] {
                let apart = low.cmpge(*other_high - 1e-6) | other_low.cmpge(*high - 1e-6);
                assert!(apart.any(), "{i} overlaps");
            }
        }
    }
}
