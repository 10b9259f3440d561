//! What growing leaves and twigs did.

use crate::border::Versioned;
use tree_model::foliage::{LeafReport, TwigReport};

/// What growing leaves did.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_leaf_report {
    /// `sizeof(tree_leaf_report)`.
    pub struct_size: usize,
    /// Leaf-bearing nodes of the shoots (a whorl is one, a tip's leaf too).
    pub n_bearing: u64,
    /// Leaves; a compound leaf and a fascicle is one.
    pub n_leaves: u64,
    /// Blades: rows of the foliage.
    pub n_blades: u64,
    /// Bearing nodes that the density left out.
    pub n_thinned: u64,
    /// Bearing nodes where the density was negative or not a number, and counted as 0.
    pub n_bad_density: u64,
    /// Axes without a leaf.
    pub n_barren: u64,
    /// Nodes added for petioles and rachises.
    pub n_stalk_nodes: u64,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_leaf_report {
    const NAME: &'static str = "tree_leaf_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&LeafReport::default())
    }
}

impl tree_leaf_report {
    pub(super) fn of(report: &LeafReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_bearing: report.n_bearing,
            n_leaves: report.n_leaves,
            n_blades: report.n_blades,
            n_thinned: report.n_thinned,
            n_bad_density: report.n_bad_density,
            n_barren: report.n_barren,
            n_stalk_nodes: report.n_stalk_nodes,
        }
    }
}

/// What growing twigs did.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_twig_report {
    /// `sizeof(tree_twig_report)`.
    pub struct_size: usize,
    /// Twigs that old nodes bear.
    pub n_twigs: u64,
    /// Twigs that twigs bear.
    pub n_laterals: u64,
    /// Nodes added.
    pub n_nodes: u64,
    /// Axes of the old skeleton without a place for a twig: too short, beyond the bearing zone, or left
    /// out by the density.
    pub n_barren: u64,
    /// Places that the density left out.
    pub n_thinned: u64,
    /// Places where the density was negative or not a number, and counted as 0.
    pub n_bad_density: u64,
    /// Twigs and laterals left out, shorter than half an internode.
    pub n_too_short: u64,
    /// Twigs left out because their node bears `crowd` already. Many mean that the skeleton has too few
    /// nodes; see `tree_skeleton_refine`.
    pub n_crowded: u64,
    /// Largest distance in metres from a twig's place on the shoot to the node that bears it.
    pub moved: f64,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_twig_report {
    const NAME: &'static str = "tree_twig_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&TwigReport::default())
    }
}

impl tree_twig_report {
    pub(super) fn of(report: &TwigReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_twigs: report.n_twigs,
            n_laterals: report.n_laterals,
            n_nodes: report.n_nodes,
            n_barren: report.n_barren,
            n_thinned: report.n_thinned,
            n_bad_density: report.n_bad_density,
            n_too_short: report.n_too_short,
            n_crowded: report.n_crowded,
            moved: report.moved.into(),
        }
    }
}
