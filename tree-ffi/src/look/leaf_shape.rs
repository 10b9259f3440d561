//! Leaves drawn to the caller's wishes.

use super::texture::draw;
use super::{small, tree_leaf_card, tree_texture};
use crate::border::{
    Result, Versioned, call, init, out, read, read_or_default, slice, text, tree_status, view,
    write,
};
use crate::control::tree_control;
use crate::mesh::column;
use ::tree_mesh::texture::{
    LEAF_SIZE, LeafShape, LeafStyle, SPRAY_SIZE, Spray, Teeth, Veins, leaf_shape, leaf_with,
};
use std::borrow::Cow;
use std::ffi::c_char;
use tree_model::tree_core::{Resource, Seed};

/// The shape and colours of a leaf, in lengths of its blade (the petiole joins at the origin, the apex is
/// at 0, 1), and how leaves stand on a twig. Angles in radians, colours in sRGB. Begin with
/// `tree_leaf_shape_init`, or with the shape of a built-in leaf by `tree_leaf_shape_of`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_leaf_shape {
    /// `sizeof(tree_leaf_shape)`.
    pub struct_size: usize,
    /// Where mottling and the irregularities of a spray start. Default 0.
    pub seed: u64,
    /// Right half of the outline from the petiole to the apex, three floats for each point: x (0 to 2), y
    /// (-1 to 2) and sharpness (0 rounded, 1 a corner). Default an ovate leaf.
    pub outline: *const f32,
    /// Number of points of the outline, 2 to 256.
    pub n_outline: usize,
    /// Angles of the main veins of the right half with the midrib, 0 to π. The midrib is always there.
    /// Default none.
    pub rays: *const f32,
    /// Number of `rays`, at most 8.
    pub n_rays: usize,
    /// Pairs of secondary veins per blade length, 0 to 64. Default 8.
    pub vein_pairs: f32,
    /// Rise of the secondary veins along the main vein per distance from it, 0 to 4. Default 0.8.
    pub vein_slope: f32,
    /// How much lighter veins are, 0 to 1. Default 0.5.
    pub vein_contrast: f32,
    /// Teeth on each half of the margin, 0 to 100. Default 0.
    pub n_teeth: u32,
    /// How far teeth stand out, in blade lengths, 0 to 0.2. Default 0.
    pub tooth_depth: f32,
    /// Teeth from 0 for waves to 1 for a saw that points to the apex. Default 0.
    pub tooth_sharpness: f32,
    /// Whether each tooth bears three smaller ones. Default no.
    pub double_teeth: u32,
    /// Length of the petiole, as share of the whole leaf, 0 to 0.8. Default 0.15.
    pub petiole: f32,
    /// Strength of mottling and shading, 0 to 1. Default 0.5.
    pub mottle: f32,
    /// Whether leaves stand on a twig, as the fields that begin with `spray` say (lengths in lengths of
    /// the twig; along it, angles and sizes go evenly from the first value to the last). Default no.
    pub has_spray: u32,
    /// Leaves on the main twig, 1 to 400; one of them ends it. Default 9.
    pub spray_leaves: u32,
    /// Whether leaves stand in pairs. Default no.
    pub spray_opposite: u32,
    /// Share of the twig below the first leaf, 0 to 0.9. Default 0.2.
    pub spray_bare: f32,
    /// Angle of the lowest and the topmost leaf with the twig, 0 to π. Default 1.15, 0.5.
    pub spray_angle: [f32; 2],
    /// Length of the lowest, a middle and the topmost leaf, 0.01 to 2. Default 0.42, 0.46, 0.4.
    pub spray_size: [f32; 3],
    /// How irregular angle, size and brightness are, 0 to 1. Default 0.5.
    pub spray_jitter: f32,
    /// How far leaves turn towards the tip of the twig on their way, in leaf lengths, -0.5 to 0.5. Default
    /// 0.08.
    pub spray_bend: f32,
    /// Thickness of the twig at its base, 0.001 to 0.2. Default 0.022.
    pub spray_twig: f32,
    /// Side shoots, 0 to 32; they bear the same leaves, fewer. Default 0.
    pub spray_shoots: u32,
    /// Angle of the side shoots, 0 to π. Default 0.8.
    pub spray_shoot_angle: f32,
    /// Length of the lowest side shoot, 0.05 to 1. Default 0.5.
    pub spray_shoot_size: f32,
    /// Colour of the blade. Default a mid green.
    pub base: [u8; 3],
    /// Colour of the veins.
    pub vein: [u8; 3],
    /// Colour of the petiole.
    pub stalk: [u8; 3],
    /// What `tree_leaf_shape_autumn` turns the blade to.
    pub autumn: [u8; 3],
    /// Colour of the twig of a spray.
    pub spray_twig_color: [u8; 3],
    /// Not used; 0.
    pub reserved: u8,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_leaf_shape {
    const NAME: &'static str = "tree_leaf_shape";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&LeafShape::default())
    }
}

