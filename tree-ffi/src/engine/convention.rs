//! Whose axes numbers are in.

use crate::border::{Failure, Result, TREE_ERROR_PANIC, Versioned, call, tree_status, write};
use ::tree_mesh::convert::Convention;

/// Whose axes: one of the `TREE_CONVENTION_` constants.
///
/// | | hands | up | unit | front faces | v | from ours |
/// |---|---|---|---|---|---|---|
/// | glTF, Bevy, three.js | right | Y | m | counter-clockwise | down | as it is |
/// | Godot 4 | right | Y | m | clockwise | down | as it is |
/// | Unity | left | Y | m | clockwise | up | (-x, y, z) |
/// | Unreal | left | Z | cm | counter-clockwise | down | 100 (x, z, y) |
/// | Blender | right | Z | m | counter-clockwise | up | (x, -z, y) |
///
/// Clockwise or not is meant as seen on the screen, from outside.
pub type tree_convention = u32;

/// Ours: glTF, also Bevy and three.js.
pub const TREE_CONVENTION_GLTF: u32 = 0;
/// Godot 4.
pub const TREE_CONVENTION_GODOT: u32 = 1;
/// Unity.
pub const TREE_CONVENTION_UNITY: u32 = 2;
/// Unreal Engine.
pub const TREE_CONVENTION_UNREAL: u32 = 3;
/// Blender.
pub const TREE_CONVENTION_BLENDER: u32 = 4;

pub(super) fn convention(found: tree_convention, name: &str) -> Result<Convention> {
    match found {
        TREE_CONVENTION_GLTF => Ok(Convention::Gltf),
        TREE_CONVENTION_GODOT => Ok(Convention::Godot),
        TREE_CONVENTION_UNITY => Ok(Convention::Unity),
        TREE_CONVENTION_UNREAL => Ok(Convention::Unreal),
        TREE_CONVENTION_BLENDER => Ok(Convention::Blender),
        other => Err(Failure::not_one_of(name, other, "TREE_CONVENTION_")),
    }
}

pub(super) fn convention_number(convention: Convention) -> Result<tree_convention> {
    match convention {
        Convention::Gltf => Ok(TREE_CONVENTION_GLTF),
        Convention::Godot => Ok(TREE_CONVENTION_GODOT),
        Convention::Unity => Ok(TREE_CONVENTION_UNITY),
        Convention::Unreal => Ok(TREE_CONVENTION_UNREAL),
        Convention::Blender => Ok(TREE_CONVENTION_BLENDER),
        other => {
            let text = format!("{other:?} has no TREE_CONVENTION_ constant");
            Err(Failure::new(TREE_ERROR_PANIC, text))
        }
    }
}

/// What a convention says.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_convention_traits {
    /// `sizeof(tree_convention_traits)`.
    pub struct_size: usize,
    /// Length units in one metre.
    pub unit: f32,
    /// Whether the axes form a left hand.
    pub is_left_handed: u32,
    /// Whether front faces run clockwise, so that triangles must be turned.
    pub is_clockwise: u32,
    /// Whether texture v runs upwards.
    pub is_v_up: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_convention_traits {
    const NAME: &'static str = "tree_convention_traits";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(Convention::default())
    }
}

impl tree_convention_traits {
    fn of(convention: Convention) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            unit: convention.unit(),
            is_left_handed: convention.is_left_handed().into(),
            is_clockwise: convention.is_clockwise().into(),
            is_v_up: convention.is_v_up().into(),
        }
    }
}

/// What a convention says. Set `traits->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_convention_view(
    convention: tree_convention,
    traits: *mut tree_convention_traits,
) -> tree_status {
    call(|| {
        let found = self::convention(convention, "convention")?;
        unsafe { write(traits, "traits", &tree_convention_traits::of(found)) }
    })
}
