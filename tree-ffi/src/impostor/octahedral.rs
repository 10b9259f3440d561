//! A whole tree as pictures from all sides.

use super::map::{chosen, copied, show, tree_impostor_map};
use super::octahedral_meta::tree_octahedral_meta;
use super::octahedral_params::{tree_octahedral_params, tree_octahedral_report};
use crate::border::{
    Failure, Handle, call, foresee, free, get, out, out_value, read, read_or_default, tree_status,
    tree_str, view, write,
};
use crate::control::{run, tree_control};
use crate::io::tree_bytes;
use crate::lod::{TREE_SHADER_GLSL, TREE_SHADER_HLSL, TREE_SHADER_WGSL, tree_shader};
use crate::mesh::tree_mesh;
use crate::preview::{tree_mask, tree_picture, tree_pixels, tree_view};
use tree_lod::impostor::octahedral::{GLSL, HLSL, Octahedral, OctahedralReport, WGSL};
use tree_model::tree_core::{Control, Resource};

/// An octahedral impostor: a whole tree as pictures from all sides, with depths (Brucks 2018), for trees far away.
pub struct tree_octahedral(Octahedral);

impl Handle for tree_octahedral {
    const NAME: &'static str = "tree_octahedral";
}

/// Bakes all of a mesh, leaves and wood. `params` and `control` may be NULL, `report` when it is not wanted. Progress is
/// told in the stage `views`. The same input gives the same bytes for any number of threads. Free the impostor with
/// `tree_octahedral_free`.
///
/// `TREE_ERROR_INVALID` when nothing of the mesh can be seen or all of it is one point.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_bake(
    mesh: *const tree_mesh,
    params: *const tree_octahedral_params,
    control: *const tree_control,
    report: *mut tree_octahedral_report,
    octahedral: *mut *mut tree_octahedral,
) -> tree_status {
    call(|| {
        let place = unsafe { out(octahedral, "octahedral") }?;
        unsafe { foresee(report.cast_const(), "report") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let made =
            unsafe { run(control, |control| Ok(Octahedral::bake(mesh, &params, control)?)) }?;
        unsafe { view(report, "report", &tree_octahedral_report::of(&made.report)) }?;
        place.put(tree_octahedral(made));
        Ok(())
    })
}

/// An impostor that was baked before: its numbers and its two pictures, which are copied. `control` may be NULL; `pixels`
/// of its limits caps those of both. What `tree_octahedral_measure` tells of it is 0, but for the bytes. Free it with
/// `tree_octahedral_free`. `TREE_ERROR_PARAMETER` or `TREE_ERROR_INVALID` when the parts do not fit each other.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_from_pictures(
    meta: *const tree_octahedral_meta,
    color: *const tree_picture,
    detail: *const tree_picture,
    control: *const tree_control,
    octahedral: *mut *mut tree_octahedral,
) -> tree_status {
    call(|| {
        let place = unsafe { out(octahedral, "octahedral") }?;
        let meta = unsafe { read(meta, "meta") }?.rust();
        let color = unsafe { get(color, "color") }?.rust();
        let detail = unsafe { get(detail, "detail") }?.rust();
        let bytes = color.pixels.len() + detail.pixels.len();
        let body = |control: &Control| {
            control.check()?;
            control.limits.check(Resource::Pixels, bytes as u64 / 4)?;
            let report = OctahedralReport { bytes, ..OctahedralReport::default() };
            let made = Octahedral { meta, color: color.clone(), detail: detail.clone(), report };
            made.check()?;
            Ok(made)
        };
        place.put(tree_octahedral(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Tells what was baked. Set `report->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_measure(
    octahedral: *const tree_octahedral,
    report: *mut tree_octahedral_report,
) -> tree_status {
    call(|| {
        let found = &unsafe { get(octahedral, "octahedral") }?.0.report;
        unsafe { write(report, "report", &tree_octahedral_report::of(found)) }
    })
}

/// The numbers that go with the pictures. Set `meta->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_describe(
    octahedral: *const tree_octahedral,
    meta: *mut tree_octahedral_meta,
) -> tree_status {
    call(|| {
        let found = &unsafe { get(octahedral, "octahedral") }?.0.meta;
        unsafe { write(meta, "meta", &tree_octahedral_meta::of(found)) }
    })
}

/// The numbers that go with the pictures as JSON, to be stored beside them; they are read as the same bits. Free the
/// bytes with `tree_bytes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_to_json(
    octahedral: *const tree_octahedral,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let meta = &unsafe { get(octahedral, "octahedral") }?.0.meta;
        place.put(tree_bytes::new(meta.to_json().into_bytes()));
        Ok(())
    })
}

/// Views the pixels of one of the two pictures, nothing copied. `map` is a `TREE_IMPOSTOR_` constant; the depth of
/// `TREE_IMPOSTOR_DETAIL` goes from minus the `radius` to it, towards the viewer. Set `pixels->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_pixels(
    octahedral: *const tree_octahedral,
    map: tree_impostor_map,
    pixels: *mut tree_pixels,
) -> tree_status {
    call(|| {
        let found = &unsafe { get(octahedral, "octahedral") }?.0;
        unsafe { show(chosen(map, &found.color, &found.detail)?, pixels) }
    })
}

/// A copy of one of the two pictures, for `tree_picture_write_png`, `tree_picture_to_png` and `tree_mips_of_picture`.
/// `map` is a `TREE_IMPOSTOR_` constant. `control` may be NULL. Free the picture with `tree_picture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_picture(
    octahedral: *const tree_octahedral,
    map: tree_impostor_map,
    control: *const tree_control,
    picture: *mut *mut tree_picture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(picture, "picture") }?;
        let found = &unsafe { get(octahedral, "octahedral") }?.0;
        let found = chosen(map, &found.color, &found.detail)?;
        place.put(unsafe { copied(found, control) }?);
        Ok(())
    })
}

