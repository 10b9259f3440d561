//! Branch segments in space, from fork to fork (Neubert 2012, section 4.5).

use crate::error::{ModelError, Result};
use glam::Vec3;
use tree_core::NO_PARENT;

/// Which part a segment plays where its parent ends (section 4.5, l).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Label {
    /// It continues its parent's axis.
    Apical,
    /// It is the lateral of this number, from 0.
    Lateral(u16),
}

/// Segments in columns, parents first. Segment 0 has no parent and every other one begins where its parent ends; those
/// that propagation adds may begin on the way there.
#[derive(Clone, Debug, PartialEq)]
pub struct Branches {
    pub(super) parents: Vec<u32>,
    pub(super) labels: Vec<Label>,
    /// Where each segment's points begin in `points`; one more than there are segments.
    pub(super) starts: Vec<u32>,
    pub(super) points: Vec<Vec3>,
    /// Whether segment 0 is not drawn: it stands below a base from which several stems rise.
    pub(super) imagined_root: bool,
    /// A name for each segment, or none.
    pub(super) names: Vec<u64>,
}

impl Branches {
    /// Checks and keeps columns: `starts` has where each segment's points begin in `points`, and at last where they all
    /// end; every segment's first point is its parent's last.
    ///
    /// # Errors
    /// [`ModelError::Sketch`] where columns do not fit each other, points are not finite, a segment has less than two,
    /// does not begin where its parent ends, or comes before its parent.
    pub fn from_columns(
        parents: Vec<u32>,
        labels: Vec<Label>,
        starts: Vec<u32>,
        points: Vec<Vec3>,
        imagined_root: bool,
    ) -> Result<Self> {
        let fail = |problem: String| Err(ModelError::Sketch { problem });
        let n = parents.len();
        let fits = n > 0 && labels.len() == n && starts.len() == n + 1;
        let ends = starts.first().zip(starts.last());
        if !fits || ends.is_none_or(|(&from, &to)| from != 0 || to as usize != points.len()) {
            let (l, s, p) = (labels.len(), starts.len(), points.len());
            return fail(format!(
                "{n} parents, {l} labels, {s} starts and {p} points: there must be a label for each of at least one \
                 parent, one start more, the first 0 and the last the number of points"
            ));
        }
        if let Some(point) = points.iter().position(|point| !point.is_finite()) {
            return fail(format!("points[{point}] is not finite"));
        }
        let names = Vec::new();
        let branches = Self { parents, labels, starts, points, imagined_root, names };
        for (segment, &parent) in branches.parents.iter().enumerate() {
            let own = branches.points(segment);
            if own.len() < 2 {
                return fail(format!(
                    "segment {segment} has {} points: give at least 2",
                    own.len()
                ));
            }
            let sound = if segment == 0 {
                parent == NO_PARENT
            } else {
                (parent as usize) < segment && own[0] == branches.end(parent as usize)
            };
            if !sound {
                return fail(format!(
                    "parents[{segment}] is {parent}: parents come first and end where the segment begins, segment 0 \
                     has none"
                ));
            }
        }
        Ok(branches)
    }

    /// Number of segments, at least 1.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "the root segment is always there")]
    pub fn len(&self) -> usize {
        self.parents.len()
    }

    /// Parent of each segment; [`NO_PARENT`](tree_core::NO_PARENT) for segment 0.
    #[must_use]
    pub fn parents(&self) -> &[u32] {
        &self.parents
    }

    /// Label of each segment; the root is [`Label::Apical`].
    #[must_use]
    pub fn labels(&self) -> &[Label] {
        &self.labels
    }

    /// A name for each segment that stays when other branches are drawn or erased: streams of randomness go by it. Empty where
    /// segments have none.
    #[must_use]
    pub fn names(&self) -> &[u64] {
        &self.names
    }

    /// Whether segment 0 is not part of the tree: it stands below a base from which several stems rise, and only says
    /// that they rise.
    #[must_use]
    pub fn has_imagined_root(&self) -> bool {
        self.imagined_root
    }

    /// The points of a segment in metres, from its parent's end to its own, at least two; none where there is no such
    /// segment.
    #[must_use]
    pub fn points(&self, segment: usize) -> &[Vec3] {
        let ends = self.starts.get(segment).zip(self.starts.get(segment + 1));
        ends.and_then(|(&from, &to)| self.points.get(from as usize..to as usize)).unwrap_or(&[])
    }

    /// Where a segment begins; the origin where there is no such segment.
    #[must_use]
    pub fn start(&self, segment: usize) -> Vec3 {
        self.points(segment).first().copied().unwrap_or_default()
    }

    /// Where a segment ends; the origin where there is no such segment.
    #[must_use]
    pub fn end(&self, segment: usize) -> Vec3 {
        self.points(segment).last().copied().unwrap_or_default()
    }

    /// vᵢ: from a segment's beginning to its end.
    #[must_use]
    pub fn vector(&self, segment: usize) -> Vec3 {
        self.end(segment) - self.start(segment)
    }

    /// Gravelius order of each segment's axis: one more than its parent's for a lateral; 0 for all stems.
    #[must_use]
    pub fn orders(&self) -> Vec<u32> {
        let mut orders = vec![0_u32; self.len()];
        for segment in 1..self.len() {
            let parent = self.parents[segment] as usize;
            let stem = self.imagined_root && parent == 0;
            orders[segment] =
                orders[parent] + u32::from(!stem && self.labels[segment] != Label::Apical);
        }
        orders
    }
}
