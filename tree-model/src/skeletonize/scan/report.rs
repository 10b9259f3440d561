//! What became of a cloud.

/// A gap that was bridged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bridge {
    /// Its length in metres.
    pub length: f32,
    /// Points of the smaller one of the two pieces it joins.
    pub n_points: usize,
}

/// What was found in a cloud, and what was left out.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ScanReport {
    /// Points that came in.
    pub n_points: usize,
    /// Points that were no numbers.
    pub n_not_finite: usize,
    /// Second points at one place.
    pub n_doubles: usize,
    /// Points that became one with others in their voxel.
    pub n_thinned: usize,
    /// Points of the ground.
    pub n_ground: usize,
    /// Points of pieces that no bridge reached.
    pub n_left_out: usize,
    /// Median distance to the fourth neighbour in metres.
    pub spacing: f32,
    /// Gaps bridged, so that all is one piece; the ways to the base may take others near them.
    pub bridges: Vec<Bridge>,
    /// Places where a tree may stand.
    pub n_bases: usize,
    /// Clusters of points that the levels fell into.
    pub n_clusters: usize,
    /// Side shoots too short for an axis.
    pub n_short: usize,
    /// Nodes.
    pub n_nodes: usize,
    /// Nodes whose radius and centre come from a circle fitted to the points; the radii of all others
    /// are guessed from the wood beyond.
    pub n_fitted: usize,
    /// Nodes in foliage, kept or not.
    pub n_in_foliage: usize,
}
