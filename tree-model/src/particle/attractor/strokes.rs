//! Strokes that a person drew become a graph that leads to the base (Neubert 2012, section 3.2.2: "the
//! user can provide the information as a manually sketched graph").
//!
//! 1. Points that are not finite or absurdly far away and repeated ones go; the rest is drawn anew with even spacing.
//! 2. The graph begins at the base. The stroke nearest to it joins next, until all have: with the end
//!    that is nearest, at the nearest point, and where the stroke's middle is much nearer than its ends (a limb,
//!    trunk and other limb drawn in one go) there, in two parts.
//!
//! So every stroke has one link and there are no cycles, in whatever order and direction they were drawn.
//! O(strokes² · points · nodes) at worst: a drawing has tens of strokes.

use super::AttractorGraph;
use super::builder::{Builder, Place};
use crate::error::{ModelError, Result, check};
use glam::Vec2;
use tree_core::{Control, NO_PARENT, Resource};

/// The middle of a stroke joins instead of an end where it is nearer than this share of the end's distance.
const MIDDLE: f32 = 0.25;

/// Points farther out than this many pixels are no points of a picture.
const LARGEST: f32 = 1e6;

/// How strokes are cleaned and joined.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct StrokeParams {
    /// Distance between nodes as a share of the drawing's size, 0.001 to 0.5. Default 0.02.
    pub spacing: f32,
    /// Gaps up to this share of the drawing's size are closed by moving the stroke's end, 0 to 1; wider
    /// ones are bridged by a straight line and reported. Default 0.03.
    pub snap: f32,
}

impl Default for StrokeParams {
    fn default() -> Self {
        Self { spacing: 0.02, snap: 0.03 }
    }
}

impl StrokeParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("strokes.spacing", self.spacing, 0.001_f32, 0.5_f32)?;
        check("strokes.snap", self.snap, 0.0_f32, 1.0_f32)
    }
}

/// What became of strokes.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct StrokeReport {
    /// Points left out because they were not finite, or more than a million pixels away.
    pub n_bad_points: u32,
    /// Strokes left out because they had no length.
    pub n_empty: u32,
    /// Strokes that were joined over a gap wider than the snapping distance.
    pub n_bridged: u32,
    /// Strokes joined by their middle, in two parts.
    pub n_split: u32,
    /// For each stroke the gap in pixels that was closed; `None` where it was left out.
    pub gaps: Vec<Option<f32>>,
}

/// Makes a graph of `strokes` whose root is at `base`, all in pixels.
///
/// # Errors
/// [`ModelError::Parameter`] for parameters out of range; [`ModelError::NotFinite`] for the base;
/// [`ModelError::Limit`] for more points than [`Resource::Nodes`] allows; [`ModelError::Cancelled`].
///
/// # Complexity
/// See the module.
pub fn from_strokes(
    strokes: &[Vec<Vec2>],
    base: Vec2,
    params: &StrokeParams,
    control: &Control,
) -> Result<(AttractorGraph, StrokeReport)> {
    if !base.is_finite() {
        return Err(ModelError::NotFinite { field: "base".into() });
    }
    let builder = Builder { nodes: vec![base], parents: vec![NO_PARENT] };
    join(builder, strokes, params, control)
}

impl AttractorGraph {
    /// This graph with one more stroke, joined where it is nearest. On an empty graph the stroke's
    /// lowest point becomes the root.
    ///
    /// # Errors
    /// As [`from_strokes`].
    pub fn add_stroke(
        &self,
        stroke: &[Vec2],
        params: &StrokeParams,
        control: &Control,
    ) -> Result<(Self, StrokeReport)> {
        let mut builder = Builder::from_graph(self);
        if builder.nodes.is_empty() {
            let points = stroke.iter().copied().filter(is_good);
            if let Some(lowest) = points.max_by(|a, b| a.y.total_cmp(&b.y)) {
                builder.push(lowest, NO_PARENT);
            }
        }
        join(builder, std::slice::from_ref(&stroke.to_vec()), params, control)
    }
}

