//! Segments become a skeleton with radii.

use super::params::FinishParams;
use crate::error::Result;
use crate::sketch::propagate::{Propagated, point_at};
use glam::Vec3;
use tree_core::allometry::PipeModel;
use tree_core::{Control, NO_PARENT, Resource, Skeleton, SkeletonColumns};

/// The tree's branches as a skeleton, without the imagined root. All points keep their place, and a node is added
/// wherever a segment begins between two points of its parent.
///
/// # Errors
/// [`ModelError::Parameter`](crate::ModelError::Parameter), [`ModelError::Limit`](crate::ModelError::Limit),
/// [`ModelError::Cancelled`](crate::ModelError::Cancelled), [`ModelError::Core`](crate::ModelError::Core) for
/// points that are not finite.
///
/// # Complexity
/// O(points + segments × log(new laterals of one segment)).
pub fn grow_wood(grown: &Propagated, params: &FinishParams, control: &Control) -> Result<Skeleton> {
    params.validate()?;
    let branches = &grown.branches;
    let n_nodes = (branches.points.len() + branches.len()) as u64;
    control.limits.check(Resource::Nodes, n_nodes)?;
    let skipped = branches.has_imagined_root();
    let base = if skipped { branches.end(0) } else { branches.start(0) };
    let mut nodes = Nodes::new(base, n_nodes as usize);
    let on_way = on_way(grown);
    let mut next = on_way.iter().peekable();
    // The node that each segment begins at, where that is not its parent's end, and the node it ends at.
    let mut begins = vec![NONE; branches.len()];
    let mut ends = vec![0_u32; branches.len()];
    for segment in usize::from(skipped)..branches.len() {
        let points = branches.points(segment);
        let parent = branches.parents()[segment];
        let mut below = match begins[segment] {
            NONE if parent == NO_PARENT => 0,
            NONE => ends[parent as usize],
            node => node,
        };
        for (i, &point) in points.iter().enumerate().skip(1) {
            let here = |child: &&Child| child.parent as usize == segment && child.fork < i as f32;
            while let Some(child) = next.next_if(here) {
                below = nodes.add(below, point_at(points, child.fork));
                begins[child.segment as usize] = below;
            }
            below = nodes.add(below, point);
        }
        ends[segment] = below;
    }
    control.check()?;
    nodes.finish(params)
}

/// What creeps along the ground is as thick as if it were this share of its width high.
const LOWEST: f32 = 0.25;

/// Stands for a node where there is none.
const NONE: u32 = u32::MAX;

/// A segment that begins on the way along its parent.
struct Child {
    parent: u32,
    fork: f32,
    segment: u32,
}

/// All of them, by parent and place.
fn on_way(grown: &Propagated) -> Vec<Child> {
    let branches = &grown.branches;
    let skipped = branches.has_imagined_root();
    let mut children: Vec<Child> = (1..branches.len())
        .map(|segment| Child {
            parent: branches.parents()[segment],
            fork: grown.forks[segment],
            segment: segment as u32,
        })
        .filter(|child| {
            let last = branches.points(child.parent as usize).len() - 1;
            child.fork < last as f32 && !(skipped && child.parent == 0)
        })
        .collect();
    // Stable, and by numbers that are never NaN.
    children.sort_by(|a, b| a.parent.cmp(&b.parent).then(a.fork.total_cmp(&b.fork)));
    children
}

/// A skeleton in the making.
struct Nodes {
    positions: Vec<Vec3>,
    parents: Vec<u32>,
}

impl Nodes {
    fn new(base: Vec3, capacity: usize) -> Self {
        let (mut positions, mut parents) =
            (Vec::with_capacity(capacity), Vec::with_capacity(capacity));
        positions.push(base);
        parents.push(NO_PARENT);
        Self { positions, parents }
    }

    /// Adds a node, unless the one below is at the very place; returns its number.
    fn add(&mut self, below: u32, point: Vec3) -> u32 {
        if self.positions[below as usize] == point {
            return below;
        }
        self.positions.push(point);
        self.parents.push(below);
        self.parents.len() as u32 - 1
    }

    fn finish(self, params: &FinishParams) -> Result<Skeleton> {
        let Self { positions, parents } = self;
        let radii = vec![0.0; positions.len()];
        let mut skeleton = Skeleton::try_from(SkeletonColumns { positions, radii, parents })?;
        let size = skeleton.bounds().size();
        let height = size.y.max(LOWEST * size.max_element());
        let trunk = (params.slenderness * height).clamp(1e-6, 100.0);
        let radii = PipeModel {
            exponent: params.exponent,
            trunk_radius: Some(trunk),
            ..PipeModel::default()
        };
        radii.apply(&mut skeleton)?;
        Ok(skeleton)
    }
}
