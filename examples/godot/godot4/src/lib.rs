//! `BotanicalTree`, a node for Godot 4: grows a preset and is its mesh.
//!
//! Everything about trees goes through tree-ffi's C functions, as a plug-in in C or C++ would call them
//! ([`native`]); the library is linked in, so that one file is all there is to install.

mod array_mesh;
mod material;
mod native;

use array_mesh::array_mesh;
use godot::classes::{IMeshInstance3D, MeshInstance3D};
use godot::obj::EngineBitfield;
use godot::prelude::*;
use godot::register::info::{PropertyInfo, PropertyUsageFlags};
use native::{Failure, Mesh, Options, Tree};

struct BotanicalTreeExtension;

// SAFETY: the symbols are those that godot-rust makes for it.
#[gdextension]
unsafe impl ExtensionLibrary for BotanicalTreeExtension {}

/// A tree. It grows anew, once a frame at most, when properties change.
#[derive(GodotClass)]
#[class(base = MeshInstance3D, tool)]
struct BotanicalTree {
    /// Name of a preset: oak, a to l, taproot, heartroot.
    #[export]
    #[var(set = set_preset)]
    preset: GString,
    /// The same seed gives the same tree everywhere.
    #[export]
    #[var(set = set_seed)]
    seed: i64,
    /// Factor on the length of every leaf.
    #[export(range = (0.01, 4.0, 0.01))]
    #[var(set = set_leaf_scale)]
    leaf_scale: f32,
    /// How far the mesh may leave the round branch, in metres.
    #[export(range = (0.0001, 0.1, 0.0001))]
    #[var(set = set_error)]
    error: f32,
    /// Whether the mesh has UV2 for baked light.
    #[export]
    #[var(set = set_light_map)]
    light_map: bool,
    /// Whether vertices carry the wind, in CUSTOM0 to CUSTOM3: 64 bytes a vertex.
    #[export]
    #[var(set = set_wind)]
    wind: bool,
    /// Grows the tree anew.
    #[export_tool_button(fn = Self::press, name = "Rebuild")]
    rebuild_button: PhantomVar<Callable>,
    /// Whether a rebuild waits for the frame to end.
    waiting: bool,
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
            rebuild_button: PhantomVar::default(),
            waiting: false,
            base,
        }
    }

    fn ready(&mut self) {
        self.rebuild();
    }

    /// The mesh comes from the other properties: a scene that stores it would be as large as the tree.
    fn on_validate_property(&self, property: &mut PropertyInfo) {
        if property.property_name == StringName::from("mesh") {
            let stored = PropertyUsageFlags::STORAGE.ord();
            property.usage = PropertyUsageFlags::from_ord(property.usage.ord() & !stored);
        }
    }
}

#[godot_api]
impl BotanicalTree {
    /// Grows the tree anew. Returns whether it did; an error is printed and leaves the mesh as it was.
    #[func]
    fn rebuild(&mut self) -> bool {
        self.waiting = false;
        match self.grow() {
            Ok(()) => true,
            Err(failure) => {
                godot_error!("{failure}");
                false
            }
        }
    }

    #[func]
    fn set_preset(&mut self, preset: GString) {
        self.preset = preset;
        self.rebuild_soon();
    }

    #[func]
    fn set_seed(&mut self, seed: i64) {
        self.seed = seed;
        self.rebuild_soon();
    }

    #[func]
    fn set_leaf_scale(&mut self, leaf_scale: f32) {
        self.leaf_scale = leaf_scale;
        self.rebuild_soon();
    }

    #[func]
    fn set_error(&mut self, error: f32) {
        self.error = error;
        self.rebuild_soon();
    }

    #[func]
    fn set_light_map(&mut self, light_map: bool) {
        self.light_map = light_map;
        self.rebuild_soon();
    }

    #[func]
    fn set_wind(&mut self, wind: bool) {
        self.wind = wind;
        self.rebuild_soon();
    }
}

impl BotanicalTree {
    /// The button has no use for an answer.
    fn press(&mut self) {
        self.rebuild();
    }

    /// Once, however many properties change before the frame ends. Before it is ready a scene is still
    /// setting properties, and `ready` grows the tree.
    fn rebuild_soon(&mut self) {
        if self.waiting || !self.base().is_node_ready() {
            return;
        }
        self.waiting = true;
        self.run_deferred(|tree| {
            if tree.waiting {
                tree.rebuild();
            }
        });
    }

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
