//! The tree that a walk draws: columns of nodes, leaves and polygons, then their sizes in metres.

use super::params::{Taper, Thickness, TurtleParams};
use super::polygon::{Outline, Polygon};
use super::report::TurtleReport;
use super::walk::{Sink, State};
use crate::error::{ModelError, Result, check};
use crate::glam::{DMat3, DQuat, DVec3, Vec3};

use tree_core::{Control, Foliage, Leaf, NO_PARENT, Resource, Skeleton};

/// Largest coordinate of a tree in metres: beyond it f32 no longer resolves a leaf.
const METRES_MAX: f64 = 1e6;

/// A leaf in units.
#[derive(Debug)]
struct Blade {
    node: u32,
    position: DVec3,
    rotation: DQuat,
    size: f64,
    kind: u16,
}

/// Takes a walk's drawing, in units.
pub(super) struct Wood<'a> {
    control: &'a Control,
    n_kinds: usize,
    polygon_leaves: bool,
    positions: Vec<DVec3>,
    widths: Vec<f64>,
    parents: Vec<u32>,
    blades: Vec<Blade>,
    polygons: Vec<(Outline, u32, u32)>,
    made_of_polygons: usize,
    /// Whether a width was set before any wood was drawn.
    base_known: bool,
}

impl Sink for Wood<'_> {
    fn wood(&mut self, _: usize, turtle: &State, to: DVec3) -> Result<u32> {
        let mut parent = turtle.node;
        if turtle.away {
            parent = self.node(parent, turtle.position, turtle.width)?;
        }
        self.node(parent, to, turtle.width)
    }

    fn leaf(&mut self, module: usize, turtle: &State, size: f64, kind: f64) -> Result<()> {
        if !(0.0..self.n_kinds as f64).contains(&kind) {
            let problem = format!("there is no leaf kind {kind}: the species has {}", self.n_kinds);
            return Err(ModelError::Word { module, problem });
        }
        let frame = turtle.frame;
        let axes = DMat3::from_cols(-frame.left, frame.heading, frame.up);
        self.blade(Blade {
            node: turtle.node,
            position: turtle.position,
            rotation: DQuat::from_mat3(&axes),
            size,
            kind: kind as u16,
        })
    }

    fn polygon(&mut self, turtle: &State, outline: Outline) -> Result<()> {
        self.limit(Resource::Leaves, self.polygons.len())?;
        if self.polygon_leaves
            && let Some(pose) = outline.leaf(turtle.frame.up)
        {
            self.made_of_polygons += 1;
            self.blade(Blade {
                node: turtle.node,
                position: pose.base,
                rotation: pose.rotation,
                size: pose.size,
                kind: 0,
            })?;
        }
        self.polygons.push((outline, turtle.color, turtle.node));
        Ok(())
    }

    fn width(&mut self, width: f64) {
        if self.positions.len() == 1 && !self.base_known {
            self.widths[0] = width;
            self.base_known = true;
        }
    }
}

impl<'a> Wood<'a> {
    pub(super) fn new(params: &TurtleParams, n_kinds: usize, control: &'a Control) -> Self {
        Self {
            control,
            n_kinds,
            polygon_leaves: params.polygon_leaves && n_kinds > 0,
            positions: vec![DVec3::ZERO],
            widths: vec![params.width],
            parents: vec![NO_PARENT],
            blades: Vec::new(),
            polygons: Vec::new(),
            made_of_polygons: 0,
            base_known: false,
        }
    }

    fn limit(&self, resource: Resource, n_there: usize) -> Result<()> {
        Ok(self.control.limits.check(resource, n_there as u64 + 1)?)
    }

    fn node(&mut self, parent: u32, position: DVec3, width: f64) -> Result<u32> {
        let node = self.parents.len();
        self.limit(Resource::Nodes, node)?;
        self.positions.push(position);
        self.widths.push(width);
        self.parents.push(parent);
        Ok(node as u32)
    }

    fn blade(&mut self, blade: Blade) -> Result<()> {
        self.limit(Resource::Leaves, self.blades.len())?;
        self.blades.push(blade);
        Ok(())
    }