/// What a camera sees, by one ray for each pixel: sRGB colour without light, and alpha, to be tested against
/// one half. It is what the shaders draw, for checking them. The camera of `view` must be `TREE_CAMERA_PLACED`
/// (`tree_view_place` helps); for a framed one `TREE_ERROR_INVALID`. `control` may be NULL. Free the picture with
/// `tree_picture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_view(
    octahedral: *const tree_octahedral,
    view: *const tree_view,
    control: *const tree_control,
    picture: *mut *mut tree_picture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(picture, "picture") }?;
        let found = &unsafe { get(octahedral, "octahedral") }?.0;
        let view = unsafe { tree_view::read(view) }?;
        let body = |control: &_| Ok(found.view(&view.camera, view.width, view.height, control)?);
        place.put(tree_picture::new(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Alpha alone, as `tree_octahedral_view`. Free the mask with `tree_mask_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_mask(
    octahedral: *const tree_octahedral,
    view: *const tree_view,
    control: *const tree_control,
    mask: *mut *mut tree_mask,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mask, "mask") }?;
        let found = &unsafe { get(octahedral, "octahedral") }?.0;
        let view = unsafe { tree_view::read(view) }?;
        let body = |control: &_| Ok(found.mask(&view.camera, view.width, view.height, control)?);
        place.put(tree_mask::new(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// The functions that draw an octahedral impostor in a shader, as `tree_octahedral_view` does it: text to be put into your
/// own. It tells what they take and where it comes from. `language` is a `TREE_SHADER_` constant. The text is never
/// freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_shader(
    language: tree_shader,
    text: *mut tree_str,
) -> tree_status {
    call(|| {
        let found = match language {
            TREE_SHADER_WGSL => WGSL,
            TREE_SHADER_GLSL => GLSL,
            TREE_SHADER_HLSL => HLSL,
            other => return Err(Failure::not_one_of("language", other, "TREE_SHADER_")),
        };
        unsafe { out_value(text, tree_str::of(found), "text") }
    })
}

/// Frees an impostor, and with it all views of its pixels.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_free(octahedral: *mut tree_octahedral) -> tree_status {
    call(|| unsafe { free(octahedral, "octahedral") })
}
