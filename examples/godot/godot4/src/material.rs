//! From the library's materials and pictures to Godot's.

use crate::native::{Failure, Mesh, Result, Texture};
use godot::classes::base_material_3d::{
    CullMode, Feature, TextureFilter, TextureParam, Transparency,
};
use godot::classes::image::Format;
use godot::classes::{Image, ImageTexture, StandardMaterial3D};
use godot::prelude::*;

pub(crate) fn material(mesh: &Mesh, number: usize) -> Result<Gd<StandardMaterial3D>> {
    let from = mesh.material(number)?;
    let mut made = StandardMaterial3D::new_gd();
    let [r, g, b, a] = from.base_color;
    // Godot takes material colours for sRGB.
    made.set_albedo(Color::from_rgba(r, g, b, a).linear_to_srgb());
    made.set_roughness(from.roughness);
    made.set_texture_filter(TextureFilter::LINEAR_WITH_MIPMAPS_ANISOTROPIC);
    if from.alpha == tree_ffi::TREE_ALPHA_MASK {
        made.set_transparency(Transparency::ALPHA_SCISSOR);
        made.set_alpha_scissor_threshold(from.alpha_cutoff);
    }
    if from.double_sided != 0 {
        made.set_cull_mode(CullMode::DISABLED);
    }
    if from.translucency > 0.0 {
        let share = from.translucency;
        made.set_feature(Feature::BACKLIGHT, true);
        made.set_backlight(Color::from_rgb(share, share, share));
    }
    if let Some(texture) = mesh.texture(number)? {
        made.set_texture(TextureParam::ALBEDO, &picture(&texture)?);
    }
    Ok(made)
}

fn picture(texture: &Texture) -> Result<Gd<ImageTexture>> {
    let (width, height, pixels) = texture.pixels()?;
    let refused = || Failure::new("Godot takes no picture of this size");
    let (Ok(width), Ok(height)) = (i32::try_from(width), i32::try_from(height)) else {
        return Err(refused());
    };
    let pixels = PackedByteArray::from(pixels);
    let image = Image::create_from_data(width, height, false, Format::RGBA8, &pixels);
    let mut image = image.ok_or_else(refused)?;
    image.generate_mipmaps();
    ImageTexture::create_from_image(&image).ok_or_else(refused)
}
