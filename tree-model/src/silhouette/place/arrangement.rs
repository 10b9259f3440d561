//! Arrangements of branches round their parent: phyllotaxis (section 5.5).
//!
//! A pattern is two numbers: how many organs a node bears, n, and the turn from a node to the next, φ. The organs of
//! a node stand γ = 2π/n apart. The paper's printed angles for "decussate" are damaged; these are the standard
//! definitions (Barthélémy & Caraglio 2007).

use crate::error::{ModelError, Result, check};
use std::f32::consts::{FRAC_PI_2, PI, TAU};
use std::fmt;
use std::str::FromStr;

/// Most organs a node may bear.
const MOST_PER_NODE: u32 = 64;

/// Turns are at most this many radians, either way.
const MOST_TURN: f32 = TAU;

/// The divergence of the paper's spiral, 2/5 of a turn: 144°.
const SPIRAL: f32 = 0.4 * TAU;

/// The golden angle, 137.5°.
const GOLDEN: f32 = 137.507_77 / 360.0 * TAU;

/// How branches are arranged round their parent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Arrangement {
    /// Evenly over length and azimuth, without a pattern: what is left of a phyllotaxis once many branches have died.
    #[default]
    Spread,
    /// One at a node, each turned against the last.
    Spiral {
        /// Turn from one to the next in radians, −2π to 2π. The paper's is 144°, the golden angle 137.5°.
        divergence: f32,
    },
    /// Two at a node, all pairs in one plane.
    Opposite,
    /// Two at a node, each pair across the last (the paper's "opposite-decussate").
    Decussate,
    /// Several at a node.
    Whorled {
        /// Branches of a whorl, 1 to 64.
        per_node: u32,
        /// Turn from a whorl to the next in radians, −2π to 2π. The paper's, for three, is 60°: half the angle between
        /// two of a whorl.
        turn: f32,
    },
    /// Two at a node, laid down as decussate pairs are, and brought into the horizontal plane by a twist of the
    /// internodes: what plagiotropic shoots do (yew, dawn redwood, many understorey shrubs). Unlike
    /// [`Opposite`](Self::Opposite), the plane is fixed, not only common.
    HorizontalDecussate {
        /// Azimuth at which the horizontal plane lies, in radians, −2π to 2π; its other side is π on. 0, the default of
        /// [`horizontal`](Self::horizontal), is left and right in the drawing.
        azimuth: f32,
    },
    /// Any other.
    Custom {
        /// Branches at a node, 1 to 64.
        per_node: u32,
        /// Turn from a node to the next in radians, −2π to 2π.
        turn: f32,
    },
}

impl Arrangement {
    /// The paper's spiral: 144°.
    #[must_use]
    pub const fn spiral() -> Self {
        Self::Spiral { divergence: SPIRAL }
    }

    /// The spiral of the golden angle: 137.5°.
    #[must_use]
    pub const fn golden() -> Self {
        Self::Spiral { divergence: GOLDEN }
    }

    /// Whorls that stand on the gaps of the last: the turn is half the angle between two of a whorl. `whorl(3)` is the
    /// paper's.
    #[must_use]
    pub fn whorl(per_node: u32) -> Self {
        Self::Whorled { per_node, turn: PI / per_node.max(1) as f32 }
    }

    /// Pairs in the horizontal plane, which is that of the drawing.
    #[must_use]
    pub const fn horizontal() -> Self {
        Self::HorizontalDecussate { azimuth: 0.0 }
    }

    /// Branches at a node, n. 1 for [`Spread`](Self::Spread).
    #[must_use]
    pub const fn per_node(&self) -> u32 {
        match *self {
            Self::Spread | Self::Spiral { .. } => 1,
            Self::Opposite | Self::Decussate | Self::HorizontalDecussate { .. } => 2,
            Self::Whorled { per_node, .. } | Self::Custom { per_node, .. } => per_node,
        }
    }

    /// Turn from a node to the next, φ, in radians. 0 for [`Spread`](Self::Spread).
    #[must_use]
    pub const fn turn(&self) -> f32 {
        match *self {
            Self::Spread | Self::Opposite | Self::HorizontalDecussate { .. } => 0.0,
            Self::Spiral { divergence } => divergence,
            Self::Decussate => FRAC_PI_2,
            Self::Whorled { turn, .. } | Self::Custom { turn, .. } => turn,
        }
    }

    /// Angle between two neighbours at a node, γ, in radians.
    #[must_use]
    pub fn spacing(&self) -> f32 {
        TAU / self.per_node().max(1) as f32
    }

    /// The azimuth that one privileged position of every node has, where the arrangement fixes it.
    #[must_use]
    pub const fn fixed(&self) -> Option<f32> {
        match *self {
            Self::HorizontalDecussate { azimuth } => Some(azimuth),
            _ => None,
        }
    }

