//! `BotanicalTree`, a node for Godot 4: grows a preset and is its mesh.
//!
//! Everything about trees goes through tree-ffi's C functions, as a plug-in in C or C++ would call them
//! ([`native`]); the library is linked in, so that one file is all there is to install.

mod array_mesh;
mod material;
mod native;

use array_mesh::array_mesh;
use godot::classes::{IMeshInstance3D, MeshInstance3D};
use godot::prelude::*;
use native::{Failure, Mesh, Options, Tree};

struct BotanicalTreeExtension;

// SAFETY: the symbols are those that godot-rust makes for it.
#[gdextension]
unsafe impl ExtensionLibrary for BotanicalTreeExtension {}

/// A tree. Change properties and call `rebuild()`.
#[derive(GodotClass)]
#[class(base = MeshInstance3D, tool)]
struct BotanicalTree {
    /// Name of a preset: oak, a to l, taproot, heartroot.
    #[export]
    preset: GString,
    /// The same seed gives the same tree everywhere.
    #[export]
    seed: i64,
    /// Factor on the length of every leaf.
    #[export(range = (0.01, 4.0, 0.01))]
    leaf_scale: f32,
    /// How far the mesh may leave the round branch, in metres.
    #[export(range = (0.0001, 0.1, 0.0001))]
    error: f32,
    /// Whether the mesh has UV2 for baked light.
    #[export]
    light_map: bool,
    /// Whether vertices carry the wind, in CUSTOM0 to CUSTOM3: 64 bytes a vertex.
    #[export]
    wind: bool,
    base: Base<MeshInstance3D>,
}

#[godot_api]
impl IMeshInstance3D for BotanicalTree {
    fn init(base: Base<MeshInstance3D>) -> Self {
        Self {
            preset: "oak".into(),
            seed: 1,
            leaf_scale: 1.0,
            error: 0.003,
            light_map: false,
            wind: true,
            base,
        }
    }

    fn ready(&mut self) {
        self.rebuild();
    }
}

#[godot_api]
impl BotanicalTree {
    /// Grows the tree anew. Returns whether it did; an error is printed and leaves the mesh as it was.
    #[func]
    fn rebuild(&mut self) -> bool {
        match self.grow() {
            Ok(()) => true,
            Err(failure) => {
                godot_error!("{failure}");
                false
            }
        }
    }
}

impl BotanicalTree {
    fn grow(&mut self) -> Result<(), Failure> {
        let tree = Tree::grow(&self.preset.to_string(), self.seed.cast_unsigned())?;
        let options =
            Options { leaf_scale: self.leaf_scale, error: self.error, light_map: self.light_map };
        let mesh = Mesh::build(&tree, &options)?;
        let made = array_mesh(&mesh, self.light_map, self.wind)?;
        self.base_mut().set_mesh(&made);
        Ok(())
    }
}
