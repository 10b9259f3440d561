//! Step 6: one skeleton from linked pieces, seen from the root.

use super::link::Forest;
use super::rows::Rows;
use super::slices::NONE;
use super::weld::Soup;
use crate::error::Result;
use glam::Vec3;
use tree_core::{Control, Resource, Skeleton};

/// Links within this share of the radius of a node go to the node.
const SNAP: f32 = 0.35;
/// Nodes within this share of the thinner radius of their parent become one with it.
const MERGE: f32 = 0.3;

/// Joins the pieces. The skeleton is in units of the mesh's size until [`outward`].
pub(super) fn assemble(forest: &Forest, control: &Control) -> Result<Skeleton> {
    let most = forest.parents.len() + forest.links.len();
    control.limits.check(Resource::Nodes, most as u64)?;
    let (mut positions, mut radii) = (forest.positions.clone(), forest.radii.clone());
    let edges = edges(forest, &mut positions, &mut radii);
    let both = edges.iter().flat_map(|&[a, b]| [(a, b), (b, a)]);
    let neighbours = Rows::of_pairs(both, positions.len());
    // Breadth first from the root; `place` is the node that each one became.
    let (mut order, mut place) = (vec![(forest.root, NONE)], vec![NONE; positions.len()]);
    let mut columns = (Vec::new(), Vec::new(), Vec::<u32>::new());
    let mut head = 0;
    while let Some(&(node, parent)) = order.get(head) {
        head += 1;
        let (position, radius) = (positions[node as usize], radii[node as usize]);
        place[node as usize] = match columns.0.get(parent as usize) {
            Some(&at) if near(position, radius, at, columns.1[parent as usize]) => parent,
            _ => {
                columns.0.push(position);
                columns.1.push(radius);
                columns.2.push(parent);
                columns.2.len() as u32 - 1
            }
        };
        for &next in neighbours.of(node) {
            if place[next as usize] == NONE {
                // Taken, until its turn comes: in a tree nobody else reaches it anyway.
                place[next as usize] = place[node as usize];
                order.push((next, place[node as usize]));
            }
        }
    }
    Ok(Skeleton::from_columns(columns.0, columns.1, columns.2)?)
}

fn near(position: Vec3, radius: f32, parent: Vec3, parent_radius: f32) -> bool {
    let distance = position.distance(parent);
    distance <= MERGE * radius.min(parent_radius) || distance <= f32::EPSILON
}

/// Edges of all pieces and links; adds the nodes that links need.
fn edges(forest: &Forest, positions: &mut Vec<Vec3>, radii: &mut Vec<f32>) -> Vec<[u32; 2]> {
    let mut edges = Vec::with_capacity(positions.len() + 2 * forest.links.len());
    let mut links = forest.links.clone();
    links.sort_by(|a, b| {
        (a.node, a.share).partial_cmp(&(b.node, b.share)).unwrap_or(std::cmp::Ordering::Equal)
    });
    let mut links = links.into_iter().peekable();
    for (node, &parent) in forest.parents.iter().enumerate() {
        let node = node as u32;
        let mut last = parent;
        while let Some(link) = links.next_if(|link| link.node == node) {
            let target = split(forest, positions, radii, &link, last);
            if target != last && target != node {
                edges.push([last, target]);
                last = target;
            }
            edges.push([link.end, target]);
        }
        if parent != NONE {
            edges.push([last, node]);
        }
    }
    edges
}

/// The node that a link goes to: an end of its segment, the last new one below, or a new one.
fn split(
    forest: &Forest,
    positions: &mut Vec<Vec3>,
    radii: &mut Vec<f32>,
    link: &super::link::Link,
    last: u32,
) -> u32 {
    let parent = forest.parents[link.node as usize];
    if parent == NONE {
        return link.node;
    }
    let (a, b) = (parent as usize, link.node as usize);
    let place = positions[a].lerp(positions[b], link.share);
    let radius = radii[a] + link.share * (radii[b] - radii[a]);
    for node in [link.node, last] {
        if positions[node as usize].distance(place) <= SNAP * radius {
            return node;
        }
    }
    positions.push(place);
    radii.push(radius);
    positions.len() as u32 - 1
}

/// Brings the skeleton back to the units of the mesh.
pub(super) fn outward(mut skeleton: Skeleton, soup: &Soup) -> Result<Skeleton> {
    let scale = |r: &f32| ((f64::from(*r) * soup.size) as f32).min(f32::MAX);
    skeleton.set_radii(skeleton.radii().iter().map(scale).collect())?;
    let positions = skeleton.positions().iter().map(|&p| soup.outward(p)).collect();
    skeleton.set_positions(positions)?;
    Ok(skeleton)
}
