//! What became of a drawing.

use crate::border::Versioned;
use tree_model::sketch::session::SketchReport;

/// What became of a drawing on the way to a tree. Numbers of propagation count segments unless they say otherwise.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sketch_report {
    /// `sizeof(tree_sketch_report)`.
    pub struct_size: usize,
    /// Repairs of strokes.
    pub n_stroke_repairs: u64,
    /// Repairs of the crown; 0 where none is drawn.
    pub n_crown_repairs: u64,
    /// The posterior's logarithm.
    pub posterior: f64,
    /// New segments of propagation.
    pub grown_new: u64,
    /// Sketched ones so long that they got new laterals.
    pub grown_long: u64,
    /// New forks along those.
    pub grown_forks: u64,
    /// Open ends and forks of the sketch that lie outside the crown, where nothing grew.
    pub grown_ends_outside: u64,
    /// Those that end at the crown's surface.
    pub grown_touched: u64,
    /// Left out because the surface left too little of them.
    pub grown_outside: u64,
    /// Left out because they would have been too short.
    pub grown_too_short: u64,
    /// Turned aside from an obstacle or the ground.
    pub grown_turned_aside: u64,
    /// Shortened because of an obstacle or the ground.
    pub grown_shortened: u64,
    /// Left out because of an obstacle or the ground.
    pub grown_blocked: u64,
    /// Left out because there would have been too many.
    pub grown_over_cap: u64,
    /// Nodes of branches.
    pub finish_wood_nodes: u64,
    /// Nodes of twigs.
    pub finish_twig_nodes: u64,
    /// Nodes of twigs cut off because they left the crown or entered the ground.
    pub finish_twig_nodes_cut: u64,
    /// Blades that stayed: rows of the foliage.
    pub finish_leaves: u64,
    /// Blades left out because they left the crown or entered the ground.
    pub finish_leaves_outside: u64,
    /// How much larger leaves are than the species', because there would be too many; a factor.
    pub finish_leaves_larger: f32,
    /// How well the template suits the drawing, 0 for a perfect match, else below; 0 where it was taken by name or kept
    /// through an edit.
    pub score: f32,
    /// 1 where `score` counts.
    pub has_score: u32,
    /// 1 where a crown is drawn, and the fields of the crown count.
    pub has_crown: u32,
    /// Share of branch points outside the drawn crown, 0 to 1.
    pub crown_outside: f32,
    /// Segments that were drawn, from fork to fork.
    pub n_segments: u32,
    /// Crossings of branches in the drawing that could not be given room.
    pub n_interpenetrations: u32,
    /// The last generation of propagation in which any grew.
    pub grown_generations: u32,
    /// Replication blocks taken from the sketch.
    pub grown_blocks: u32,
    /// Replication blocks drawn from Ω because the sketch has few of their order.
    pub grown_blocks_from_omega: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_sketch_report {
    const NAME: &'static str = "tree_sketch_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&SketchReport::default())
    }
}

impl tree_sketch_report {
    pub(super) fn of(report: &SketchReport) -> Self {
        let (crown, grown, finish) = (report.crown.as_ref(), &report.propagate, &report.finish);
        Self {
            struct_size: size_of::<Self>(),
            n_stroke_repairs: report.clean.repairs.len() as u64,
            n_crown_repairs: crown.map_or(0, |crown| crown.repairs.len() as u64),
            posterior: report.posterior,
            grown_new: grown.n_new,
            grown_long: grown.n_long,
            grown_forks: grown.n_forks,
            grown_ends_outside: grown.n_ends_outside,
            grown_touched: grown.n_touched,
            grown_outside: grown.n_outside,
            grown_too_short: grown.n_too_short,
            grown_turned_aside: grown.n_turned_aside,
            grown_shortened: grown.n_shortened,
            grown_blocked: grown.n_blocked,
            grown_over_cap: grown.n_over_cap,
            finish_wood_nodes: finish.n_wood_nodes,
            finish_twig_nodes: finish.n_twig_nodes,
            finish_twig_nodes_cut: finish.n_twig_nodes_cut,
            finish_leaves: finish.n_leaves,
            finish_leaves_outside: finish.n_leaves_outside,
            finish_leaves_larger: finish.leaves_larger,
            score: report.score.unwrap_or(0.0),
            has_score: report.score.is_some().into(),
            has_crown: crown.is_some().into(),
            crown_outside: crown.map_or(0.0, |crown| crown.outside),
            n_segments: report.segments,
            n_interpenetrations: report.interpenetrations,
            grown_generations: grown.generations,
            grown_blocks: grown.n_blocks,
            grown_blocks_from_omega: grown.n_blocks_from_omega,
        }
    }
}
