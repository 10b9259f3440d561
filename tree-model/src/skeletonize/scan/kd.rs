//! Points in a k-d tree (Bentley 1975), to find the nearest ones.
//!
//! Scans hold places a thousand times denser than others, where a uniform grid is slow, and points
//! that share a coordinate. Every node keeps the box of its points, which cuts searches shorter than
//! the splitting planes would.

use glam::Vec3;
use rayon::prelude::*;

/// Most points of a leaf.
const LEAF: usize = 10;
/// Halves with more points are built side by side.
const APART: usize = 8192;
/// Label of tree nodes whose points have different ones.
const MIXED: u32 = u32::MAX;

/// One point: where it is and its number in the input.
type Item = (Vec3, u32);

#[derive(Clone, Copy, Debug)]
struct Node {
    low: Vec3,
    high: Vec3,
    start: u32,
    end: u32,
    /// How far behind this node its right child stands, the left one is next; 0 for leaves.
    right: u32,
}

/// Points sorted into boxes. They are numbered anew, so that near ones have near numbers.
#[derive(Debug)]
pub(super) struct Kd {
    points: Vec<Vec3>,
    /// The number of each point in the input.
    order: Vec<u32>,
    nodes: Vec<Node>,
}

impl Kd {
    /// O(n log n).
    pub(super) fn new(points: &[Vec3]) -> Self {
        let mut items: Vec<Item> = points.iter().copied().zip(0..).collect();
        let nodes = build(&mut items, 0);
        let (points, order) = items.into_iter().unzip();
        Self { points, order, nodes }
    }

    /// The points in their new order.
    pub(super) fn points(&self) -> &[Vec3] {
        &self.points
    }

    /// The number that each point had.
    pub(super) fn order(&self) -> &[u32] {
        &self.order
    }

    /// The nearest points, nearest first, as squared distance and number; at most as many as `found`
    /// may hold, none farther than `reach`. `found` is overwritten; returns how many there are.
    pub(super) fn nearest(&self, at: Vec3, reach: f32, found: &mut [(f32, u32)]) -> usize {
        let mut search = Search { at, reach2: reach * reach, found, n: 0 };
        if !self.nodes.is_empty() && !search.found.is_empty() {
            self.descend(0, &mut search);
        }
        search.n
    }

    fn descend(&self, number: usize, search: &mut Search<'_>) {
        let node = &self.nodes[number];
        if node.right == 0 {
            for i in node.start..node.end {
                search.take(self.points[i as usize], i);
            }
            return;
        }
        let children = [number + 1, number + node.right as usize];
        let away = children.map(|child| away2(&self.nodes[child], search.at));
        let first = usize::from(away[1] < away[0]);
        for i in [first, 1 - first] {
            if away[i] <= search.reach2 {
                self.descend(children[i], search);
            }
        }
    }

    /// All points at most `reach` away, as squared distance and number, in rising numbers.
    pub(super) fn within(&self, at: Vec3, reach: f32, visit: &mut dyn FnMut(f32, u32)) {
        let mut stack = Vec::with_capacity(32);
        if !self.nodes.is_empty() {
            stack.push(0_usize);
        }
        while let Some(number) = stack.pop() {
            let node = &self.nodes[number];
            if away2(node, at) > reach * reach {
                continue;
            }
            if node.right > 0 {
                stack.extend([number + node.right as usize, number + 1]);
                continue;
            }
            for i in node.start..node.end {
                let d2 = at.distance_squared(self.points[i as usize]);
                if d2 <= reach * reach {
                    visit(d2, i);
                }
            }
        }
    }

    /// For each tree node the label that all its points share, for [`Kd::nearest_other`].
    pub(super) fn shared_labels(&self, labels: &[u32]) -> Vec<u32> {
        let mut shared = vec![MIXED; self.nodes.len()];
        for (number, node) in self.nodes.iter().enumerate().rev() {
            shared[number] = if node.right == 0 {
                let mut own = labels[node.start as usize..node.end as usize].iter();
                let first = own.next().copied().unwrap_or(MIXED);
                if own.all(|&label| label == first) { first } else { MIXED }
            } else {
                let (left, right) = (shared[number + 1], shared[number + node.right as usize]);
                if left == right { left } else { MIXED }
            };
        }
        shared
    }

    /// The nearest point with another label than `own`, nearer than `reach2` (squared), as squared
    /// distance and number.
    pub(super) fn nearest_other(
        &self,
        at: Vec3,
        own: u32,
        mut reach2: f32,
        labels: &[u32],
        shared: &[u32],
    ) -> Option<(f32, u32)> {
        let mut best = None;
        let mut stack = vec![(0.0, 0_usize)];
        while let Some((away, number)) = stack.pop() {
            if away >= reach2 || shared[number] == own {
                continue;
            }
            let node = &self.nodes[number];
            if node.right > 0 {
                let children = [number + 1, number + node.right as usize];
                let away = children.map(|child| away2(&self.nodes[child], at));
                // The nearer one last, to be taken first.
                let last = usize::from(away[1] < away[0]);
                stack.extend([1 - last, last].map(|i| (away[i], children[i])));
                continue;
            }
            for i in node.start..node.end {
                let d2 = at.distance_squared(self.points[i as usize]);
                if labels[i as usize] != own && d2 < reach2 {
                    (reach2, best) = (d2, Some((d2, i)));
                }
            }
        }
        best
    }
}

/// What a search for the nearest has found so far.
struct Search<'a> {
    at: Vec3,
    reach2: f32,
    found: &'a mut [(f32, u32)],
    n: usize,
}

