//! What clean-up did to a drawing, in words that a person understands.

use crate::sketch::Role;
use std::fmt;

/// What was done to the strokes of a drawing, step by step.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CleanReport {
    /// The repairs, in the order they were made.
    pub repairs: Vec<Repair>,
}

/// One thing that was done to one stroke. Its `Display` is a sentence.
#[derive(Clone, Debug, PartialEq)]
pub struct Repair {
    /// Index of the stroke in the drawing.
    pub stroke: u32,
    /// What messages call it.
    pub name: String,
    /// What was done.
    pub kind: RepairKind,
}

/// What can be done to a stroke. Shares are of the drawing's height.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum RepairKind {
    /// Points that are not finite, or absurdly far away, were left out.
    BadPoints(u32),
    /// It has no length worth speaking of, and was left out.
    Empty,
    /// It was taken for the ground, and left out.
    Ground,
    /// It was taken for a mark on the trunk's bark, and left out.
    BarkMark,
    /// It is a small mark that touches nothing, and was left out.
    Speck,
    /// It shows roots below the ground: what is below was left out.
    BelowGround,
    /// It runs along the crown's outline, this stroke: that part is its ink, and was left out.
    CrownInk(u32),
    /// It was not marked, and was taken to show this.
    TakenAs(Role),
    /// It shows the trunk and the crown in one go, and was cut at the corner between them.
    CutAtCorner,
    /// It is one side of the trunk and this stroke the other: the line between them was taken.
    MiddleOfSides(u32),
    /// It is an outline: its middle line was taken.
    MiddleOfOutline,
    /// All of it runs along this stroke, and was merged into it.
    Merged(u32),
    /// A part of it runs along this stroke, and was merged into it.
    MergedPartly(u32),
    /// It was drawn towards the base, and was turned round.
    TurnedRound,
    /// It passes through where it joins, and was split there in two.
    Split,
    /// It crosses this stroke a little: the end beyond it, this share long, was cut off.
    Trimmed(u32, f32),
    /// Its end was joined over a small gap of this share.
    Snapped(f32),
    /// It was joined by a straight line over a gap of this share.
    Bridged(f32),
    /// It begins on the ground beside the base, this share away, and was joined to the base.
    SecondRoot(f32),
    /// It is this share away from the rest, and was left out.
    Isolated(f32),
    /// There are no branches: a straight trunk was imagined below this crown.
    ImaginedTrunk,
    /// It shows the flare of a root at the trunk's foot, which was left out.
    RootFlare,
    /// No branch reaches into the crown, this stroke: it was drawn on.
    DrawnOn(u32),
}

impl CleanReport {
    pub(super) fn add(&mut self, stroke: u32, kind: RepairKind) {
        self.repairs.push(Repair { stroke, name: String::new(), kind });
    }
}

impl fmt::Display for Repair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use RepairKind as K;
        let percent = |share: f32| f64::from(100.0 * share);
        write!(f, "{} ", self.name)?;
        match self.kind {
            K::BadPoints(1) => write!(f, "had a bad point, which was left out"),
            K::BadPoints(n) => write!(f, "had {n} bad points, which were left out"),
            K::Empty => write!(f, "has no length and was left out"),
            K::Ground => write!(f, "was taken for the ground and left out"),
            K::BarkMark => write!(f, "was taken for a mark on the bark and left out"),
            K::Speck => write!(f, "is a small mark that touches nothing and was left out"),
            K::BelowGround => write!(f, "goes below the ground: what is there was left out"),
            K::CrownInk(crown) => {
                write!(f, "runs along the crown's outline strokes[{crown}] and was left out there")
            }
            K::TakenAs(Role::Trunk) => write!(f, "was taken for the trunk"),
            K::TakenAs(Role::Branch) => write!(f, "was taken for a branch"),
            K::TakenAs(Role::Crown) => write!(f, "was taken for the crown's outline"),
            K::CutAtCorner => write!(f, "shows trunk and crown in one go and was cut between them"),
            K::MiddleOfSides(other) => {
                write!(
                    f,
                    "is one side of the trunk: the middle between it and strokes[{other}] was taken"
                )
            }
            K::MiddleOfOutline => write!(f, "is an outline: its middle line was taken"),
            K::Merged(into) => write!(f, "runs along strokes[{into}] and was merged into it"),
            K::MergedPartly(into) => {
                write!(f, "runs along strokes[{into}] in part, and that part was merged into it")
            }
            K::TurnedRound => write!(f, "was drawn towards the base and was turned round"),
            K::Split => write!(f, "passes through where it joins and was split there in two"),
            K::Trimmed(host, share) => write!(
                f,
                "crosses strokes[{host}] and was cut there: the end, {:.1} % of the height long, is gone",
                percent(share)
            ),
            K::Snapped(share) => {
                write!(f, "was joined over a small gap of {:.1} % of the height", percent(share))
            }
            K::Bridged(share) => {
                write!(f, "was joined over a gap of {:.1} % of the height", percent(share))
            }
            K::SecondRoot(share) => write!(
                f,
                "begins on the ground {:.1} % of the height beside the base and was joined to the base",
                percent(share)
            ),
            K::Isolated(share) => write!(
                f,
                "is {:.1} % of the height away from the rest and was left out",
                percent(share)
            ),
            K::RootFlare => {
                write!(f, "shows flares of roots at the trunk's foot: they were left out")
            }
            K::DrawnOn(crown) => {
                write!(f, "hardly reaches into the crown strokes[{crown}] and was drawn on")
            }
            K::ImaginedTrunk => write!(f, "has no trunk below it: a straight one was imagined"),
        }
    }
}
