//! Bark drawn to the caller's wishes.

use super::texture::draw;
use super::{small, tree_texture};
use crate::border::{
    Result, Versioned, call, init, out, read_or_default, slice, text, tree_status, write,
};
use crate::control::tree_control;
use crate::mesh::column;
use ::tree_mesh::texture::{BARK_SIZE, BarkStyle, Lenticels, Patches, bark_style, bark_with};
use std::borrow::Cow;
use std::ffi::c_char;
use std::mem::offset_of;
use tree_model::tree_core::{Resource, Seed};

/// Lenticels where a style has none: those of a birch-like bark, for who switches them on.
const LENTICELS: Lenticels =
    Lenticels { color: [62, 54, 48], count: [5, 34], share: 0.45, length: 1.0, thickness: 0.45 };

/// Spots of another colour on bark. Has no `struct_size`: it is a row of an array, and never changes.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub struct tree_bark_patches {
    /// sRGB colour.
    pub color: [u8; 3],
    /// Not used.
    pub reserved: u8,
    /// Waves of the noise that shapes them, across and along, 1 to 256.
    pub count: [u32; 2],
    /// Share of the bark they cover, roughly, 0 to 1.
    pub share: f32,
    /// Width of their edges, 0.01 (hard) to 1.
    pub softness: f32,
    /// How much of the colour below they hide, 0 to 1.
    pub opacity: f32,
    /// How rough their surface is, 0 to 1: dark cracks along the trunk.
    pub roughness: f32,
}

// The two are one in memory.
const _: () = {
    assert!(size_of::<tree_bark_patches>() == size_of::<Patches>());
    assert!(align_of::<tree_bark_patches>() == align_of::<Patches>());
    assert!(offset_of!(tree_bark_patches, color) == offset_of!(Patches, color));
    assert!(offset_of!(tree_bark_patches, count) == offset_of!(Patches, count));
    assert!(offset_of!(tree_bark_patches, share) == offset_of!(Patches, share));
    assert!(offset_of!(tree_bark_patches, softness) == offset_of!(Patches, softness));
    assert!(offset_of!(tree_bark_patches, opacity) == offset_of!(Patches, opacity));
    assert!(offset_of!(tree_bark_patches, roughness) == offset_of!(Patches, roughness));
};

impl tree_bark_patches {
    fn rust(&self) -> Patches {
        Patches {
            color: self.color,
            count: self.count,
            share: self.share,
            softness: self.softness,
            opacity: self.opacity,
            roughness: self.roughness,
        }
    }
}

/// What bark looks like. One tile of the texture is meant for 0.5 to 1 metre of trunk; counts are per
/// tile and 0 switches a layer off, so do strengths of 0. Begin with `tree_bark_style_init`, or with the
/// style of a built-in bark by `tree_bark_style_of`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_bark_style {
    /// `sizeof(tree_bark_style)`.
    pub struct_size: usize,
    /// Where the noise starts: another seed is another piece of the same bark. Default 0.
    pub seed: u64,
    /// Spots of another colour, drawn in order (lichen, peeling, old bark). Default none.
    pub patches: *const tree_bark_patches,
    /// Number of `patches`, at most 16.
    pub n_patches: usize,
    /// How much of `tint` is mixed in at most, 0 to 1. Default 0.3.
    pub tinting: f32,
    /// Plates across and along, 0 to 256. Default none.
    pub plates: [u32; 2],
    /// Width of the cracks between plates, in widths of a plate, 0 to 1. Default 0.2.
    pub crack: f32,
    /// How much brightness differs from plate to plate, 0 to 1. Default 0.15.
    pub plate_contrast: f32,
    /// Waves of the noise whose zero lines are furrows, across and along, 0 to 256. Default 8, 2.
    pub furrows: [u32; 2],
    /// Width of the furrows, as height of that noise, 0 to 1. Default 0.3.
    pub furrow_width: f32,
    /// Depth of the furrows, 0 to 1. Default 1.
    pub furrow_depth: f32,
    /// How ragged edges are, 0 to 1. Default 0.4.
    pub ragged: f32,
    /// How far points are shifted, in tiles, 0 to 0.5. Default 0.03.
    pub warp: f32,
    /// Strength of the flakes, thin layers with stepped edges, 0 to 1. Default 0.
    pub flakes: f32,
    /// Waves of the finest layer across and along, 0 to 256. Default 24, 12.
    pub grain: [u32; 2],
    /// Height of the grain, 0 to 1. Default 0.3.
    pub grain_height: f32,
    /// Rings around the trunk, waves along a tile, 0 to 256. Default 0.
    pub rings: u32,
    /// Strength of the rings, 0 to 1. Default 0.3.
    pub ring_contrast: f32,
    /// Strength of the baked light, 0 to 3. Default 1.
    pub relief: f32,
    /// Whether there are lenticels, short dark lines across the trunk, as on birch and cherry. Default no.
    pub has_lenticels: u32,
    /// With `has_lenticels`: places for one, across and along, 1 to 256. Default 5, 34.
    pub lenticel_count: [u32; 2],
    /// With `has_lenticels`: share of the places taken, 0 to 1. Default 0.45.
    pub lenticel_share: f32,
    /// With `has_lenticels`: length of the longest, in places, 0.01 to 1. Default 1.
    pub lenticel_length: f32,
    /// With `has_lenticels`: thickness of the thickest, in places, 0.01 to 1. Default 0.45.
    pub lenticel_thickness: f32,
    /// With `has_lenticels`: sRGB colour. Default a dark brown.
    pub lenticel_color: [u8; 3],
    /// sRGB colour of the ridges. Default a grey brown.
    pub ridge: [u8; 3],
    /// sRGB colour of the depths of cracks and furrows. Default a dark brown.
    pub furrow: [u8; 3],
    /// sRGB colour that slow noise mixes in. Default a greenish grey.
    pub tint: [u8; 3],
    /// Not used; 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_bark_style {
    const NAME: &'static str = "tree_bark_style";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&BarkStyle::default())
    }
}

