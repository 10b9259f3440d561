//! Pictures, masks and silhouettes of meshes.

mod mask;
mod picture;
mod render;
mod style;
mod view;

pub use mask::*;
pub use picture::*;
pub use render::*;
pub use style::*;
pub use view::*;