    /// Whether branches have privileged positions at all.
    #[must_use]
    pub const fn has_pattern(&self) -> bool {
        !matches!(self, Self::Spread)
    }

    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("arrangement.per_node", self.per_node(), 1_u32, MOST_PER_NODE)?;
        check("arrangement.turn", self.turn(), -MOST_TURN, MOST_TURN)?;
        check("arrangement.azimuth", self.fixed().unwrap_or(0.0), -MOST_TURN, MOST_TURN)
    }
}

/// Degrees to two places, without a minus before zero.
fn degrees(radians: f32) -> f32 {
    (f64::from(radians) * (36_000.0 / std::f64::consts::TAU)).round() as f32 / 100.0 + 0.0
}

impl fmt::Display for Arrangement {
    /// The name that [`FromStr`] reads, angles in degrees to two places.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Spread => f.write_str("spread"),
            Self::Spiral { divergence } if divergence == SPIRAL => f.write_str("spiral"),
            Self::Spiral { divergence } => write!(f, "spiral:{}", degrees(divergence)),
            Self::Opposite => f.write_str("opposite"),
            Self::Decussate => f.write_str("decussate"),
            Self::Whorled { per_node, .. } if *self == Self::whorl(per_node) => {
                write!(f, "whorl{per_node}")
            }
            Self::Whorled { per_node, turn } => write!(f, "whorl{per_node}:{}", degrees(turn)),
            Self::HorizontalDecussate { azimuth: 0.0 } => f.write_str("horizontal"),
            Self::HorizontalDecussate { azimuth } => write!(f, "horizontal:{}", degrees(azimuth)),
            Self::Custom { per_node, turn } => write!(f, "{per_node}:{}", degrees(turn)),
        }
    }
}

impl FromStr for Arrangement {
    type Err = ModelError;

    /// Reads "spread", "spiral", "golden", "opposite", "decussate", "whorl3", "horizontal", or "2:90" for two at a node and
    /// a turn of 90°. An angle in degrees may follow the names that have one: "spiral:137.5", "whorl3:45",
    /// "horizontal:30".
    ///
    /// # Errors
    /// [`ModelError::UnknownPreset`] for another name, [`ModelError::Parameter`] for a number out of range.
    fn from_str(text: &str) -> Result<Self> {
        let unknown = || ModelError::UnknownPreset {
            name: text.to_owned(),
            known: "spread, spiral, golden, opposite, decussate, whorl3 (any number), horizontal, \
                    2:90 (branches at a node: turn in degrees)"
                .to_owned(),
        };
        let (name, angle) = match text.trim().split_once(':') {
            Some((name, angle)) => {
                let degrees: f32 = angle.trim().parse().map_err(|_| unknown())?;
                (name.trim(), Some(degrees.to_radians()))
            }
            None => (text.trim(), None),
        };
        let whorl = name.strip_prefix("whorl").map(str::parse);
        let arrangement = match (name, angle) {
            ("spread", None) => Self::Spread,
            ("spiral", None) => Self::spiral(),
            ("golden", None) => Self::golden(),
            ("spiral", Some(divergence)) => Self::Spiral { divergence },
            ("opposite", None) => Self::Opposite,
            ("decussate", None) => Self::Decussate,
            ("horizontal", _) => Self::HorizontalDecussate { azimuth: angle.unwrap_or(0.0) },
            _ => match (whorl, angle) {
                (Some(Ok(per_node)), None) => Self::whorl(per_node),
                (Some(Ok(per_node)), Some(turn)) => Self::Whorled { per_node, turn },
                (None, Some(turn)) => {
                    Self::Custom { per_node: name.parse().map_err(|_| unknown())?, turn }
                }
                _ => return Err(unknown()),
            },
        };
        arrangement.validate()?;
        Ok(arrangement)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_back() {
        for name in [
            "spread",
            "spiral",
            "opposite",
            "decussate",
            "whorl3",
            "whorl5:10",
            "horizontal",
            "horizontal:30",
            "2:90",
            "spiral:137.5",
            "4:-22.5",
        ] {
            let arrangement: Arrangement = name.parse().unwrap();
            assert_eq!(arrangement.to_string(), name);
        }
        assert_eq!("golden".parse::<Arrangement>().unwrap(), Arrangement::golden());
    }

    #[test]
    fn names_that_mean_nothing_are_refused() {
        for name in [
            "", "spiral:", "whorl", "whorl0", "x:3", "0:90", "2:nan", "2:9000", "65:1", "spread:3",
            "-1:4",
        ] {
            assert!(name.parse::<Arrangement>().is_err(), "{name}");
        }
    }

    #[test]
    fn the_papers_patterns_have_their_numbers() {
        let numbers = |a: Arrangement| (a.per_node(), degrees(a.turn()), degrees(a.spacing()));
        assert_eq!(numbers(Arrangement::spiral()), (1, 144.0, 360.0));
        assert_eq!(numbers(Arrangement::Opposite), (2, 0.0, 180.0));
        assert_eq!(numbers(Arrangement::Decussate), (2, 90.0, 180.0));
        assert_eq!(numbers(Arrangement::whorl(3)), (3, 60.0, 120.0));
    }
}
