//! Drawings of outlines, as they come in.

use super::drawn::{from_drawn, tree_drawn_stroke};
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_INVALID, TREE_ERROR_PARAMETER, Versioned, call, free, get,
    out, out_value, read_rows, text, tree_status, tree_str, write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use crate::photo::{tree_lines, tree_matte, tree_photo};
use crate::sketch::drawing::at;
use crate::sketch::{ask_to_parse, document, in_document};
use std::ffi::c_char;
use std::sync::Arc;
use tree_model::silhouette::read::{
    LevelStroke, OutlineDrawing, ReadRepair, TreeStrokes, from_mask, from_photo, from_svg, matte_of,
};
use tree_model::tree_core::Resource;

/// Most strokes of one call.
const STROKES_MAX: usize = 1 << 20;

/// What was repaired or noticed in a drawing: a `TREE_DRAWN_` constant. New ones may be added.
pub type tree_drawn_repair_kind = u32;

/// `count` shapes outside all layers, or outside the groups of trees, were left out.
pub const TREE_DRAWN_STRAY_SHAPES: u32 = 0;
/// `count` open lines beside filled shapes were left out.
pub const TREE_DRAWN_LINES_DROPPED: u32 = 1;
/// A trunk drawn as an area became its middle line.
pub const TREE_DRAWN_TRUNK_THINNED: u32 = 2;
/// A shape as large as the drawing was left out as its background.
pub const TREE_DRAWN_BACKGROUND_DROPPED: u32 = 3;
/// `count` parts near the tree were joined to it.
pub const TREE_DRAWN_PARTS_BRIDGED: u32 = 4;
/// `count` parts far from the tree, or too small, a `share` of the area, were left out.
pub const TREE_DRAWN_PARTS_DROPPED: u32 = 5;
/// Holes, a `share` of the area, were filled.
pub const TREE_DRAWN_HOLES_FILLED: u32 = 6;
/// Gaps in a frayed crown were closed, the widest of `width` in units of the drawing.
pub const TREE_DRAWN_GAPS_CLOSED: u32 = 7;
/// No trunk was seen: the silhouette is all crown.
pub const TREE_DRAWN_NO_TRUNK: u32 = 8;
/// A tree of which nothing could be used was left out.
pub const TREE_DRAWN_TREE_DROPPED: u32 = 9;
/// Something else: `tree_outline_drawing_repairs_text` says what.
pub const TREE_DRAWN_OTHER: u32 = 10;

/// One thing that was repaired or noticed in a drawing. Fields that its kind does not name are 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct tree_drawn_repair {
    /// What it was.
    pub kind: tree_drawn_repair_kind,
    /// How many there were.
    pub count: u32,
    /// A share, 0 to 1.
    pub share: f32,
    /// A length in units of the drawing.
    pub width: f32,
}

impl tree_drawn_repair {
    fn of(repair: &ReadRepair) -> Self {
        use ReadRepair as R;
        let plain = |kind| Self { kind, ..Self::default() };
        let many = |kind, count: usize| Self { count: count as u32, ..plain(kind) };
        match *repair {
            R::StrayShapes { count } => many(TREE_DRAWN_STRAY_SHAPES, count),
            R::LinesDropped { count } => many(TREE_DRAWN_LINES_DROPPED, count),
            R::TrunkThinned { .. } => plain(TREE_DRAWN_TRUNK_THINNED),
            R::BackgroundDropped => plain(TREE_DRAWN_BACKGROUND_DROPPED),
            R::PartsBridged { count } => many(TREE_DRAWN_PARTS_BRIDGED, count),
            R::PartsDropped { count, share } => {
                Self { share, ..many(TREE_DRAWN_PARTS_DROPPED, count) }
            }
            R::HolesFilled { share } => Self { share, ..plain(TREE_DRAWN_HOLES_FILLED) },
            R::GapsClosed { width } => Self { width, ..plain(TREE_DRAWN_GAPS_CLOSED) },
            R::NoTrunk => plain(TREE_DRAWN_NO_TRUNK),
            R::TreeDropped { .. } => plain(TREE_DRAWN_TREE_DROPPED),
            _ => plain(TREE_DRAWN_OTHER),
        }
    }
}

/// A drawing of outlines: the strokes of one tree or several, each of a level. Nothing is scaled: coordinates are those of
/// the drawing or pixels, y downwards.
pub struct tree_outline_drawing {
    drawing: Arc<OutlineDrawing>,
    repairs: Vec<tree_drawn_repair>,
}

impl Handle for tree_outline_drawing {
    const NAME: &'static str = "tree_outline_drawing";
}

impl tree_outline_drawing {
    pub(crate) fn new(drawing: OutlineDrawing) -> Self {
        let repairs = drawing.repairs.iter().map(tree_drawn_repair::of).collect();
        Self { drawing: Arc::new(drawing), repairs }
    }

