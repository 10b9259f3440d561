//! What was done to a drawn stroke to make it an outline.

use std::fmt;

/// One thing that was repaired or noticed. As text, a sentence without the stroke's name.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum OutlineRepair {
    /// Points that were not finite or absurdly far away were left out.
    PointsDropped {
        /// How many.
        count: usize,
    },
    /// Points repeated at once were left out.
    DuplicatesDropped {
        /// How many.
        count: usize,
    },
    /// There were very many points: those that change the shape least were left out.
    Thinned {
        /// How many points.
        before: usize,
        /// How many are left.
        after: usize,
    },
    /// It was open, with close ends, and was closed by a straight line.
    Closed {
        /// Distance of the ends in metres.
        gap: f32,
    },
    /// It was open, with ends far apart, and was closed by a straight line.
    WideGapClosed {
        /// Distance of the ends in metres.
        gap: f32,
        /// The same as a share of the stroke's length, 0 to 1.
        share: f32,
    },
    /// It ran out and straight back at some corners, without enclosing anything; they were left out.
    SpikesDropped {
        /// How many corners.
        count: usize,
    },
    /// It crossed or touched itself; what it winds round was kept.
    CrossingUndone,
    /// Of what it winds round only the largest part was kept.
    PartsDropped {
        /// How many parts were left out.
        count: usize,
        /// Their share of the area, 0 to 1.
        share: f32,
    },
    /// It ran with the clock and was turned.
    Turned,
}

impl fmt::Display for OutlineRepair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::PointsDropped { count } => {
                write!(f, "{count} points were not finite or too far away and were left out")
            }
            Self::DuplicatesDropped { count } => {
                write!(f, "{count} repeated points were left out")
            }
            Self::Thinned { before, after } => {
                write!(f, "of {before} points {after} were kept")
            }
            Self::Closed { gap } => {
                write!(f, "it was open and was closed over a gap of {gap:.3} m")
            }
            Self::WideGapClosed { gap, share } => {
                let percent = 100.0 * share;
                write!(
                    f,
                    "it was wide open, by {gap:.3} m, {percent:.0} % of its length, and was closed straight"
                )
            }
            Self::SpikesDropped { count } => {
                write!(f, "it ran out and straight back at {count} corners, which were left out")
            }
            Self::CrossingUndone => f.write_str("it crossed itself; what it winds round was kept"),
            Self::PartsDropped { count, share } => {
                let percent = 100.0 * share;
                write!(
                    f,
                    "{count} parts beside the largest, {percent:.0} % of the area, were left out"
                )
            }
            Self::Turned => f.write_str("it ran with the clock and was turned"),
        }
    }
}
