//! What the leaves of a kind look like.

use super::{tree_leaf_mesh, tree_material};
use crate::border::{Failure, Result, Versioned, call, init, read, read_or_default, tree_status};
use ::tree_mesh::{LeafForm, LeafLook};
use std::sync::Arc;
use tree_model::tree_core::Limits;

/// What a leaf is cut out of: one of the `TREE_LEAF_` constants. Fold, bend and number of sheets go with every form but `TREE_LEAF_MESH`.
pub type tree_leaf_form = u32;
/// A rectangle as large as the picture. Two triangles; the least memory, the most overdraw.
pub const TREE_LEAF_CARD: u32 = 0;
/// A polygon of at most `max_vertices` vertices around all of the picture that is not cut away: no visible
/// pixel is lost, few invisible ones are drawn. A picture without a mask, or all of it cut away, stays a
/// card; the report says so.
pub const TREE_LEAF_OUTLINE: u32 = 1;
/// A leaf whose margin is modelled: a polygon along the margin of the picture, as much inside as outside,
/// drawn without a mask. For close views and for renderers that pay for masks. Leaves are taken to be
/// alike left and right. Pictures as above stay cards.
pub const TREE_LEAF_MODELLED: u32 = 2;
/// A leaf of your own, shared by all leaves of the kind.
pub const TREE_LEAF_MESH: u32 = 3;

/// Vertices of a polygon where none are told: the number that the Rust documentation calls good.
const VERTICES: u32 = 8;

/// What leaves of one kind look like: as input (begin with `tree_leaf_look_init`), or as a view.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_leaf_look {
    /// `sizeof(tree_leaf_look)`.
    pub struct_size: usize,
    /// Goes on the leaves. Should be double-sided, with an alpha mask where the texture has one. As input,
    /// NULL is the default material. In views always NULL: `tree_look_material` views it.
    pub material: *const tree_material,
    /// With `TREE_LEAF_MESH`: the leaf, which is copied. In views always NULL: `tree_look_leaf_mesh` views
    /// it.
    pub mesh: *const tree_leaf_mesh,
    /// Width of the picture in lengths of the leaf, 0.001 to 1000; 1 is square. Default 1. Unused by
    /// `TREE_LEAF_MESH`, which has its own.
    pub width: f32,
    /// What a leaf is cut out of. Default `TREE_LEAF_CARD`.
    pub form: tree_leaf_form,
    /// With `TREE_LEAF_OUTLINE` and `TREE_LEAF_MODELLED`: most vertices of the polygon, 4 to 64. Default
    /// 8; a modelled leaf of 12 has up to 20 triangles when folded or bent.
    pub max_vertices: u32,
    /// Copies of the leaf turned about its midrib, evenly over half a turn, 1 to 8. Two or three make
    /// clusters and needles look full from all sides. Default 1.
    pub sheets: u32,
    /// Angle in radians by which each half of a leaf stands up along the midrib, 0 to 1.4. Default 0.
    pub fold: f32,
    /// Angle in radians by which the midrib bends down from base to apex, evenly, 0 to π. Default 0.
    pub bend: f32,
    /// Rows of triangles that a bent leaf has at least, 1 to 16. Default 2.
    pub rows: u32,
    /// Width of petioles in lengths of the leaf, 0 to 0.2: a prism of three sides from the shoot to the
    /// base of the leaf, eight vertices and six triangles a leaf. Default 0, none.
    pub petiole: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_leaf_look {
    const NAME: &'static str = "tree_leaf_look";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&LeafLook::default())
    }
}

impl tree_leaf_look {
    /// A view.
    pub(super) fn of(look: &LeafLook) -> Self {
        let (form, max_vertices) = match &look.form {
            LeafForm::Card => (TREE_LEAF_CARD, VERTICES),
            LeafForm::Outline { max_vertices } => (TREE_LEAF_OUTLINE, *max_vertices),
            LeafForm::Modelled { max_vertices } => (TREE_LEAF_MODELLED, *max_vertices),
            LeafForm::Mesh(_) => (TREE_LEAF_MESH, VERTICES),
        };
        Self {
            struct_size: size_of::<Self>(),
            material: std::ptr::null(),
            mesh: std::ptr::null(),
            width: look.width,
            form,
            max_vertices,
            sheets: look.sheets,
            fold: look.fold,
            bend: look.bend,
            rows: look.rows,
            petiole: look.petiole,
        }
    }

    unsafe fn form(&self, limits: &Limits, argument: &str) -> Result<LeafForm> {
        let max_vertices = self.max_vertices;
        match self.form {
            TREE_LEAF_CARD => Ok(LeafForm::Card),
            TREE_LEAF_OUTLINE => Ok(LeafForm::Outline { max_vertices }),
            TREE_LEAF_MODELLED => Ok(LeafForm::Modelled { max_vertices }),
            TREE_LEAF_MESH => {
                let name = format!("{argument}.mesh");
                let mesh = unsafe { read(self.mesh, &name)?.rust(limits, &name) }?;
                Ok(LeafForm::Mesh(Arc::new(mesh)))
            }
            other => Err(Failure::not_one_of(&format!("{argument}.form"), other, "TREE_LEAF_")),
        }
    }

    /// A checked copy but for its material; `argument` is what it is called by.
    pub(super) unsafe fn rust(&self, limits: &Limits, argument: &str) -> Result<LeafLook> {
        let name = format!("{argument}.material");
        let material = unsafe { read_or_default(self.material, &name)?.rust(&name) }?;
        let look = LeafLook {
            material,
            width: self.width,
            form: unsafe { self.form(limits, argument) }?,
            sheets: self.sheets,
            fold: self.fold,
            bend: self.bend,
            rows: self.rows,
            petiole: self.petiole,
        };
        look.check()?;
        Ok(look)
    }
}

/// Makes `look`, of `size` bytes, the default: a square card.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_look_init(
    look: *mut tree_leaf_look,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(look, size) })
}
