//! Which branches are bent and pruned one by one, and which follow them.

use tree_core::Skeleton;

/// The main branches of a tree, in the order of its nodes.
pub(super) struct Main {
    /// Tree node of each main node; parents first, the root at 0.
    pub nodes: Vec<u32>,
    /// Main node of each tree node: its own, or that of the main node its branchlet stands on.
    pub of: Vec<u32>,
    /// Whether each tree node is a main node.
    pub is_main: Vec<bool>,
}

impl Main {
    /// A node is main where it, or anything above it, is at least `share` of the root's radius thick. O(nodes).
    pub(super) fn new(skeleton: &Skeleton, share: f32) -> Self {
        let parents = skeleton.parents();
        let least = share * skeleton.radii()[0];
        let mut is_main: Vec<bool> =
            skeleton.radii().iter().map(|&radius| radius >= least).collect();
        is_main[0] = true;
        for node in (1..parents.len()).rev() {
            if is_main[node] {
                is_main[parents[node] as usize] = true;
            }
        }
        let mut nodes = Vec::new();
        let mut of = Vec::with_capacity(parents.len());
        for (node, &main) in is_main.iter().enumerate() {
            if main {
                of.push(nodes.len() as u32);
                nodes.push(node as u32);
            } else {
                of.push(of[parents[node] as usize]);
            }
        }
        Self { nodes, of, is_main }
    }
}