/// Joins strokes to what there is.
fn join(
    mut builder: Builder,
    strokes: &[Vec<Vec2>],
    params: &StrokeParams,
    control: &Control,
) -> Result<(AttractorGraph, StrokeReport)> {
    params.validate()?;
    let n_points: u64 = strokes.iter().map(|stroke| stroke.len() as u64).sum();
    control.limits.check(Resource::Nodes, n_points)?;
    let mut report = StrokeReport { gaps: vec![None; strokes.len()], ..StrokeReport::default() };
    let size = extent(&builder, strokes);
    let mut waiting = Vec::new();
    for (row, stroke) in strokes.iter().enumerate() {
        let good: Vec<Vec2> = stroke.iter().copied().filter(is_good).collect();
        report.n_bad_points += (stroke.len() - good.len()) as u32;
        match resample(&good, params.spacing * size) {
            Some(points) => waiting.push((row, points)),
            None => report.n_empty += 1,
        }
    }
    while !waiting.is_empty() && !builder.nodes.is_empty() {
        control.check()?;
        let Some((next, at, place)) = nearest_stroke(&builder, &waiting) else { break };
        let (row, points) = waiting.remove(next);
        report.gaps[row] = Some(place.distance);
        report.n_bridged += u32::from(place.distance > params.snap * size);
        report.n_split += u32::from(at > 0 && at + 1 < points.len());
        attach(&mut builder, &points, at, place, params.snap * size);
    }
    Ok((builder.finish()?, report))
}

/// Whether a point can be one of a drawing.
fn is_good(point: &Vec2) -> bool {
    // A NaN is in no range.
    point.x.abs() <= LARGEST && point.y.abs() <= LARGEST
}

/// The larger side of the box around everything, at least one pixel.
fn extent(builder: &Builder, strokes: &[Vec<Vec2>]) -> f32 {
    let all = builder.nodes.iter().chain(strokes.iter().flatten()).filter(|p| is_good(p));
    let (mut low, mut high) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
    for &point in all {
        (low, high) = (low.min(point), high.max(point));
    }
    let size = (high - low).max_element();
    if size.is_finite() { size.max(1.0) } else { 1.0 }
}

/// Points at even distances of about `spacing` along a polyline, its ends kept; `None` without length.
fn resample(points: &[Vec2], spacing: f32) -> Option<Vec<Vec2>> {
    let length: f32 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
    let (&first, &last) = (points.first()?, points.last()?);
    if !(length > 0.0 && length.is_finite()) {
        return None;
    }
    // A scribble within a small box may be long: its length bounds the number of points.
    let n = (length / spacing).round().clamp(1.0, 100_000.0) as usize;
    let step = length / n as f32;
    let mut out = vec![first];
    let mut walked = 0.0;
    for pair in points.windows(2) {
        let along = pair[0].distance(pair[1]);
        while out.len() < n && walked + along >= step * out.len() as f32 && along > 0.0 {
            let share = (step * out.len() as f32 - walked) / along;
            out.push(pair[0].lerp(pair[1], share.clamp(0.0, 1.0)));
        }
        walked += along;
    }
    out.push(last);
    Some(out)
}

/// Which stroke comes next, the point by which it joins, and where.
fn nearest_stroke(
    builder: &Builder,
    waiting: &[(usize, Vec<Vec2>)],
) -> Option<(usize, usize, Place)> {
    let mut best: Option<(usize, usize, Place)> = None;
    for (i, (_, points)) in waiting.iter().enumerate() {
        let place = |at: usize| Some((at, builder.nearest(points[at], |_| true)?));
        let nearer = |a: (usize, Place), b: (usize, Place)| {
            if b.1.distance < a.1.distance { b } else { a }
        };
        let end = nearer(place(0)?, place(points.len() - 1)?);
        let middle = (1..points.len() - 1).filter_map(place).reduce(nearer);
        let (at, found) = match middle {
            Some(middle) if middle.1.distance < MIDDLE * end.1.distance => middle,
            _ => end,
        };
        if best.is_none_or(|best| found.distance < best.2.distance) {
            best = Some((i, at, found));
        }
    }
    best
}