    /// Metres, radii, and the parts of the tree.
    pub(super) fn finish(
        self,
        params: &TurtleParams,
        report: &mut TurtleReport,
    ) -> Result<(Skeleton, Foliage, Vec<Polygon>)> {
        let scale = self.scale(params)?;
        report.scale = scale;
        report.polygon_leaves = self.made_of_polygons;
        let metres = |position: DVec3| (scale * position).as_vec3();
        let mut foliage = Foliage::with_capacity(self.blades.len());
        for blade in &self.blades {
            foliage.push(Leaf {
                node: blade.node,
                position: metres(blade.position),
                rotation: blade.rotation.as_quat(),
                size: (scale * blade.size) as f32,
                kind: blade.kind,
            })?;
        }
        let polygon = |(outline, color, node): &(Outline, u32, u32)| Polygon {
            vertices: outline.corners.iter().map(|&corner| metres(corner)).collect(),
            color: *color,
            node: *node,
        };
        let polygons = self.polygons.iter().map(polygon).collect();
        let positions: Vec<Vec3> = self.positions.iter().map(|&p| metres(p)).collect();
        let radii = self.radii(params.taper, scale);
        let mut skeleton = Skeleton::from_columns(positions, radii, self.parents)?;
        thicken(&mut skeleton, params, report.widths)?;
        Ok((skeleton, foliage, polygons))
    }

    /// Metres a unit.
    fn scale(&self, params: &TurtleParams) -> Result<f64> {
        let fold =
            |start: f64, of: fn(&DVec3) -> f64| self.positions.iter().map(of).fold(start, f64::max);
        let extent = fold(0.0, |position| position.abs().max_element());
        let scale = match params.height {
            Some(height) if extent > 0.0 => {
                let top = fold(0.0, |position| position.y);
                // A creeping plant has no height to speak of.
                let size = if top > HEIGHT_SHARE_MIN * extent { top } else { extent };
                f64::from(height) / size
            }
            _ => params.unit,
        };
        let mut reach = extent;
        for corner in self.polygons.iter().flat_map(|(outline, ..)| &outline.corners) {
            reach = reach.max(corner.abs().max_element());
        }
        for blade in &self.blades {
            reach = reach.max(blade.position.abs().max_element()).max(blade.size);
        }
        check("size of the tree in metres", scale * reach, 0.0, METRES_MAX)?;
        let width = self.widths.iter().copied().fold(0.0, f64::max);
        check("width of the wood in metres", scale * width, 0.0, METRES_MAX)?;
        Ok(scale)
    }

    /// Radii by the word's widths.
    fn radii(&self, taper: Taper, scale: f64) -> Vec<f32> {
        let mut widths = self.widths.clone();
        if taper == Taper::Smooth {
            // Children come after their parents, so a pass backwards meets them first.
            let mut above = vec![-1.0_f64; widths.len()];
            for node in (1..widths.len()).rev() {
                let slot = &mut above[self.parents[node] as usize];
                *slot = slot.max(self.widths[node]);
                widths[node] = match above[node] {
                    tip if tip < 0.0 => TIP_RATIO * self.widths[node],
                    next => next,
                };
            }
            widths[0] = if above[0] < 0.0 { self.widths[0] } else { above[0] };
        }
        widths.iter().map(|width| (0.5 * scale * width) as f32).collect()
    }
}

/// A tree lower than this share of its extent is sized by its extent.
const HEIGHT_SHARE_MIN: f64 = 0.05;
/// Width of a tip by that of its segment's base.
const TIP_RATIO: f64 = 0.5;

/// Radii by a rule where one is wanted, and the radius of the base.
fn thicken(skeleton: &mut Skeleton, params: &TurtleParams, widths: bool) -> Result<()> {
    match params.thickness {
        Thickness::Auto(rule) if !widths => rule.apply(skeleton)?,
        Thickness::Rule(rule) => rule.apply(skeleton)?,
        Thickness::Auto(_) | Thickness::Word => {}
    }
    let base = skeleton.radii().first().copied().unwrap_or(0.0);
    if let Some(wanted) = params.trunk_radius.filter(|_| base > 0.0) {
        let factor = f64::from(wanted) / f64::from(base);
        let radii = skeleton.radii().iter().map(|&radius| (factor * f64::from(radius)) as f32);
        skeleton.set_radii(radii.collect())?;
    }
    Ok(())
}
