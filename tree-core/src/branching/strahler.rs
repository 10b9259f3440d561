//! Horton-Strahler orders (Horton 1945; Strahler 1957), made for rivers, used for trees since Leopold (1971).
//!
//! 1. A tip has order 1.
//! 2. A node above which exactly one child has the highest order has that order; where two or more children
//!    share the highest order, the node has one more.
//! 3. A branch of order k is a chain of segments of order k that ends where the order changes.
//!
//! The ratios are Horton's: e to the slope of the straight line through the logarithms, over orders, by least
//! squares; all orders count alike.

use super::length_below;
use crate::skeleton::Skeleton;

/// Horton-Strahler orders of a skeleton.
#[derive(Clone, Debug, PartialEq)]
pub struct Strahler {
    orders: Vec<u32>,
    counts: Vec<u32>,
    lengths: Vec<f64>,
}

impl Strahler {
    /// Orders the nodes.
    ///
    /// # Complexity
    /// O(nodes), two passes, 12 bytes a node. Orders are never more than log₂(tips) + 1.
    #[must_use]
    pub fn of(skeleton: &Skeleton) -> Self {
        let orders = orders(skeleton);
        let highest = orders[0] as usize;
        let (mut counts, mut sums) = (vec![0_u32; highest], vec![0.0; highest]);
        for (node, &order) in orders.iter().enumerate() {
            let i = order as usize - 1;
            let below = skeleton.parent(node as u32).map(|parent| orders[parent as usize]);
            counts[i] += u32::from(below != Some(order));
            sums[i] += length_below(skeleton, node as u32);
        }
        let lengths = sums.iter().zip(&counts).map(|(sum, &n)| sum / f64::from(n)).collect();
        Self { orders, counts, lengths }
    }

    /// The order of every node, from 1 up: that of the segment below it.
    #[must_use]
    pub fn orders(&self) -> &[u32] {
        &self.orders
    }

    /// The order of the root, which no other exceeds.
    #[must_use]
    pub fn highest(&self) -> u32 {
        self.counts.len() as u32
    }

    /// How many branches there are of order 1, 2 and so on up to the highest, of which there is one.
    #[must_use]
    pub fn counts(&self) -> &[u32] {
        &self.counts
    }

    /// Mean length of the branches of order 1, 2 and so on, in metres. 0 for the highest where the root itself
    /// is the fork.
    #[must_use]
    pub fn mean_lengths(&self) -> &[f64] {
        &self.lengths
    }

    /// How many times more branches there are of an order than of the next higher one; `None` where all is of
    /// order 1. Trees have about 3 to 5 (Leopold 1971; Barker et al. 1973).
    #[must_use]
    pub fn bifurcation_ratio(&self) -> Option<f64> {
        let logarithm = |(i, &n): (usize, &u32)| (i as f64, libm::log(f64::from(n)));
        let slope = slope(self.counts.iter().enumerate().map(logarithm))?;
        Some(libm::exp(-slope))
    }

    /// How many times longer the branches of an order are than those of the next lower one; `None` where fewer
    /// than two orders have a length. Orders without length are left out.
    #[must_use]
    pub fn length_ratio(&self) -> Option<f64> {
        let long = self.lengths.iter().enumerate().filter(|(_, length)| **length > 0.0);
        let slope = slope(long.map(|(i, &length)| (i as f64, libm::log(length))))?;
        Some(libm::exp(slope))
    }
}

fn orders(skeleton: &Skeleton) -> Vec<u32> {
    let mut orders = vec![1_u32; skeleton.len()];
    // The highest order among the children, and whether two share it.
    let mut above = vec![(0_u32, false); skeleton.len()];
    for node in (0..skeleton.len()).rev() {
        let (highest, shared) = above[node];
        let order = (highest + u32::from(shared)).max(1);
        orders[node] = order;
        if let Some(parent) = skeleton.parent(node as u32) {
            let (highest, shared) = &mut above[parent as usize];
            *shared = order == *highest || (*shared && order < *highest);
            *highest = order.max(*highest);
        }
    }
    orders
}

/// The slope of the straight line through points, by least squares; `None` of fewer than two places.
fn slope(points: impl Iterator<Item = (f64, f64)> + Clone) -> Option<f64> {
    let n = points.clone().count() as f64;
    let (sum_x, sum_y) = points.clone().fold((0.0, 0.0), |(sx, sy), (x, y)| (sx + x, sy + y));
    let (mean_x, mean_y) = (sum_x / n, sum_y / n);
    let (mut spread, mut common) = (0.0, 0.0);
    for (x, y) in points {
        spread += (x - mean_x) * (x - mean_x);
        common += (x - mean_x) * (y - mean_y);
    }
    (spread > 0.0).then(|| common / spread)
}