    pub(crate) fn rust(&self) -> &OutlineDrawing {
        &self.drawing
    }
}

/// Makes a drawing of one tree of strokes, which are copied: one at least, in the order they were drawn. `name`, of
/// `name_len` bytes or `TREE_NUL_TERMINATED`, is the tree's, NULL for none; `trunk_width` is the trunk's in units of the drawing,
/// 0 where it is not known. `control` may be NULL; `nodes` of its limits caps the points of all strokes. Free the drawing
/// with `tree_outline_drawing_free`. `TREE_ERROR_INVALID` names a point that is not finite.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_drawing_new(
    strokes: *const tree_drawn_stroke,
    n_strokes: usize,
    name: *const c_char,
    name_len: usize,
    trunk_width: f32,
    control: *const tree_control,
    drawing: *mut *mut tree_outline_drawing,
) -> tree_status {
    call(|| {
        let place = unsafe { out(drawing, "drawing") }?;
        let strokes = unsafe { self::strokes(strokes, n_strokes, control) }?;
        let name = if name.is_null() { "" } else { unsafe { text(name, name_len, "name") }? };
        if !(trunk_width >= 0.0 && trunk_width.is_finite()) {
            let text = format!("trunk_width is {trunk_width}, allowed is 0 or more and finite");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        let trunk_width = (trunk_width > 0.0).then_some(trunk_width);
        let tree = TreeStrokes { name: name.to_owned(), strokes, trunk_width };
        let made = OutlineDrawing { trees: vec![tree], repairs: Vec::new() };
        place.put(tree_outline_drawing::new(made));
        Ok(())
    })
}

/// A caller's strokes, copied.
unsafe fn strokes(
    first: *const tree_drawn_stroke,
    n: usize,
    control: *const tree_control,
) -> Result<Vec<LevelStroke>> {
    let limits = unsafe { limits(control) }?;
    let rows = unsafe { read_rows(first, n, STROKES_MAX, "strokes") }?;
    if rows.is_empty() {
        let text = "n_strokes is 0: a drawing needs one stroke at least";
        return Err(Failure::new(TREE_ERROR_INVALID, text));
    }
    let points = rows.iter().fold(0_u64, |sum, row| sum.saturating_add(row.n_points as u64));
    limits.check(Resource::Nodes, points)?;
    let stroke = |(i, row): (usize, &tree_drawn_stroke)| unsafe {
        from_drawn(row, &limits, &format!("strokes[{i}]"))
    };
    rows.iter().enumerate().map(stroke).collect()
}

/// Reads outlines from an SVG drawing: `svg` of `len` bytes or `TREE_NUL_TERMINATED`. What is not seen is left out.
///
/// Layers are groups, or single shapes, by id, class, layer label or name: `L0`, `L1`, `L2` and so on, and `leaf`. `L0@90` is
/// drawn in a plane turned about the trunk by so many degrees. In `L0`, what is named *trunk* or *stem*, and an open line,
/// is the trunk; what is closed or filled is the crown. In other layers what is closed or filled is the outline of a
/// branch, and an open line a branch redrawn. Groups named `tree`, `tree1`, `tree-oak` hold one tree each.
///
/// Without layers what is filled is one silhouette for each tree: its trunk is what is named so, or what is brown where
/// something else is green, or the narrow part above the foot; the rest is its crown.
///
/// `control` may be NULL; only its limits matter. Free the drawing with `tree_outline_drawing_free`. `TREE_ERROR_FORMAT` when
/// the text is no SVG, draws nothing, or nothing of it is a tree.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_drawing_from_svg(
    svg: *const c_char,
    len: usize,
    control: *const tree_control,
    drawing: *mut *mut tree_outline_drawing,
) -> tree_status {
    call(|| {
        let place = unsafe { out(drawing, "drawing") }?;
        let text = unsafe { document(svg, len, &limits(control)?, "svg") }?;
        ask_to_parse(text)?;
        let made = unsafe { run(control, |_| from_svg(text).map_err(in_document)) }?;
        place.put(tree_outline_drawing::new(made));
        Ok(())
    })
}

/// Trunk and crown of the tree that a matte shows, in pixels, y downwards. Pixels covered to `threshold` or more belong to
/// it, 0.01 to 1; 0.5 is usual. Fine details are smoothed away and the gaps of a frayed crown closed, so that the outline is
/// one that can be drawn: at most 400 points. `control` may be NULL. Free the drawing with `tree_outline_drawing_free`.
/// `TREE_ERROR_INVALID` where nothing is covered.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_drawing_of_matte(
    matte: *const tree_matte,
    threshold: f32,
    control: *const tree_control,
    drawing: *mut *mut tree_outline_drawing,
) -> tree_status {
    call(|| {
        let place = unsafe { out(drawing, "drawing") }?;
        let matte = unsafe { get(matte, "matte") }?.rust();
        let made = unsafe { run(control, |_| Ok(from_mask(matte, threshold)?)) }?;
        place.put(tree_outline_drawing::new(made));
        Ok(())
    })
}

