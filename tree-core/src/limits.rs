//! Caps on what one operation may use: over the cap is an error before the memory is asked for.

/// What a limit counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Resource {
    /// Nodes of a skeleton.
    Nodes,
    /// Nodes of all search graphs of one model together.
    GraphNodes,
    /// Arcs of one search graph: two for each edge.
    GraphArcs,
    /// Leaves of one tree.
    Leaves,
    /// Cells of a three-dimensional grid.
    Voxels,
    /// Pixels of a picture, supersamples included.
    Pixels,
    /// Triangles of one mesh.
    Triangles,
    /// Bytes of an input file.
    InputBytes,
    /// Modules of a derived L-system word.
    Modules,
    /// Pairs of nodes kept while two trees are compared.
    Pairs,
}

impl Resource {
    /// The field of [`Limits`] that caps this resource.
    #[must_use]
    pub const fn field(self) -> &'static str {
        match self {
            Self::Nodes => "nodes",
            Self::GraphNodes => "graph_nodes",
            Self::GraphArcs => "graph_arcs",
            Self::Leaves => "leaves",
            Self::Voxels => "voxels",
            Self::Pixels => "pixels",
            Self::Triangles => "triangles",
            Self::InputBytes => "input_bytes",
            Self::Modules => "modules",
            Self::Pairs => "pairs",
        }
    }
}

/// More was asked for than the caller's [`Limits`] allow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0} would be {requested}, the limit `{0}` allows {cap}", resource.field())]
pub struct LimitError {
    /// What would be exceeded.
    pub resource: Resource,
    /// How much the request needs.
    pub requested: u64,
    /// How much is allowed.
    pub cap: u64,
}

/// Bytes of a skeleton's node while it is meshed: 16 for itself, the rest for axes, rings and orders.
const NODE_BYTES: u64 = 160;
/// Bytes of a node of a search graph at the peak of strewing, linking and searching (`evaluate -- path`).
const GRAPH_NODE_BYTES: u64 = 224;
/// Bytes of an arc while a graph is linked.
const ARC_BYTES: u64 = 16;
/// Bytes of a leaf while foliage grows: rows are gathered thread by thread and then joined.
const LEAF_BYTES: u64 = 96;
/// Bytes of a cell: a grid of f64 and a copy.
const VOXEL_BYTES: u64 = 16;
/// Bytes of a supersample, or of a texel of a shadow map, while a picture is drawn.
const PIXEL_BYTES: u64 = 4;
/// Bytes of a triangle with every column there is: two vertices (leaf cards) and three indices.
const TRIANGLE_BYTES: u64 = 160;
/// Memory that a byte of a file may come to when it is read.
const INPUT_BYTES: u64 = 16;
/// Bytes of a module with two parameters in the word before a step and in the one after it.
const MODULE_BYTES: u64 = 48;
/// Bytes of a pair of nodes: the distance of the trees and of the forests.
const PAIR_BYTES: u64 = 16;

/// Caps for one operation. The defaults fit a workstation: a few gigabytes at worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Limits {
    /// Nodes of a skeleton. Default 20 million (about 320 MB).
    pub nodes: u64,
    /// Nodes of all search graphs of one model together. Default 20 million.
    pub graph_nodes: u64,
    /// Arcs of one search graph. Default 300 million (about 4 GB while it is linked).
    pub graph_arcs: u64,
    /// Leaves of one tree. Default 20 million (about 760 MB).
    pub leaves: u64,
    /// Cells of a three-dimensional grid. Default 512³.
    pub voxels: u64,
    /// Pixels of a picture, supersamples included. Default 16,384².
    pub pixels: u64,
    /// Triangles of one mesh. Default 100 million.
    pub triangles: u64,
    /// Bytes of an input file. Default 1 GiB.
    pub input_bytes: u64,
    /// Modules of a derived L-system word. Default 100 million.
    pub modules: u64,
    /// Pairs of nodes kept while two trees are compared. Default 150 million (about 2.4 GB).
    pub pairs: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            nodes: 20_000_000,
            graph_nodes: 20_000_000,
            graph_arcs: 300_000_000,
            leaves: 20_000_000,
            voxels: 512 * 512 * 512,
            pixels: 16_384 * 16_384,
            triangles: 100_000_000,
            input_bytes: 1 << 30,
            modules: 100_000_000,
            pairs: 150_000_000,
        }
    }
}

impl Limits {
    /// Limits for work that may take about `bytes` of memory: each cap is what so many bytes hold of that
    /// resource at the peak of the work that makes it, and at most the default.
    #[must_use]
    pub fn for_memory(bytes: u64) -> Self {
        Self {
            nodes: bytes / NODE_BYTES,
            graph_nodes: bytes / GRAPH_NODE_BYTES,
            graph_arcs: bytes / ARC_BYTES,
            leaves: bytes / LEAF_BYTES,
            voxels: bytes / VOXEL_BYTES,
            pixels: bytes / PIXEL_BYTES,
            triangles: bytes / TRIANGLE_BYTES,
            input_bytes: bytes / INPUT_BYTES,
            modules: bytes / MODULE_BYTES,
            pairs: bytes / PAIR_BYTES,
        }
        .min(&Self::default())
    }

    /// The lower of both caps on each resource.
    #[must_use]
    pub fn min(&self, other: &Self) -> Self {
        Self {
            nodes: self.nodes.min(other.nodes),
            graph_nodes: self.graph_nodes.min(other.graph_nodes),
            graph_arcs: self.graph_arcs.min(other.graph_arcs),
            leaves: self.leaves.min(other.leaves),
            voxels: self.voxels.min(other.voxels),
            pixels: self.pixels.min(other.pixels),
            triangles: self.triangles.min(other.triangles),
            input_bytes: self.input_bytes.min(other.input_bytes),
            modules: self.modules.min(other.modules),
            pairs: self.pairs.min(other.pairs),
        }
    }

    /// The cap on `resource`.
    #[must_use]
    pub const fn cap(&self, resource: Resource) -> u64 {
        match resource {
            Resource::Nodes => self.nodes,
            Resource::GraphNodes => self.graph_nodes,
            Resource::GraphArcs => self.graph_arcs,
            Resource::Leaves => self.leaves,
            Resource::Voxels => self.voxels,
            Resource::Pixels => self.pixels,
            Resource::Triangles => self.triangles,
            Resource::InputBytes => self.input_bytes,
            Resource::Modules => self.modules,
            Resource::Pairs => self.pairs,
        }
    }

    /// Asks before the memory is taken.
    ///
    /// # Errors
    /// [`LimitError`] when `requested` is above the cap.
    pub const fn check(&self, resource: Resource, requested: u64) -> Result<(), LimitError> {
        let cap = self.cap(resource);
        if requested > cap { Err(LimitError { resource, requested, cap }) } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cap_itself_is_allowed_and_one_more_is_not() {
        let limits = Limits { nodes: 10, ..Default::default() };
        assert_eq!(limits.check(Resource::Nodes, 10), Ok(()));
        let error = limits.check(Resource::Nodes, 11).unwrap_err();
        assert_eq!(error.to_string(), "nodes would be 11, the limit `nodes` allows 10");
    }

    #[test]
    fn less_memory_lowers_every_cap_and_endless_memory_none() {
        assert_eq!(Limits::for_memory(u64::MAX), Limits::default());
        let small = Limits::for_memory(1 << 20);
        assert_eq!(small, small.min(&Limits::default()));
        assert!(small.nodes < 10_000 && small.triangles < 10_000 && small.pixels > 10_000);
    }
}
