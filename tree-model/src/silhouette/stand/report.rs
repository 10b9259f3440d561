//! What was noticed about a stand.

use std::fmt;

/// One thing that was noticed. As text, a sentence.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum StandNote {
    /// A tree could not be used.
    LeftOut {
        /// Its name.
        tree: String,
        /// Why.
        why: String,
    },
    /// Ground points lie at different heights, but sizes do not tell where the horizon is.
    HorizonAssumed {
        /// Where it was assumed, in units of the drawing.
        y: f32,
    },
    /// A tree stands so near the horizon, or above, that it would be endlessly far away.
    BroughtNearer {
        /// Its name.
        tree: String,
    },
    /// A chosen lender has nothing that the tree lacks.
    NothingToLend {
        /// Name of the tree that was to borrow.
        tree: String,
        /// Name of the tree chosen.
        from: String,
    },
}

impl fmt::Display for StandNote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::LeftOut { tree, why } => write!(f, "{tree} was left out: {why}"),
            Self::HorizonAssumed { y } => write!(
                f,
                "the sizes of the trees do not tell where the horizon is; it was assumed at y = {y:.0}"
            ),
            Self::BroughtNearer { tree } => {
                write!(f, "{tree} stands at the horizon or above it and was brought nearer")
            }
            Self::NothingToLend { tree, from } => {
                write!(f, "{from} has no details that {tree} lacks, so nothing was borrowed")
            }
        }
    }
}
