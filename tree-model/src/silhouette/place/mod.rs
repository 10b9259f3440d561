//! Where branches stand on their parent, round it and along it, and how far they reach (Wither et al. 2009, section 5).
//!
//! A person draws the branches that extend sideways and omits those towards and away from the viewer. The drawn ones
//! keep their place along the parent and may turn a little out of the drawing plane; the added ones may stand anywhere.
//!
//! 1. [`Arrangement`]: which pattern the branches follow (5.5);
//! 2. [`gibbs::arrange`]: positions of all of them by a Gibbs process (5.2 to 5.4), from a start by `nodes`;
//! 3. [`concentration::privileged`]: how well they keep to the pattern, as a test that can fail;
//! 4. [`revolve::Revolved`]: how long the added ones are (5.6).

pub mod arrangement;
pub mod concentration;
mod cost;
pub mod domain;
pub mod gibbs;
mod nodes;
pub mod revolve;

pub use arrangement::Arrangement;
pub use concentration::{Concentration, privileged};
pub use domain::{Domain, Site};
pub use gibbs::{Arranged, GibbsParams, arrange, ready};