/// What a constant borrows: all shapes of this crate are constants.
#[expect(clippy::ptr_arg, reason = "what is borrowed lives longer than the Cow")]
fn constant<T: Clone>(column: &Cow<'static, [T]>) -> &'static [T] {
    match column {
        Cow::Borrowed(rows) => rows,
        Cow::Owned(_) => &[],
    }
}

impl tree_leaf_shape {
    /// A view of a shape whose outline and veins are constants.
    fn of(shape: &LeafShape) -> Self {
        let (outline, rays) = (constant(&shape.outline), constant(&shape.veins.rays));
        let spray = shape.spray.unwrap_or_default();
        Self {
            struct_size: size_of::<Self>(),
            seed: shape.seed.0,
            outline: column(outline).cast(),
            n_outline: outline.len(),
            rays: column(rays),
            n_rays: rays.len(),
            vein_pairs: shape.veins.pairs,
            vein_slope: shape.veins.slope,
            vein_contrast: shape.veins.contrast,
            n_teeth: shape.teeth.count,
            tooth_depth: shape.teeth.depth,
            tooth_sharpness: shape.teeth.sharpness,
            double_teeth: shape.teeth.double.into(),
            petiole: shape.petiole,
            mottle: shape.style.mottle,
            has_spray: shape.spray.is_some().into(),
            spray_leaves: spray.leaves,
            spray_opposite: spray.opposite.into(),
            spray_bare: spray.bare,
            spray_angle: spray.angle,
            spray_size: spray.size,
            spray_jitter: spray.jitter,
            spray_bend: spray.bend,
            spray_twig: spray.twig,
            spray_shoots: spray.shoots,
            spray_shoot_angle: spray.shoot_angle,
            spray_shoot_size: spray.shoot_size,
            base: shape.style.base,
            vein: shape.style.vein,
            stalk: shape.style.stalk,
            autumn: shape.style.autumn,
            spray_twig_color: spray.twig_color,
            reserved: 0,
        }
    }

    fn style(&self) -> LeafStyle {
        LeafStyle {
            base: self.base,
            vein: self.vein,
            stalk: self.stalk,
            autumn: self.autumn,
            mottle: self.mottle,
        }
    }

    fn spray(&self) -> Spray {
        Spray {
            leaves: self.spray_leaves,
            opposite: self.spray_opposite != 0,
            bare: self.spray_bare,
            angle: self.spray_angle,
            size: self.spray_size,
            jitter: self.spray_jitter,
            bend: self.spray_bend,
            twig: self.spray_twig,
            twig_color: self.spray_twig_color,
            shoots: self.spray_shoots,
            shoot_angle: self.spray_shoot_angle,
            shoot_size: self.spray_shoot_size,
        }
    }

    /// A copy, checked by whoever draws it.
    unsafe fn rust(&self) -> Result<LeafShape> {
        let (limits, rows) = (small(), Resource::Nodes);
        let outline: &[[f32; 3]] =
            unsafe { slice(self.outline.cast(), self.n_outline, &limits, rows, "shape.outline") }?;
        let rays = unsafe { slice(self.rays, self.n_rays, &limits, rows, "shape.rays") }?;
        Ok(LeafShape {
            outline: outline.to_vec().into(),
            teeth: Teeth {
                count: self.n_teeth,
                depth: self.tooth_depth,
                sharpness: self.tooth_sharpness,
                double: self.double_teeth != 0,
            },
            petiole: self.petiole,
            veins: Veins {
                rays: rays.to_vec().into(),
                pairs: self.vein_pairs,
                slope: self.vein_slope,
                contrast: self.vein_contrast,
            },
            style: self.style(),
            spray: (self.has_spray != 0).then(|| self.spray()),
            seed: Seed(self.seed),
        })
    }
}

/// Makes `shape`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_shape_init(
    shape: *mut tree_leaf_shape,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(shape, size) })
}

/// The shape of a built-in leaf, to be changed; what it points at is valid for ever. Set
/// `shape->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_shape_of(
    name: *const c_char,
    name_len: usize,
    shape: *mut tree_leaf_shape,
) -> tree_status {
    call(|| {
        let found = leaf_shape(unsafe { text(name, name_len, "name") }?)?;
        unsafe { write(shape, "shape", &tree_leaf_shape::of(&found)) }
    })
}

/// Turns the colours of a shape to those of autumn: `progress` 0 is summer and changes nothing, 1 is fully
/// turned.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_shape_autumn(
    shape: *mut tree_leaf_shape,
    progress: f32,
) -> tree_status {
    call(|| {
        let old = unsafe { read(shape.cast_const(), "shape") }?;
        let style = old.style().autumn(progress);
        let LeafStyle { base, vein, stalk, autumn, mottle } = style;
        let new = tree_leaf_shape { base, vein, stalk, autumn, mottle, ..old };
        unsafe { write(shape, "shape", &new) }
    })
}

/// Draws a leaf of your own, upright with the base at the bottom centre; its name is `leaf`. `shape` and
/// `card` may be NULL; `size` and `card` are as for `tree_texture_leaf`. Free the texture with
/// `tree_texture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_texture_leaf_with(
    shape: *const tree_leaf_shape,
    size: u32,
    control: *const tree_control,
    card: *mut tree_leaf_card,
    texture: *mut *mut tree_texture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(texture, "texture") }?;
        let shape = unsafe { read_or_default(shape, "shape")?.rust() }?;
        let size = match size {
            0 if shape.spray.is_some() => SPRAY_SIZE,
            0 => LEAF_SIZE,
            size => size,
        };
        let drawn = unsafe { draw(size, control, || Ok(leaf_with(&shape, size)?)) }?;
        unsafe { view(card, "card", &tree_leaf_card::of(&drawn)) }?;
        place.put(tree_texture::new(drawn.texture));
        Ok(())
    })
}