/// As `tree_outline_drawing_of_matte`, of a photograph that has been cut out, or of a mask in black and white: a half of
/// `tree_photo_mask`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_drawing_of_photo(
    photo: *const tree_photo,
    control: *const tree_control,
    drawing: *mut *mut tree_outline_drawing,
) -> tree_status {
    call(|| {
        let place = unsafe { out(drawing, "drawing") }?;
        let photo = unsafe { get(photo, "photo") }?.rust();
        let made = unsafe { run(control, |_| Ok(from_photo(photo)?)) }?;
        place.put(tree_outline_drawing::new(made));
        Ok(())
    })
}

/// The matte of a picture of one tree: its alpha where it has one; else how dark it is, for a tree on a light border, or how
/// light, for one on a dark border. `control` may be NULL. Free the matte with `tree_matte_free`. `TREE_ERROR_NO_RESULT` where
/// the picture is transparent everywhere.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_mask(
    photo: *const tree_photo,
    control: *const tree_control,
    matte: *mut *mut tree_matte,
) -> tree_status {
    call(|| {
        let place = unsafe { out(matte, "matte") }?;
        let photo = unsafe { get(photo, "photo") }?.rust();
        place.put(tree_matte::new(unsafe { run(control, |_| Ok(matte_of(photo)?)) }?));
        Ok(())
    })
}

/// Number of trees, one at least.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_drawing_count(
    drawing: *const tree_outline_drawing,
    n_trees: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { get(drawing, "drawing") }?.rust().trees.len();
        unsafe { out_value(n_trees, n, "n_trees") }
    })
}

/// A view of one tree of a drawing.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_drawn_tree {
    /// `sizeof(tree_drawn_tree)`.
    pub struct_size: usize,
    /// Its name in the drawing; empty where it has none.
    pub name: tree_str,
    /// Number of strokes, one at least.
    pub n_strokes: usize,
    /// Width of the trunk in units of the drawing, where it was drawn as an area; else 0.
    pub trunk_width: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_drawn_tree {
    const NAME: &'static str = "tree_drawn_tree";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            name: tree_str::EMPTY,
            n_strokes: 0,
            trunk_width: 0.0,
            reserved: 0,
        }
    }
}

/// Views a tree of a drawing. `index` is below `tree_outline_drawing_count`. Set `tree->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_drawing_tree(
    drawing: *const tree_outline_drawing,
    index: usize,
    tree: *mut tree_drawn_tree,
) -> tree_status {
    call(|| {
        let found = at(&unsafe { get(drawing, "drawing") }?.rust().trees, index, "trees")?;
        let found = tree_drawn_tree {
            name: tree_str::of(&found.name),
            n_strokes: found.strokes.len(),
            trunk_width: found.trunk_width.unwrap_or(0.0),
            ..Versioned::default_value()
        };
        unsafe { write(tree, "tree", &found) }
    })
}

/// Views a stroke of tree `number` of a drawing. `index` is below the tree's `n_strokes`. Set `stroke->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_drawing_stroke(
    drawing: *const tree_outline_drawing,
    number: usize,
    index: usize,
    stroke: *mut tree_drawn_stroke,
) -> tree_status {
    call(|| {
        let trees = &unsafe { get(drawing, "drawing") }?.rust().trees;
        let found = at(&at(trees, number, "trees")?.strokes, index, "strokes")?;
        unsafe { write(stroke, "stroke", &tree_drawn_stroke::of(found)) }
    })
}

/// Views what was repaired or noticed when the drawing was read: where the repairs begin and how many there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_drawing_repairs(
    drawing: *const tree_outline_drawing,
    repairs: *mut *const tree_drawn_repair,
    n_repairs: *mut usize,
) -> tree_status {
    call(|| {
        let found = &unsafe { get(drawing, "drawing") }?.repairs;
        unsafe { out_value(repairs, column(found), "repairs") }?;
        unsafe { out_value(n_repairs, found.len(), "n_repairs") }
    })
}

/// A sentence for each repair. Free the lines with `tree_lines_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_drawing_repairs_text(
    drawing: *const tree_outline_drawing,
    lines: *mut *mut tree_lines,
) -> tree_status {
    call(|| {
        let place = unsafe { out(lines, "lines") }?;
        let repairs = &unsafe { get(drawing, "drawing") }?.rust().repairs;
        place.put(tree_lines::new(repairs.iter().map(ToString::to_string).collect()));
        Ok(())
    })
}

/// Frees a drawing of outlines. What was made of it lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_drawing_free(
    drawing: *mut tree_outline_drawing,
) -> tree_status {
    call(|| unsafe { free(drawing, "drawing") })
}
