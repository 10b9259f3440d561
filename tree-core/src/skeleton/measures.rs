//! Lengths and counts along a skeleton, one pass each, no recursion.

use super::Skeleton;

impl Skeleton {
    /// Length of each segment in metres; 0 for the root.
    #[must_use]
    pub fn segment_lengths(&self) -> Vec<f32> {
        let mut lengths = vec![0.0; self.len()];
        for (parent, node) in self.segments() {
            lengths[node as usize] =
                self.positions[node as usize].distance(self.positions[parent as usize]);
        }
        lengths
    }

    /// Length of the path from the root to each node, in metres.
    ///
    /// # Complexity
    /// O(nodes), one pass forwards.
    #[must_use]
    pub fn distances_to_root(&self) -> Vec<f32> {
        let mut distances = self.segment_lengths();
        for node in 1..self.len() {
            distances[node] += distances[self.parents[node] as usize];
        }
        distances
    }

    /// Length of the longest path from each node up to a tip, in metres; 0 at tips.
    ///
    /// # Complexity
    /// O(nodes), one pass backwards.
    #[must_use]
    pub fn distances_to_tip(&self) -> Vec<f32> {
        let lengths = self.segment_lengths();
        let mut distances = vec![0.0_f32; self.len()];
        for node in (1..self.len()).rev() {
            let parent = self.parents[node] as usize;
            distances[parent] = distances[parent].max(distances[node] + lengths[node]);
        }
        distances
    }

    /// Number of nodes in the subtree of each node, itself included.
    ///
    /// # Complexity
    /// O(nodes), one pass backwards.
    #[must_use]
    pub fn subtree_sizes(&self) -> Vec<u32> {
        let mut sizes = vec![1_u32; self.len()];
        for node in (1..self.len()).rev() {
            sizes[self.parents[node] as usize] += sizes[node];
        }
        sizes
    }

    /// Number of tips in the subtree of each node; 1 for a tip.
    ///
    /// # Complexity
    /// O(nodes), one pass backwards.
    #[must_use]
    pub fn tip_counts(&self) -> Vec<u32> {
        let mut counts = vec![0_u32; self.len()];
        for node in (0..self.len()).rev() {
            counts[node] = counts[node].max(1);
            if node > 0 {
                counts[self.parents[node] as usize] += counts[node];
            }
        }
        counts
    }
}
