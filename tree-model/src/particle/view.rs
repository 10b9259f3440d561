//! One photograph, ready to be used: what it shows of the tree and where it was taken from.

use super::camera::Camera;
use super::matte::Matte;
use super::photo::Photo;

/// One photograph, ready to be used.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// How much of each pixel the tree covers.
    pub matte: Matte,
    /// The photograph itself, of the same size, where livewire may look for branches. Without it, it
    /// looks at the matte.
    pub photo: Option<Photo>,
    /// Where it was taken from.
    pub camera: Camera,
}
