//! What a surface is, apart from its shape: points, edges, holes, pieces, crossings.
//!
//! Vertices that are copies of one point, for a seam of the texture, count as one here: [`welded`]
//! tells which. [`examine`] counts what makes a closed, consistently oriented 2-manifold,
//! [`self_intersections`] finds triangles that cross, [`weld`] makes a surface without copies, for
//! volumes and printers.
//!
//! ```
//! # use tree_core::{Control, Skeleton, Species, Tree, glam::Vec3};
//! # use tree_mesh::{Look, MeshParams, build, topology};
//! # let mut builder = Skeleton::builder(Vec3::ZERO, 0.2)?;
//! # builder.add(0, Vec3::Y * 3.0, 0.1)?;
//! # let tree = Tree::bare(builder.finish(), Species::default());
//! # let look = Look::plain(tree.species());
//! let built = build(&tree, &look, &MeshParams::default(), &Control::default())?;
//! let found = topology::examine(&built.mesh.surfaces[0])?;
//! assert!(found.is_closed() && found.euler() == 2 && found.volume > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bvh;
mod crossings;
pub(crate) mod edges;
mod examine;
mod triangles;
mod weld;

pub use crossings::{Crossings, self_intersections};
pub use examine::{FLAT_SHARE, Topology, examine};
pub use weld::{Points, weld, welded};

#[cfg(test)]
pub(crate) mod shapes;
#[cfg(test)]
mod tests;
