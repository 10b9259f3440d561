//! A preset as a row of a table, and what most rows share.

/// One preset.
#[derive(Debug)]
pub(super) struct Row {
    pub(super) name: &'static str,
    pub(super) title: &'static str,
    /// Where it was published.
    pub(super) source: &'static str,
    pub(super) text: &'static str,
    /// Constants of the text that this row changes.
    pub(super) constants: &'static [(&'static str, f64)],
    pub(super) species: &'static str,
    pub(super) bark: &'static str,
    /// `None`: bare.
    pub(super) leaf_kind: Option<&'static str>,
    /// Metres; `None` where the text is in metres.
    pub(super) height: Option<f32>,
    pub(super) trunk_radius: f32,
    /// Of the pipe model, where the text sets no width.
    pub(super) exponent: f32,
    pub(super) tip_radius: f32,
}

pub(super) const ROW: Row = Row {
    name: "",
    title: "",
    source: "",
    text: "",
    constants: &[],
    species: "plant",
    bark: "smooth",
    leaf_kind: None,
    height: None,
    trunk_radius: 0.05,
    exponent: tree_core::allometry::PipeModel::MURRAY,
    tip_radius: 0.002,
};
