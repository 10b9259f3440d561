//! Boxes with pictures on their planes.

use super::boxes::tree_leaf_boxes;
use super::card_params::{tree_card_params, tree_cards_report};
use super::map::{chosen, copied, show, tree_impostor_map};
use crate::border::{
    Handle, Shared, call, foresee, free, get, out, out_value, read_or_default, tree_status, view,
    write,
};
use crate::control::{run, tree_control};
use crate::lod::tree_elements;
use crate::mesh::tree_mesh;
use crate::preview::{tree_picture, tree_pixels};
use tree_lod::impostor::cards::Cards;
use tree_lod::preview::Picture;

/// Six diagonal planes for each box, with pictures of its leaves, in two atlases (Lluch et al. 2010, 4.2.2).
pub struct tree_cards(Shared<Cards>);

impl Handle for tree_cards {
    const NAME: &'static str = "tree_cards";
}

impl tree_cards {
    /// Cards that are part of something.
    pub(crate) fn part(held: Shared<Cards>) -> Self {
        Self(held)
    }

    pub(super) fn rust(&self) -> &Cards {
        self.0.get()
    }
}

/// Projects the leaves of every box onto its planes. `boxes`, which are copied, are those of `elements` of `mesh`.
/// `params` and `control` may be NULL, `report` when it is not wanted. Progress is told in the stage `cards`. The same
/// input gives the same bytes for any number of threads. Free the cards with `tree_cards_free`.
///
/// `TREE_ERROR_PARAMETER` also when the atlas would be wider than 16,384 texels, `TREE_ERROR_INVALID` when boxes,
/// elements and mesh do not belong together.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cards_bake(
    mesh: *const tree_mesh,
    elements: *const tree_elements,
    boxes: *const tree_leaf_boxes,
    params: *const tree_card_params,
    control: *const tree_control,
    report: *mut tree_cards_report,
    cards: *mut *mut tree_cards,
) -> tree_status {
    call(|| {
        let place = unsafe { out(cards, "cards") }?;
        unsafe { foresee(report.cast_const(), "report") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let elements = unsafe { get(elements, "elements") }?.rust();
        let boxes = unsafe { get(boxes, "boxes") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let body = |control: &_| Ok(Cards::bake(mesh, elements, boxes, &params, control)?);
        let made = unsafe { run(control, body) }?;
        let found = tree_cards_report::of(&made.report(), made.size());
        unsafe { view(report, "report", &found) }?;
        place.put(tree_cards(Shared::new(made)));
        Ok(())
    })
}

/// Tells what was baked. Set `report->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cards_measure(
    cards: *const tree_cards,
    report: *mut tree_cards_report,
) -> tree_status {
    call(|| {
        let cards = unsafe { get(cards, "cards") }?.rust();
        let found = tree_cards_report::of(&cards.report(), cards.size());
        unsafe { write(report, "report", &found) }
    })
}

/// The boxes of cards, nothing copied. Free them with `tree_leaf_boxes_free`; they keep the cards alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cards_boxes(
    cards: *const tree_cards,
    boxes: *mut *mut tree_leaf_boxes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(boxes, "boxes") }?;
        let cards = unsafe { get(cards, "cards") }?;
        place.put(tree_leaf_boxes::of(&cards.0));
        Ok(())
    })
}

/// Metres of a texel of the pictures of box `number`: the largest of its planes. `TREE_ERROR_INVALID` when there is no
/// such box.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cards_texel(
    cards: *const tree_cards,
    number: u32,
    metres: *mut f32,
) -> tree_status {
    call(|| {
        let found = unsafe { get(cards, "cards") }?.rust().texel(number)?;
        unsafe { out_value(metres, found, "metres") }
    })
}

/// Views the pixels of an atlas, nothing copied. `map` is a `TREE_IMPOSTOR_` constant; the depth of
/// `TREE_IMPOSTOR_DETAIL` goes from minus the `reach` of the plane to it, on the side that its normal points to. Set
/// `pixels->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cards_pixels(
    cards: *const tree_cards,
    map: tree_impostor_map,
    pixels: *mut tree_pixels,
) -> tree_status {
    call(|| {
        let cards = unsafe { get(cards, "cards") }?.rust();
        unsafe { show(chosen(map, &cards.color, &cards.detail)?, pixels) }
    })
}

/// A copy of an atlas, for `tree_picture_write_png`, `tree_picture_to_png` and `tree_mips_of_picture`. `map` is a
/// `TREE_IMPOSTOR_` constant. `control` may be NULL. Free the picture with `tree_picture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cards_picture(
    cards: *const tree_cards,
    map: tree_impostor_map,
    control: *const tree_control,
    picture: *mut *mut tree_picture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(picture, "picture") }?;
        let cards = unsafe { get(cards, "cards") }?.rust();
        let found = chosen(map, &cards.color, &cards.detail)?;
        place.put(unsafe { copied(found, control) }?);
        Ok(())
    })
}

/// A copy of the atlas of colours with light: the share of the sky that is seen through the leaves around, and softly by the
/// normal. `control` may be NULL. Free the picture with `tree_picture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cards_lit(
    cards: *const tree_cards,
    control: *const tree_control,
    picture: *mut *mut tree_picture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(picture, "picture") }?;
        let lit = unsafe { get(cards, "cards") }?.rust().lit();
        let (width, height, pixels) = (lit.width, lit.height, lit.pixels.clone());
        place.put(unsafe { copied(&Picture { width, height, pixels }, control) }?);
        Ok(())
    })
}

/// Frees cards, and with them all views of their pixels. Boxes and meshes made of them stay.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_cards_free(cards: *mut tree_cards) -> tree_status {
    call(|| unsafe { free(cards, "cards") })
}
