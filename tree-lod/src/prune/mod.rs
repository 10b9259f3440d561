//! One index buffer from which every level of detail is drawn (Neubert 2012, §7.2.2 and §7.4; Cook et al.
//! 2007).
//!
//! 1. [`Schedule`]: which elements a share λ of the triangles draws, and with which outlines; [`plan`] finds
//!    by measuring when outlines should become simpler, and when elements should go.
//! 2. `layout`: the tiers of triangles one after another, the coarsest first, so that each level is one
//!    *window* of the index buffer: its end moves back as elements are dropped, and all of it as tiers
//!    change. In the coarsest tier, or when there is only one, it is a prefix.
//! 3. `vertices`: each vertex belongs to one element and knows its centre, and the λ from which on it is
//!    drawn.
//! 4. [`PrunedModel`]: all of it, for a mesh. A [`Level`] is what is drawn for a λ: windows, and
//!    the numbers that the shader needs ([`WGSL`], [`GLSL`], [`HLSL`]).
//! 5. Levels as meshes of their own ([`PrunedModel::mesh_at`]), as models of a scene, in glTF and JSON.
//!
//! [`PrunedModel::make`] does all steps from a mesh on.
//!
//! Departures: the paper only shortens the prefix; here leaves also get simpler outlines. Fading leaves
//! have no size where they begin to be drawn, after Cook; the first in the order never fade, so that
//! something is always drawn.
//!
//! ```
//! use tree_lod::glam::{Vec2, Vec3};
//! use tree_lod::order::Ranking;
//! use tree_lod::outline::Tier;
//! use tree_lod::prune::{PruneParams, PrunedModel};
//! use tree_lod::quality::{Row, Subject, Table};
//! use tree_lod::tree_core::Control;
//! use tree_lod::tree_mesh::{Material, Mesh, Surface};
//! use tree_lod::{Elements, LeafSurfaces, Grain};
//!
//! let mut leaves = Surface::default();
//! for x in 0..10 {
//!     let first = leaves.positions.len() as u32;
//!     leaves.positions.extend([Vec3::ZERO, Vec3::X, Vec3::Y].map(|p| p + 2.0 * x as f32 * Vec3::X));
//!     leaves.normals.extend([Vec3::Z; 3]);
//!     leaves.uvs.extend([Vec2::ZERO; 3]);
//!     leaves.indices.extend([first, first + 1, first + 2]);
//! }
//! let mesh = Mesh { surfaces: vec![leaves], materials: vec![Material::default()], ..Mesh::default() };
//!
//! let control = Control::default();
//! let elements = Elements::of_mesh(&mesh, &LeafSurfaces::Surfaces(vec![0]), Grain::Blade, &control)?;
//! let tiers = [Tier::full(&mesh, &elements)];
//! let ranking = Ranking { order: (0..10).collect(), pivots: elements.centers.clone() };
//! let row = |lambda: f32| Row { lambda, scale: 1.0 / lambda, ..Row::default() };
//! let table = Table::new(vec![row(0.1), row(0.5), row(1.0)])?;
//! let subject =
//!     Subject { mesh: &mesh, elements: &elements, tiers: &tiers, ranking: &ranking, kept: &[] };
//! let model = PrunedModel::new(&subject, table, &PruneParams::default(), &control)?;
//!
//! let level = model.level(0.5)?;
//! assert_eq!((level.windows[0].first_index, level.windows[0].index_count), (0, 15));
//! assert_eq!(model.mesh_at(0.5)?.n_triangles(), 5);
//! # Ok::<(), tree_lod::LodError>(())
//! ```

mod bake;
#[cfg(feature = "gltf")]
mod gltf;
mod json;
mod layout;
mod level;
mod make;
mod mean;
mod model;
mod plan;
mod scene;
mod schedule;
mod shader;
mod size;
#[cfg(test)]
mod tests;
pub(crate) mod vertices;

#[cfg(feature = "gltf")]
pub use gltf::Screen;
pub use level::{Level, Window};
pub use make::MakeParams;
pub use model::{Part, PruneParams, PrunedModel};
pub use plan::plan;
pub use schedule::{Cut, Schedule};
pub use shader::{GLSL, HLSL, WGSL, color, position};
pub use size::Sizes;