impl tree_bark_style {
    /// A view of a style whose patches are constants, as those of this crate are.
    fn of(style: &BarkStyle) -> Self {
        let patches: &'static [Patches] = match style.patches {
            Cow::Borrowed(patches) => patches,
            Cow::Owned(_) => &[],
        };
        let lenticels = style.lenticels.unwrap_or(LENTICELS);
        Self {
            struct_size: size_of::<Self>(),
            seed: style.seed.0,
            patches: column(patches).cast(),
            n_patches: patches.len(),
            tinting: style.tinting,
            plates: style.plates,
            crack: style.crack,
            plate_contrast: style.plate_contrast,
            furrows: style.furrows,
            furrow_width: style.furrow_width,
            furrow_depth: style.furrow_depth,
            ragged: style.ragged,
            warp: style.warp,
            flakes: style.flakes,
            grain: style.grain,
            grain_height: style.grain_height,
            rings: style.rings,
            ring_contrast: style.ring_contrast,
            relief: style.relief,
            has_lenticels: style.lenticels.is_some().into(),
            lenticel_count: lenticels.count,
            lenticel_share: lenticels.share,
            lenticel_length: lenticels.length,
            lenticel_thickness: lenticels.thickness,
            lenticel_color: lenticels.color,
            ridge: style.ridge,
            furrow: style.furrow,
            tint: style.tint,
            reserved: 0,
        }
    }

    /// A copy, checked by whoever draws it.
    unsafe fn rust(&self) -> Result<BarkStyle> {
        let (limits, rows) = (small(), Resource::Nodes);
        let patches =
            unsafe { slice(self.patches, self.n_patches, &limits, rows, "style.patches") }?;
        let lenticels = Lenticels {
            color: self.lenticel_color,
            count: self.lenticel_count,
            share: self.lenticel_share,
            length: self.lenticel_length,
            thickness: self.lenticel_thickness,
        };
        Ok(BarkStyle {
            seed: Seed(self.seed),
            ridge: self.ridge,
            furrow: self.furrow,
            tint: self.tint,
            tinting: self.tinting,
            plates: self.plates,
            crack: self.crack,
            plate_contrast: self.plate_contrast,
            furrows: self.furrows,
            furrow_width: self.furrow_width,
            furrow_depth: self.furrow_depth,
            ragged: self.ragged,
            warp: self.warp,
            flakes: self.flakes,
            grain: self.grain,
            grain_height: self.grain_height,
            rings: self.rings,
            ring_contrast: self.ring_contrast,
            patches: patches.iter().map(tree_bark_patches::rust).collect(),
            lenticels: (self.has_lenticels != 0).then_some(lenticels),
            relief: self.relief,
        })
    }
}

/// Makes `style`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bark_style_init(
    style: *mut tree_bark_style,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(style, size) })
}

/// The style of a built-in bark, to be changed; what it points at is valid for ever. Set
/// `style->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bark_style_of(
    name: *const c_char,
    name_len: usize,
    style: *mut tree_bark_style,
) -> tree_status {
    call(|| {
        let found = bark_style(unsafe { text(name, name_len, "name") }?)?;
        unsafe { write(style, "style", &tree_bark_style::of(&found)) }
    })
}

/// Draws a bark of your own, which tiles without a seam; its name is `bark`. `style` may be NULL; `size` is
/// as for `tree_texture_bark`. Free the texture with `tree_texture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_texture_bark_with(
    style: *const tree_bark_style,
    size: u32,
    control: *const tree_control,
    texture: *mut *mut tree_texture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(texture, "texture") }?;
        let style = unsafe { read_or_default(style, "style")?.rust() }?;
        let size = if size == 0 { BARK_SIZE } else { size };
        let drawn = unsafe { draw(size, control, || Ok(bark_with(&style, size)?)) }?;
        place.put(tree_texture::new(drawn));
        Ok(())
    })
}
