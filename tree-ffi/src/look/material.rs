//! What a surface looks like.

use super::tree_texture;
use crate::border::{Failure, Result, Versioned, call, get_opt, init, tree_status, tree_str};
use ::tree_mesh::{Alpha, Material, Mesh};

/// How a material treats the alpha of its texture: one of the `TREE_ALPHA_` constants.
pub type tree_alpha = u32;
/// Alpha is ignored.
pub const TREE_ALPHA_OPAQUE: u32 = 0;
/// Pixels with alpha below the material's `alpha_cutoff` are not drawn.
pub const TREE_ALPHA_MASK: u32 = 1;

/// What a surface looks like, in glTF's metallic-roughness terms; nothing on a tree is metal. As input
/// (begin with `tree_material_init`), or as a view.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_material {
    /// `sizeof(tree_material)`.
    pub struct_size: usize,
    /// Name for people and files. As input, empty is `material`.
    pub name: tree_str,
    /// As input: the picture wrapped on the surface, or NULL for none; the material keeps what it needs,
    /// so the handle may be freed. In views always NULL: `has_texture` says whether there is one, and
    /// `tree_mesh_texture` or `tree_look_texture` give a handle of it.
    pub texture: *const tree_texture,
    /// Linear colour (0 or more; files hold up to 1) and alpha (0 to 1), multiplied with the texture.
    /// Default white.
    pub base_color: [f32; 4],
    /// 0 mirror-like to 1 matt. Default 0.9.
    pub roughness: f32,
    /// How texture alpha is used. Default `TREE_ALPHA_OPAQUE`.
    pub alpha: tree_alpha,
    /// With `TREE_ALPHA_MASK`: alpha below which pixels are not drawn, 0 to 1. Default 0.5.
    pub alpha_cutoff: f32,
    /// Whether back faces are drawn, with their normals turned over. Default no.
    pub double_sided: u32,
    /// Share of the light on one face that shines through the other, 0 to 1. Leaves have about 0.4.
    /// Default 0.
    pub translucency: f32,
    /// In views: whether there is a texture. Ignored in input.
    pub has_texture: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_material {
    const NAME: &'static str = "tree_material";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        // A view of the default's name would outlive it.
        Self { name: tree_str::EMPTY, ..Self::of(&Material::default()) }
    }
}

impl tree_material {
    /// A view.
    pub(crate) fn of(material: &Material) -> Self {
        let (alpha, alpha_cutoff) = match material.alpha {
            Alpha::Opaque => (TREE_ALPHA_OPAQUE, 0.5),
            Alpha::Mask(cutoff) => (TREE_ALPHA_MASK, cutoff),
        };
        Self {
            struct_size: size_of::<Self>(),
            name: tree_str::of(&material.name),
            texture: std::ptr::null(),
            base_color: material.base_color,
            roughness: material.roughness,
            alpha,
            alpha_cutoff,
            double_sided: material.double_sided.into(),
            translucency: material.translucency,
            has_texture: material.texture.is_some().into(),
        }
    }

    /// A copy that shares the texture; `argument` is what it is called by. Ranges are checked by
    /// [`check_materials`].
    pub(crate) unsafe fn rust(&self, argument: &str) -> Result<Material> {
        let part = |name: &str| format!("{argument}.{name}");
        let name = unsafe { self.name.get(&part("name")) }?.to_owned();
        let texture = unsafe { get_opt(self.texture, &part("texture")) }?;
        let alpha = match self.alpha {
            TREE_ALPHA_OPAQUE => Alpha::Opaque,
            TREE_ALPHA_MASK => Alpha::Mask(self.alpha_cutoff),
            other => return Err(Failure::not_one_of(&part("alpha"), other, "TREE_ALPHA_")),
        };
        Ok(Material {
            name: if name.is_empty() { Material::default().name } else { name },
            base_color: self.base_color,
            texture: texture.map(|texture| texture.rust().clone()),
            roughness: self.roughness,
            alpha,
            double_sided: self.double_sided != 0,
            translucency: self.translucency,
        })
    }
}

/// Checks the ranges of materials as a mesh does, and gives them back.
pub(super) fn check_materials(materials: Vec<Material>) -> Result<Vec<Material>> {
    let mesh = Mesh { materials, ..Mesh::default() };
    mesh.check()?;
    Ok(mesh.materials)
}

/// Makes `material`, of `size` bytes, the default: white, matt, without texture.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_material_init(
    material: *mut tree_material,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(material, size) })
}
