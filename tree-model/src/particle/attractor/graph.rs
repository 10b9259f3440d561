//! Attractor graphs: polylines in a picture that lead to the tree's base.

use crate::error::{ModelError, Result};
use crate::particle::Photo;
use crate::particle::draw::{Canvas, Color};
use glam::Vec2;
use tree_core::NO_PARENT;

/// Main branches in one picture, as a forest whose roots are at the tree's base. Coordinates are pixels
/// from the top left, as in a [`Matte`](crate::particle::Matte).
///
/// Parents come before their children, so that one pass visits the graph from the base outwards.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "Columns"))]
pub struct AttractorGraph {
    nodes: Vec<Vec2>,
    parents: Vec<u32>,
}

/// What is read from a file, before it is checked.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct Columns {
    nodes: Vec<Vec2>,
    parents: Vec<u32>,
}

#[cfg(feature = "serde")]
impl TryFrom<Columns> for AttractorGraph {
    type Error = ModelError;

    fn try_from(columns: Columns) -> Result<Self> {
        Self::new(columns.nodes, columns.parents)
    }
}

/// The point of a graph that is nearest to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Row of the node at the upper end of the segment it lies on.
    pub node: u32,
    /// Where on the segment: 0 at the parent, 1 at the node.
    pub share: f32,
    /// The point.
    pub point: Vec2,
    /// How far off it is, in pixels.
    pub distance: f32,
}

impl AttractorGraph {
    /// A graph of `nodes`, each with the row of the node that it leads to, or [`NO_PARENT`] at the base.
    ///
    /// # Errors
    /// [`ModelError::NotFinite`] for a node, [`ModelError::Attractor`] where lengths differ or a
    /// parent does not come before its node.
    pub fn new(nodes: Vec<Vec2>, parents: Vec<u32>) -> Result<Self> {
        let bad = |problem: String| Err(ModelError::Attractor { problem });
        if nodes.len() != parents.len() {
            return bad(format!("{} nodes have {} parents", nodes.len(), parents.len()));
        }
        if let Some(index) = nodes.iter().position(|node| !node.is_finite()) {
            return Err(ModelError::NotFinite { field: format!("attractor.nodes[{index}]") });
        }
        for (node, &parent) in parents.iter().enumerate() {
            if parent != NO_PARENT && parent as usize >= node {
                return bad(format!(
                    "node {node} has parent {parent}, which does not come before it"
                ));
            }
        }
        Ok(Self { nodes, parents })
    }

    /// Where the nodes are, in pixels.
    #[must_use]
    pub fn nodes(&self) -> &[Vec2] {
        &self.nodes
    }

    /// The node each node leads to, one nearer to the base; [`NO_PARENT`] at the base.
    #[must_use]
    pub fn parents(&self) -> &[u32] {
        &self.parents
    }

    /// The graph with left and right exchanged, in a picture of this width.
    #[must_use]
    pub fn mirrored(&self, width: f32) -> Self {
        let nodes = self.nodes.iter().map(|node| Vec2::new(width - node.x, node.y)).collect();
        Self { nodes, parents: self.parents.clone() }
    }

    /// Whether there is no segment.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.parents.iter().all(|&parent| parent == NO_PARENT)
    }

    /// Every segment as (nearer to the base, farther from it).
    pub fn segments(&self) -> impl Iterator<Item = (Vec2, Vec2)> + '_ {
        self.nodes
            .iter()
            .zip(&self.parents)
            .filter(|&(_, &parent)| parent != NO_PARENT)
            .map(|(&node, &parent)| (self.nodes[parent as usize], node))
    }

    /// The nodes that none leads to, roots without children included.
    pub fn tips(&self) -> impl Iterator<Item = u32> + '_ {
        let mut is_parent = vec![false; self.nodes.len()];
        for &parent in self.parents.iter().filter(|&&parent| parent != NO_PARENT) {
            is_parent[parent as usize] = true;
        }
        (0..self.nodes.len() as u32).filter(move |&node| !is_parent[node as usize])
    }

    /// Length of all segments together, in pixels.
    #[must_use]
    pub fn length(&self) -> f32 {
        self.segments().map(|(a, b)| a.distance(b)).sum()
    }

    /// The point of the graph nearest to `point`; `None` for a graph without segments or a point
    /// that is not finite. O(segments).
    #[must_use]
    pub fn nearest(&self, point: Vec2) -> Option<Nearest> {
        let mut best: Option<Nearest> = None;
        for (node, &parent) in self.parents.iter().enumerate() {
            if parent == NO_PARENT {
                continue;
            }
            let (below, above) = (self.nodes[parent as usize], self.nodes[node]);
            let (share, on) = nearest_on(below, above, point);
            let distance = on.distance(point);
            if distance.is_finite() && best.is_none_or(|best| distance < best.distance) {
                best = Some(Nearest { node: node as u32, share, point: on, distance });
            }
        }
        best
    }

    /// The graph drawn over a photograph or any other picture of the same size, with lines of `width`
    /// pixels.
    ///
    /// # Errors
    /// None that can happen.
    pub fn draw_over(&self, photo: &Photo, width: f32, color: Color) -> Result<Photo> {
        let mut canvas = Canvas::over(photo);
        for (below, above) in self.segments() {
            canvas.line(below, above, width, color);
        }
        canvas.finish()
    }
}

/// The point of a segment nearest to `point`, and where on it: 0 at `a`, 1 at `b`.
pub(super) fn nearest_on(a: Vec2, b: Vec2, point: Vec2) -> (f32, Vec2) {
    let along = b - a;
    let share = ((point - a).dot(along) / along.length_squared().max(1e-30)).clamp(0.0, 1.0);
    (share, a + share * along)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fork() -> AttractorGraph {
        let nodes = [(5.0, 9.0), (5.0, 5.0), (2.0, 1.0), (8.0, 1.0)];
        let nodes = nodes.iter().map(|&(x, y)| Vec2::new(x, y)).collect();
        AttractorGraph::new(nodes, vec![NO_PARENT, 0, 1, 1]).unwrap()
    }

    #[test]
    fn parents_come_first_and_nodes_are_finite() {
        let make = |x, parents: Vec<u32>| AttractorGraph::new(vec![Vec2::splat(x); 2], parents);
        assert!(make(0.0, vec![NO_PARENT, 0]).is_ok());
        assert!(make(0.0, vec![NO_PARENT, 1]).is_err());
        assert!(make(0.0, vec![1, NO_PARENT]).is_err());
        assert!(make(0.0, vec![NO_PARENT]).is_err());
        assert!(make(f32::NAN, vec![NO_PARENT, 0]).is_err());
    }

    #[cfg(feature = "serde")]
    #[test]
    fn what_is_read_from_a_file_is_checked() {
        let read =
            |parents| AttractorGraph::try_from(Columns { nodes: vec![Vec2::ONE; 2], parents });
        assert!(read(vec![NO_PARENT, 0]).is_ok());
        assert!(read(vec![1, 0]).is_err());
    }

    #[test]
    fn lengths_tips_and_nearest_points_are_those_of_the_segments() {
        let graph = fork();
        assert_eq!(graph.length(), 14.0);
        assert_eq!(graph.tips().collect::<Vec<_>>(), [2, 3]);
        let near = graph.nearest(Vec2::new(7.0, 7.0)).unwrap();
        assert_eq!((near.node, near.point, near.distance), (1, Vec2::new(5.0, 7.0), 2.0));
        assert_eq!(graph.nearest(Vec2::NAN), None);
        assert_eq!(AttractorGraph::default().nearest(Vec2::ZERO), None);
    }
}
