//! How well a simplified model covers the pixels of the full one (Neubert 2012, §7.2).
//!
//! * [`Score`]: precision, recall and quality of one picture or many (eq. 7.3 to 7.7).
//! * [`Table`]: best scale and quality of a model for each share of geometry (§7.2.2).
//! * [`Distance`]: share of geometry for each distance (§7.2.5).
//!
//! λ is the share of the foliage's triangles that is drawn, 0 to 1. s is a factor on *area*, as in the
//! paper: lengths grow by √s.

mod distance;
mod measure;
mod score;
mod table;

pub use distance::{Distance, MinimumQuality};
pub use measure::{Scale, Subject, TableParams, mean_quality, scores_at};
pub use score::Score;
pub use table::{Row, Table, contrast, cook_lambda, cook_scale, drop_and_resize, size_lambda};
