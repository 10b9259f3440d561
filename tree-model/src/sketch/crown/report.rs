//! What was done to a drawn crown.

use std::fmt;

/// One thing that was repaired or noticed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CrownRepair {
    /// Points that were not finite or absurdly far away were left out.
    PointsDropped {
        /// Index of the crown stroke.
        stroke: usize,
        /// How many.
        count: usize,
    },
    /// A stroke without length was left out.
    StrokeDropped {
        /// Index of the crown stroke.
        stroke: usize,
    },
    /// An open stroke inside a closed one was left out: it is a detail.
    DetailDropped {
        /// Index of the crown stroke; of strokes joined to one, the first.
        stroke: usize,
    },
    /// A stroke, or several joined ones, with close ends was closed by a straight line.
    Closed {
        /// Index of the crown stroke; of strokes joined to one, the first.
        stroke: usize,
        /// Length of the gap in metres.
        gap: f32,
    },
    /// Strokes were joined where their ends were close.
    Joined {
        /// How many joints.
        count: usize,
    },
    /// A wide gap between stroke ends was closed.
    GapClosed {
        /// Distance of the ends in metres.
        gap: f32,
        /// Whether branches in the gap were gone round.
        round_branches: bool,
    },
    /// A loop crossed itself; what it winds round was kept.
    CrossingUndone {
        /// Index of the loop, in the order they were closed.
        part: usize,
    },
    /// Loops that overlap were united.
    United {
        /// How many loops.
        before: usize,
        /// How many polygons are left of them.
        after: usize,
    },
    /// Loops inside others were left out: they are details.
    NestedDropped {
        /// How many.
        count: usize,
    },
    /// Tiny parts, left by crossings or drawn, were left out.
    CrumbsDropped {
        /// How many.
        count: usize,
    },
    /// Some branches stick out of the crown.
    BranchesOutside {
        /// Share of branch points outside, 0 to 1.
        share: f32,
    },
    /// No branch touches the crown.
    NoBranchInside,
}

impl fmt::Display for CrownRepair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::PointsDropped { stroke, count } => {
                write!(
                    f,
                    "crown stroke {stroke}: {count} points were not finite or too far away and were left out"
                )
            }
            Self::StrokeDropped { stroke } => {
                write!(f, "crown stroke {stroke} has no length and was left out")
            }
            Self::DetailDropped { stroke } => {
                write!(f, "crown stroke {stroke} lies inside the crown and was left out")
            }
            Self::Closed { stroke, gap } => {
                write!(f, "crown stroke {stroke} was closed over a gap of {gap:.2} m")
            }
            Self::Joined { count } => write!(f, "crown strokes were joined at {count} ends"),
            Self::GapClosed { gap, round_branches } => {
                let how = if *round_branches { "round the branches there" } else { "straight" };
                write!(f, "a gap of {gap:.2} m in the crown was closed {how}")
            }
            Self::CrossingUndone { part } => {
                write!(f, "part {part} of the crown crossed itself; what it winds round was kept")
            }
            Self::United { before, after } => {
                write!(f, "{before} parts of the crown overlap and became {after}")
            }
            Self::NestedDropped { count } => {
                write!(f, "{count} parts of the crown lie inside others and were left out")
            }
            Self::CrumbsDropped { count } => {
                write!(f, "{count} tiny parts of the crown were left out")
            }
            Self::BranchesOutside { share } => {
                write!(f, "{:.0} % of the branches stick out of the crown", 100.0 * share)
            }
            Self::NoBranchInside => {
                write!(
                    f,
                    "no branch touches the crown: it will hold nothing unless it is drawn round the branches"
                )
            }
        }
    }
}

/// What became of a drawn crown.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CrownReport {
    /// Everything repaired or noticed, in the order of work.
    pub repairs: Vec<CrownRepair>,
    /// Share of branch points outside the crown, 0 to 1.
    pub outside: f32,
}

impl fmt::Display for CrownReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines: Vec<String> = self.repairs.iter().map(ToString::to_string).collect();
        f.write_str(&lines.join("\n"))
    }
}
