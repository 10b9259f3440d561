//! Pictures that materials wrap on surfaces.

use crate::border::{
    self, Handle, Result, Versioned, bytes, call, free, get, out, read, slice, text, tree_status,
    tree_str, view, write,
};
use crate::control::{limits, run, tree_control};
use crate::io::tree_bytes;
use crate::mesh::column;
use ::tree_mesh::Texture;
use ::tree_mesh::texture::{self, LeafTexture};
use std::ffi::c_char;
use std::sync::Arc;
use tree_model::tree_core::{Limits, Resource};

/// A picture, shared by materials and meshes: RGBA, 8 bits, sRGB, straight alpha.
pub struct tree_texture(Arc<Texture>);

impl Handle for tree_texture {
    const NAME: &'static str = "tree_texture";
}

impl tree_texture {
    pub(crate) fn new(texture: Texture) -> Self {
        Self(Arc::new(texture))
    }

    /// One more handle of a texture.
    pub(crate) fn shared(texture: Arc<Texture>) -> Self {
        Self(texture)
    }

    pub(crate) fn rust(&self) -> &Arc<Texture> {
        &self.0
    }
}

/// A picture's name and pixels: as input, or as a view of a `tree_texture`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_texture_pixels {
    /// `sizeof(tree_texture_pixels)`.
    pub struct_size: usize,
    /// Name for people and files, without extension.
    pub name: tree_str,
    /// `4 * width * height` bytes: red, green, blue and alpha in sRGB with straight alpha, rows from top
    /// to bottom.
    pub pixels: *const u8,
    /// Width in pixels, 1 or more.
    pub width: u32,
    /// Height in pixels, 1 or more.
    pub height: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_texture_pixels {
    const NAME: &'static str = "tree_texture_pixels";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            name: tree_str::EMPTY,
            pixels: std::ptr::null(),
            width: 0,
            height: 0,
        }
    }
}

impl tree_texture_pixels {
    /// A checked copy.
    unsafe fn rust(&self, limits: &Limits) -> Result<Texture> {
        let n = u64::from(self.width) * u64::from(self.height);
        // What memory does not address is beyond the limits too.
        let n = usize::try_from(n).unwrap_or(usize::MAX);
        let argument = "pixels.pixels";
        let pixels: &[[u8; 4]] =
            unsafe { slice(self.pixels.cast(), n, limits, Resource::Pixels, argument) }?;
        let texture = Texture {
            name: unsafe { self.name.get("pixels.name") }?.to_owned(),
            width: self.width,
            height: self.height,
            pixels: pixels.as_flattened().to_vec(),
        };
        texture.check()?;
        Ok(texture)
    }
}

/// Makes a texture of pixels, which are copied. `control` may be NULL; only its limits matter. Free the
/// texture with `tree_texture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_texture_from_pixels(
    pixels: *const tree_texture_pixels,
    control: *const tree_control,
    texture: *mut *mut tree_texture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(texture, "texture") }?;
        let pixels = unsafe { read(pixels, "pixels") }?;
        place.put(tree_texture::new(unsafe { pixels.rust(&limits(control)?) }?));
        Ok(())
    })
}

/// Makes a texture of a PNG or JPEG file in memory, recognised by its content. A photograph is turned
/// upright as its camera noted. `TREE_ERROR_LIMIT` when file or picture are larger than the limits
/// `input_bytes` and `pixels` allow, before it is decoded. Free the texture with `tree_texture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_texture_from_bytes(
    name: *const c_char,
    name_len: usize,
    data: *const u8,
    len: usize,
    control: *const tree_control,
    texture: *mut *mut tree_texture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(texture, "texture") }?;
        let name = unsafe { text(name, name_len, "name") }?;
        let data = unsafe { bytes(data, len, &limits(control)?, "data") }?;
        let decoded =
            unsafe { run(control, |control| Ok(Texture::decode(name, data, &control.limits)?)) }?;
        place.put(tree_texture::new(decoded));
        Ok(())
    })
}

/// As `tree_texture_from_bytes`, of a file on disk. The texture is named after the file. Free it with
/// `tree_texture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_texture_read(
    path: *const c_char,
    path_len: usize,
    control: *const tree_control,
    texture: *mut *mut tree_texture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(texture, "texture") }?;
        let path = unsafe { border::path(path, path_len, "path") }?;
        let opened = unsafe { run(control, |control| Ok(Texture::open(path, &control.limits)?)) }?;
        place.put(tree_texture::new(opened));
        Ok(())
    })
}

