//! Areas in the plane, shared by drawings and outlines: contours that cross become simple ones ([`arrange`]), areas
//! become triangles ([`fill`]), and triangles a chordal axis ([`axis`]).

pub(crate) mod arrange;
pub(crate) mod axis;
pub(crate) mod fill;