impl Search<'_> {
    fn take(&mut self, point: Vec3, number: u32) {
        let d2 = self.at.distance_squared(point);
        if d2 > self.reach2 {
            return;
        }
        let new = (d2, number);
        if self.n == self.found.len() {
            if new >= self.found[self.n - 1] {
                return;
            }
        } else {
            self.n += 1;
        }
        let mut at = self.n - 1;
        while at > 0 && self.found[at - 1] > new {
            self.found[at] = self.found[at - 1];
            at -= 1;
        }
        self.found[at] = new;
        if self.n == self.found.len() {
            self.reach2 = self.reach2.min(self.found[self.n - 1].0);
        }
    }
}

/// Squared distance of a point to the box of a node.
fn away2(node: &Node, at: Vec3) -> f32 {
    at.distance_squared(at.clamp(node.low, node.high))
}

/// Tree nodes of some points, each before its children; sorts the points.
fn build(items: &mut [Item], start: u32) -> Vec<Node> {
    let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for (point, _) in &*items {
        (low, high) = (low.min(*point), high.max(*point));
    }
    let end = start + items.len() as u32;
    let mut node = Node { low, high, start, end, right: 0 };
    if items.len() <= LEAF {
        return if items.is_empty() { Vec::new() } else { vec![node] };
    }
    let axis = (high - low).max_position();
    let half = items.len() / 2;
    items.select_nth_unstable_by(half, |a, b| a.0[axis].total_cmp(&b.0[axis]).then(a.1.cmp(&b.1)));
    let (below, above) = items.split_at_mut(half);
    let middle = start + half as u32;
    let (left, right) = if below.len() > APART {
        rayon::join(|| build(below, start), || build(above, middle))
    } else {
        (build(below, start), build(above, middle))
    };
    node.right = left.len() as u32 + 1;
    let mut nodes = Vec::with_capacity(1 + left.len() + right.len());
    nodes.push(node);
    nodes.extend(left);
    nodes.extend(right);
    nodes
}

/// Median distance of points to their `k`-th neighbour, over at most `n_samples` of them; `None` when
/// there are no `k` neighbours.
pub(super) fn spacing(kd: &Kd, k: usize, n_samples: usize) -> Option<f32> {
    let points = kd.points();
    let stride = points.len().div_ceil(n_samples.max(1)).max(1);
    let mut distances: Vec<f32> = (0..points.len().div_ceil(stride))
        .into_par_iter()
        .filter_map(|i| {
            let mut found = vec![(0.0, 0); k + 1];
            let n = kd.nearest(points[i * stride], f32::INFINITY, &mut found);
            (n > k).then(|| found[k].0.sqrt())
        })
        .collect();
    if distances.is_empty() {
        return None;
    }
    let middle = distances.len() / 2;
    Some(*distances.select_nth_unstable_by(middle, f32::total_cmp).1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cloud() -> impl Strategy<Value = Vec<Vec3>> {
        // Few values, so that points share coordinates and places.
        let place = [-4_i8..4, -4_i8..4, -4_i8..4];
        prop::collection::vec(place.prop_map(|p| Vec3::from(p.map(f32::from))), 1..200)
    }

    proptest! {
        #[test]
        fn the_nearest_are_those_of_a_plain_search(points in cloud(), k in 1_usize..12) {
            let kd = Kd::new(&points);
            let at = Vec3::new(0.3, -0.2, 1.1);
            let mut all: Vec<(f32, u32)> =
                kd.points().iter().zip(0..).map(|(p, i)| (p.distance_squared(at), i)).collect();
            all.sort_by(|a, b| a.partial_cmp(b).unwrap());
            let mut found = vec![(0.0, 0); k];
            let n = kd.nearest(at, 3.0, &mut found);
            let expected: Vec<_> = all.iter().copied().take(k).filter(|a| a.0 <= 9.0).collect();
            prop_assert_eq!(&found[..n], &expected[..]);
            let mut near = Vec::new();
            kd.within(at, 2.0, &mut |d2, i| near.push((i, d2)));
            prop_assert!(near.windows(2).all(|two| two[0].0 < two[1].0));
            prop_assert_eq!(near.len(), all.iter().filter(|a| a.0 <= 4.0).count());
        }

        #[test]
        fn the_nearest_other_has_another_label(points in cloud(), n_labels in 1_u32..4) {
            let kd = Kd::new(&points);
            let labels: Vec<u32> = kd.order().iter().map(|i| i % n_labels).collect();
            let shared = kd.shared_labels(&labels);
            let at = points[0];
            let least = kd.points().iter().zip(&labels).filter(|(_, label)| **label != 0)
                .map(|(p, _)| p.distance_squared(at)).fold(f32::INFINITY, f32::min);
            let found = kd.nearest_other(at, 0, f32::INFINITY, &labels, &shared);
            prop_assert_eq!(found.map_or(f32::INFINITY, |(d2, _)| d2), least);
        }
    }

    #[test]
    fn every_point_keeps_its_number() {
        let points: Vec<Vec3> =
            (0..1000).map(|i| Vec3::new((i * 37 % 101) as f32, i as f32, 0.0)).collect();
        let kd = Kd::new(&points);
        for (point, &number) in kd.points().iter().zip(kd.order()) {
            assert_eq!(*point, points[number as usize]);
        }
        assert!((spacing(&kd, 1, 50).unwrap() - 1.0).abs() < 40.0);
    }
}
