//! OBJ with its materials (MTL) and, with the feature `image`, its textures (PNG).
//!
//! **Written**: one object (`o`) per surface with triangles, named after its material. OBJ's v axis
//! points up, so v is written as 1 − v. Numbers are rounded to micrometres, normals to 1e-4.
//! Alpha-masked materials name their texture in `map_d` as well; roughness goes in as `Pr`. Tangents and
//! the other optional columns have no place in OBJ.
//!
//! **Read**: [`read`]; one surface per material.
//!
//! Cost of writing: one pass, a fixed buffer; numbers are formatted as integers, about 30 million a
//! second.

mod face;
mod mtl;
mod read;
mod write;

pub use read::{from_slice, from_slices, read};
pub use write::{to_strings, write_obj};