/// Adds a stroke that joins by its point `at`. Within `snap` that point gives way to the place.
fn attach(builder: &mut Builder, points: &[Vec2], at: usize, place: Place, snap: f32) {
    let mut link = builder.split(place);
    if place.distance > snap {
        link = builder.push(points[at], link);
    }
    let mut below = link;
    for &point in &points[at + 1..] {
        below = builder.push(point, below);
    }
    below = link;
    for &point in points[..at].iter().rev() {
        below = builder.push(point, below);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const BASE: Vec2 = Vec2::new(50.0, 100.0);

    fn points(list: &[(f32, f32)]) -> Vec<Vec2> {
        list.iter().map(|&(x, y)| Vec2::new(x, y)).collect()
    }

    fn make(strokes: &[Vec<Vec2>]) -> (AttractorGraph, StrokeReport) {
        from_strokes(strokes, BASE, &StrokeParams::default(), &Control::default()).unwrap()
    }

    #[test]
    fn a_side_branch_joins_the_trunk_whatever_the_order_and_direction() {
        let trunk = points(&[(50.0, 98.0), (50.0, 10.0)]);
        let branch = points(&[(52.0, 50.0), (90.0, 20.0)]);
        let reversed = |stroke: &[Vec2]| stroke.iter().rev().copied().collect::<Vec<_>>();
        for strokes in [
            [trunk.clone(), branch.clone()],
            [branch.clone(), trunk.clone()],
            [reversed(&branch), reversed(&trunk)],
        ] {
            let (graph, report) = make(&strokes);
            assert_eq!(graph.nodes()[0], BASE);
            assert_eq!(graph.tips().count(), 2);
            assert_eq!(report.n_bridged, 0);
            assert_eq!(graph.nearest(Vec2::new(90.0, 20.0)).unwrap().distance, 0.0);
            let gaps = report.gaps.iter().flatten().fold(0.0_f32, |a, &b| a.max(b));
            assert!((gaps - 2.0).abs() < 1e-4, "{:?}", report.gaps);
        }
    }

    #[test]
    fn a_stroke_through_the_base_is_split_there() {
        let (graph, report) = make(&[points(&[(10.0, 20.0), (50.0, 100.0), (90.0, 20.0)])]);
        assert_eq!(report.n_split, 1);
        assert_eq!(graph.tips().count(), 2);
    }

    #[test]
    fn wide_gaps_are_bridged_and_reported() {
        let (graph, report) = make(&[points(&[(50.0, 60.0), (50.0, 10.0)])]);
        assert_eq!((report.n_bridged, report.gaps[0]), (1, Some(40.0)));
        assert!((graph.length() - 90.0).abs() < 1e-3);
    }

    #[test]
    fn what_is_no_stroke_is_left_out() {
        let nan = vec![Vec2::NAN, Vec2::new(1.0, 1.0), Vec2::new(1.0, 1.0)];
        let (graph, report) = make(&[vec![], nan]);
        assert!(graph.is_empty());
        assert_eq!((report.n_empty, report.n_bad_points), (2, 1));
        assert!(report.gaps.iter().all(Option::is_none));
    }

    #[test]
    fn a_stroke_can_be_added_to_a_graph_and_to_nothing() {
        let (params, control) = (StrokeParams::default(), Control::default());
        let stroke = points(&[(20.0, 30.0), (50.0, 98.0)]);
        let (graph, _) = AttractorGraph::default().add_stroke(&stroke, &params, &control).unwrap();
        assert_eq!(graph.nodes()[0], Vec2::new(50.0, 98.0));
        let more = points(&[(35.0, 60.0), (80.0, 30.0)]);
        let (more, report) = graph.add_stroke(&more, &params, &control).unwrap();
        assert_eq!((more.tips().count(), report.n_bridged), (2, 0));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(60))]

        #[test]
        fn any_strokes_make_one_tree_that_leads_to_the_base(
            strokes in prop::collection::vec(
                prop::collection::vec((-50.0_f32..150.0, -50.0_f32..150.0), 0..8), 0..8),
        ) {
            let strokes: Vec<Vec<Vec2>> = strokes.iter().map(|stroke| points(stroke)).collect();
            let (graph, _) = make(&strokes);
            let roots = graph.parents().iter().filter(|&&parent| parent == NO_PARENT).count();
            prop_assert_eq!(roots, 1);
            prop_assert_eq!(graph.nodes()[0], BASE);
        }
    }
}