/// Draws a built-in bark, which tiles without a seam; `tree_bark_names` has the names. `size` is width and
/// height in pixels, 16 to 4096, or 0 for 512. Free the texture with `tree_texture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_texture_bark(
    name: *const c_char,
    name_len: usize,
    size: u32,
    control: *const tree_control,
    texture: *mut *mut tree_texture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(texture, "texture") }?;
        let name = unsafe { text(name, name_len, "name") }?;
        let drawn = unsafe {
            draw(size, control, || match size {
                0 => Ok(texture::bark(name)?),
                size => Ok(texture::bark_sized(name, size)?),
            })
        }?;
        place.put(tree_texture::new(drawn));
        Ok(())
    })
}

/// How a picture of a leaf goes on a card.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_leaf_card {
    /// `sizeof(tree_leaf_card)`.
    pub struct_size: usize,
    /// Width of the card per length from base to apex: `width` of `tree_leaf_look`.
    pub width: f32,
    /// Share of the height, from the base, that is stalk (for a spray: bare twig), 0 to 1.
    pub petiole: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_leaf_card {
    const NAME: &'static str = "tree_leaf_card";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self { struct_size: size_of::<Self>(), width: 1.0, petiole: 0.0 }
    }
}

impl tree_leaf_card {
    pub(crate) fn of(leaf: &LeafTexture) -> Self {
        Self { width: leaf.width, petiole: leaf.petiole, ..Self::default_value() }
    }
}

/// Draws a built-in leaf, upright with the base at the bottom centre; `tree_leaf_names` has the names.
/// Transparent pixels carry the colour of the leaf near them; meant for an alpha cutoff of 0.5. `size` is
/// width and height in pixels, 16 to 4096, or 0 for 256, and 512 for clusters, needles and fronds. `card`
/// says how to put it on a card; it may be NULL. Free the texture with `tree_texture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_texture_leaf(
    name: *const c_char,
    name_len: usize,
    size: u32,
    control: *const tree_control,
    card: *mut tree_leaf_card,
    texture: *mut *mut tree_texture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(texture, "texture") }?;
        let name = unsafe { text(name, name_len, "name") }?;
        let drawn = unsafe {
            draw(size, control, || match size {
                0 => Ok(texture::leaf(name)?),
                size => Ok(texture::leaf_sized(name, size)?),
            })
        }?;
        unsafe { view(card, "card", &tree_leaf_card::of(&drawn)) }?;
        place.put(tree_texture::new(drawn.texture));
        Ok(())
    })
}

/// Draws a picture of `size` pixels each way, if the limits allow it.
pub(super) unsafe fn draw<R: Send>(
    size: u32,
    control: *const tree_control,
    draw: impl FnOnce() -> Result<R> + Send,
) -> Result<R> {
    unsafe {
        run(control, |control| {
            let size = if size == 0 { texture::SPRAY_SIZE } else { size };
            control.limits.check(Resource::Pixels, u64::from(size) * u64::from(size))?;
            draw()
        })
    }
}

/// Views a texture's name and pixels. Set `pixels->struct_size` first. Valid until the texture is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_texture_view(
    texture: *const tree_texture,
    pixels: *mut tree_texture_pixels,
) -> tree_status {
    call(|| {
        let texture = unsafe { get(texture, "texture") }?.rust();
        let viewed = tree_texture_pixels {
            name: tree_str::of(&texture.name),
            pixels: column(&texture.pixels),
            width: texture.width,
            height: texture.height,
            ..tree_texture_pixels::default_value()
        };
        unsafe { write(pixels, "pixels", &viewed) }
    })
}

/// Makes a PNG file in memory of a texture. Free it with `tree_bytes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_texture_to_png(
    texture: *const tree_texture,
    png: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(png, "png") }?;
        place.put(tree_bytes::new(unsafe { get(texture, "texture") }?.rust().to_png()?));
        Ok(())
    })
}

/// Writes a texture as a PNG file, whole or not at all.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_texture_write_png(
    texture: *const tree_texture,
    path: *const c_char,
    path_len: usize,
) -> tree_status {
    call(|| {
        let texture = unsafe { get(texture, "texture") }?.rust();
        Ok(texture.save_png(unsafe { border::path(path, path_len, "path") }?)?)
    })
}

/// Frees a texture's handle. Materials and meshes that have the picture keep it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_texture_free(texture: *mut tree_texture) -> tree_status {
    call(|| unsafe { free(texture, "texture") })
}
