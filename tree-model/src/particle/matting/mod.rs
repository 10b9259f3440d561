//! Separating a tree from what is behind it (Neubert 2012, section 3.2.1).
//!
//! A photograph's colour C is a mixture of the tree's colour F and the background's B,
//! `C = α F + (1 − α) B` (Porter and Duff 1984). The α of every pixel is the [`Matte`](super::Matte).
//!
//! * [`alpha_of`]: the photograph has an alpha channel already.
//! * [`screen`] and [`difference`]: taken before a blue or green screen, or a second time without the tree.
//! * [`natural`]: before anything, with a [`Trimap`] that says where the tree certainly is and is not:
//!   a picture, strokes, or sampled colours.
//!   The thesis names the methods of Ruzon and Tomasi, Chuang and Sun; here it is closed-form matting
//!   (Levin, Lischinski and Weiss 2008), which needs fewer known pixels than they do.
//! * [`automatic`]: a tree against sky, where the trimap is found too.

mod alpha;
mod automatic;
mod blend;
mod colors;
mod laplacian;
mod natural;
mod palette;
mod scene;
mod simple;
mod sky;
mod solve;
mod trimap;

pub use alpha::alpha_of;
pub use automatic::{AutomaticParams, AutomaticReport, automatic};
pub use natural::{NaturalParams, NaturalReport, natural};
pub use simple::{DifferenceParams, ScreenColor, ScreenParams, difference, screen};
pub use trimap::{ColorSamples, Level, Stroke, Trimap};
