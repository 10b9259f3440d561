//! What an interpretation met.

/// What the turtle did, and what it had to leave out.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct TurtleReport {
    /// Modules read.
    pub modules: usize,
    /// Most brackets open at a time.
    pub depth: usize,
    /// Gaps made by `f` before wood was drawn again. The skeleton runs on through them: a tree is connected.
    pub gaps: usize,
    /// `F` and `G` of no length, which make no node.
    pub merged: usize,
    /// Modules that a `%` cut off.
    pub cut: usize,
    /// Polygons with fewer than three corners, left out.
    pub thin_polygons: usize,
    /// Polygons that became leaves as well.
    pub polygon_leaves: usize,
    /// Symbols that say nothing to the turtle, and how often each was met, in the order of the symbols.
    pub skipped: Vec<(String, usize)>,
    /// Whether the word set any width.
    pub widths: bool,
    /// Metres a unit of length.
    pub scale: f64,
}

impl TurtleReport {
    /// All that may surprise, in sentences. Symbols without a meaning are no surprise in an L-system.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::new();
        let mut say = |n: usize, what: &str| {
            if n > 0 {
                warnings.push(format!("{n} {what}"));
            }
        };
        say(self.gaps, "gaps made by 'f' are bridged: wood must hang together");
        say(self.thin_polygons, "polygons have fewer than three corners and were left out");
        warnings
    }
}
