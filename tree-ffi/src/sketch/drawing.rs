//! Drawings: strokes as they come in.

use super::{ask_to_parse, document, in_document};
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_PARAMETER, Versioned, call, free, get, out, out_value,
    read_rows, tree_status, tree_str, vec2s, write,
};
use crate::control::{limits, run, tree_control};
use crate::io::tree_bytes;
use crate::mesh::column;
use std::ffi::c_char;
use std::sync::Arc;
use tree_model::sketch::read::{from_json, from_ndjson, from_svg, to_json};
use tree_model::sketch::{Drawing, Role, Stroke};
use tree_model::tree_core::{Limits, Resource};

/// Most strokes of one call.
const STROKES_MAX: usize = 1 << 20;

/// What a stroke shows: a `TREE_ROLE_` constant.
pub type tree_role = u32;

/// Not said: cleaning is to find out.
pub const TREE_ROLE_UNKNOWN: u32 = 0;
/// The trunk. It begins the tree.
pub const TREE_ROLE_TRUNK: u32 = 1;
/// A branch.
pub const TREE_ROLE_BRANCH: u32 = 2;
/// The crown's outline, or a piece of it.
pub const TREE_ROLE_CROWN: u32 = 3;

/// The constant of a role.
pub(crate) fn role_of(role: Option<Role>) -> tree_role {
    match role {
        None => TREE_ROLE_UNKNOWN,
        Some(Role::Trunk) => TREE_ROLE_TRUNK,
        Some(Role::Branch) => TREE_ROLE_BRANCH,
        Some(Role::Crown) => TREE_ROLE_CROWN,
    }
}

fn role(found: tree_role, argument: &str) -> Result<Option<Role>> {
    Ok(match found {
        TREE_ROLE_UNKNOWN => None,
        TREE_ROLE_TRUNK => Some(Role::Trunk),
        TREE_ROLE_BRANCH => Some(Role::Branch),
        TREE_ROLE_CROWN => Some(Role::Crown),
        other => return Err(Failure::not_one_of(argument, other, "TREE_ROLE_")),
    })
}

/// One line of a drawing: as input, or as a view of a `tree_drawing`. Zeros are its defaults. Set `struct_size`
/// first.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sketch_stroke {
    /// `sizeof(tree_sketch_stroke)`.
    pub struct_size: usize,
    /// Number of points.
    pub n_points: usize,
    /// Two floats for each point, in the drawing's own units, y downwards as on screens. Points that are not
    /// finite are taken: cleaning leaves them out and says so.
    pub points: *const f32,
    /// What messages call it besides its number. Default empty.
    pub name: tree_str,
    /// What it shows. Default `TREE_ROLE_UNKNOWN`.
    pub role: tree_role,
    /// Whether its end is joined to its beginning.
    pub closed: u32,
    /// Whether it is the outline of a filled area rather than a line: of a branch so drawn the middle line is
    /// meant.
    pub filled: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_sketch_stroke {
    const NAME: &'static str = "tree_sketch_stroke";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_points: 0,
            points: std::ptr::null(),
            name: tree_str::EMPTY,
            role: TREE_ROLE_UNKNOWN,
            closed: 0,
            filled: 0,
            reserved: 0,
        }
    }
}

impl tree_sketch_stroke {
    /// A view of `stroke`.
    pub(crate) fn of(stroke: &Stroke) -> Self {
        Self {
            n_points: stroke.points.len(),
            points: column(&stroke.points).cast(),
            name: tree_str::of(&stroke.name),
            role: role_of(stroke.role),
            closed: stroke.closed.into(),
            filled: stroke.filled.into(),
            ..Self::default_value()
        }
    }

    /// The stroke, copied.
    ///
    /// # Safety
    /// What it points at is as long as it says.
    pub(crate) unsafe fn rust(&self, limits: &Limits, argument: &str) -> Result<Stroke> {
        let part = |field: &str| format!("{argument}.{field}");
        let (n, nodes) = (self.n_points, Resource::Nodes);
        Ok(Stroke {
            points: unsafe { vec2s(self.points, n, limits, nodes, &part("points")) }?.to_vec(),
            role: role(self.role, &part("role"))?,
            closed: self.closed != 0,
            filled: self.filled != 0,
            name: unsafe { self.name.get(&part("name")) }?.to_owned(),
        })
    }
}

/// A caller's strokes, copied.
///
/// # Safety
/// As [`read_rows`].
pub(crate) unsafe fn strokes(
    first: *const tree_sketch_stroke,
    n: usize,
    limits: &Limits,
) -> Result<Vec<Stroke>> {
    let rows = unsafe { read_rows(first, n, STROKES_MAX, "strokes") }?;
    let points = rows.iter().fold(0_u64, |sum, row| sum.saturating_add(row.n_points as u64));
    limits.check(Resource::Nodes, points)?;
    let stroke = |(i, row): (usize, &tree_sketch_stroke)| unsafe {
        row.rust(limits, &format!("strokes[{i}]"))
    };
    rows.iter().enumerate().map(stroke).collect()
}

/// A drawing: strokes in the order they were drawn, in any units, y downwards as on screens and in SVG.
pub struct tree_drawing(Arc<Drawing>);

impl Handle for tree_drawing {
    const NAME: &'static str = "tree_drawing";
}

impl tree_drawing {
    pub(crate) fn new(drawing: Drawing) -> Self {
        Self(Arc::new(drawing))
    }

    pub(crate) fn rust(&self) -> &Drawing {
        &self.0
    }
}

/// Makes a drawing of strokes, which are copied; there may be none. `control` may be NULL; `nodes` of its
/// limits caps the points of all strokes. Free the drawing with `tree_drawing_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_drawing_new(
    strokes: *const tree_sketch_stroke,
    n_strokes: usize,
    control: *const tree_control,
    drawing: *mut *mut tree_drawing,
) -> tree_status {
    call(|| {
        let place = unsafe { out(drawing, "drawing") }?;
        let strokes = unsafe { self::strokes(strokes, n_strokes, &limits(control)?) }?;
        place.put(tree_drawing::new(Drawing { strokes }));
        Ok(())
    })
}

/// Makes a drawing with the strokes of another and these after them. The other stays as it is. `control` may
/// be NULL; only its limits matter. Free the new drawing with `tree_drawing_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_drawing_with_strokes(
    drawing: *const tree_drawing,
    strokes: *const tree_sketch_stroke,
    n_strokes: usize,
    control: *const tree_control,
    more: *mut *mut tree_drawing,
) -> tree_status {
    call(|| {
        let place = unsafe { out(more, "more") }?;
        let drawing = unsafe { get(drawing, "drawing") }?.rust();
        let added = unsafe { self::strokes(strokes, n_strokes, &limits(control)?) }?;
        let strokes = drawing.strokes.iter().cloned().chain(added).collect();
        place.put(tree_drawing::new(Drawing { strokes }));
        Ok(())
    })
}

/// Reads the strokes of an SVG drawing: `svg` of `len` bytes or `TREE_NUL_TERMINATED`. Every path, line, polyline,
/// polygon, rectangle, circle and ellipse that is seen is one, with all transforms, in the drawing's units. A
/// whole word in its id, class, layer label or name, or in those of the groups around it, says what it shows:
/// `trunk`, `stem`; `branch`, `limb`, `twig`; `crown`, `outline`, `foliage`, `leaves`, `canopy`; and what is green
/// is the crown. Its id becomes its name. Style sheets, `<use>` and texts are not read. `control` may be NULL;
/// only its limits matter. Free the drawing with `tree_drawing_free`. `TREE_ERROR_FORMAT` when the text is no SVG or
/// draws nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_drawing_from_svg(
    svg: *const c_char,
    len: usize,
    control: *const tree_control,
    drawing: *mut *mut tree_drawing,
) -> tree_status {
    call(|| {
        let place = unsafe { out(drawing, "drawing") }?;
        let text = unsafe { document(svg, len, &limits(control)?, "svg") }?;
        ask_to_parse(text)?;
        place.put(tree_drawing::new(unsafe { run(control, |_| Ok(from_svg(text)?)) }?));
        Ok(())
    })
}

/// Reads a drawing from JSON, `json` of `len` bytes or `TREE_NUL_TERMINATED`, at most 32 MiB, in any of these forms,
/// y downwards:
///
/// * `{"strokes": [{"points": [[x, y], …], "role": "branch", "closed": false, "filled": false, "name": ""}, …]}`,
///   where all but the points may be missing; the role is `trunk`, `branch`, `crown` or `null`;
/// * `[[[x, y], …], …]`, bare lines;
/// * `{"drawing": [[[x…], [y…]], …]}`, a drawing of Quick, Draw!.
///
/// `control` may be NULL; only its limits matter. Free the drawing with `tree_drawing_free`. `TREE_ERROR_FORMAT` names
/// the stroke and the point at fault.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_drawing_from_json(
    json: *const c_char,
    len: usize,
    control: *const tree_control,
    drawing: *mut *mut tree_drawing,
) -> tree_status {
    call(|| {
        let place = unsafe { out(drawing, "drawing") }?;
        let text = unsafe { document(json, len, &limits(control)?, "json") }?;
        ask_to_parse(text)?;
        let read = unsafe { run(control, |_| from_json(text).map_err(in_document)) }?;
        place.put(tree_drawing::new(read));
        Ok(())
    })
}

/// Writes a drawing as JSON, in the first form of `tree_drawing_from_json`. Free the bytes, which are UTF-8, with
/// `tree_bytes_free`. `TREE_ERROR_INVALID` names a point that is not finite: JSON has no such numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_drawing_to_json(
    drawing: *const tree_drawing,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let text = to_json(unsafe { get(drawing, "drawing") }?.rust())?;
        place.put(tree_bytes::new(text.into_bytes()));
        Ok(())
    })
}

/// Number of strokes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_drawing_count(
    drawing: *const tree_drawing,
    n_strokes: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { get(drawing, "drawing") }?.rust().strokes.len();
        unsafe { out_value(n_strokes, n, "n_strokes") }
    })
}

/// Views a stroke. `index` is below `tree_drawing_count`. Set `stroke->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_drawing_stroke(
    drawing: *const tree_drawing,
    index: usize,
    stroke: *mut tree_sketch_stroke,
) -> tree_status {
    call(|| {
        let strokes = &unsafe { get(drawing, "drawing") }?.rust().strokes;
        let found = at(strokes, index, "strokes")?;
        unsafe { write(stroke, "stroke", &tree_sketch_stroke::of(found)) }
    })
}

/// Row `index`.
pub(crate) fn at<'a, T>(rows: &'a [T], index: usize, what: &str) -> Result<&'a T> {
    rows.get(index).ok_or_else(|| {
        let text = format!("index is {index}, but there are {} {what}", rows.len());
        Failure::new(TREE_ERROR_PARAMETER, text)
    })
}

/// Frees a drawing. What was made of it lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_drawing_free(drawing: *mut tree_drawing) -> tree_status {
    call(|| unsafe { free(drawing, "drawing") })
}

/// Drawings of one file.
pub struct tree_drawings(Vec<Arc<Drawing>>);

impl Handle for tree_drawings {
    const NAME: &'static str = "tree_drawings";
}

/// Reads a drawing from each line that is not blank, in any form of `tree_drawing_from_json`: the files of Quick,
/// Draw!. `ndjson` has `len` bytes or is `TREE_NUL_TERMINATED`. `control` may be NULL; only its limits matter. Free the
/// drawings with `tree_drawings_free`. `TREE_ERROR_FORMAT` names the line, from 1, the stroke and the point.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_drawings_from_ndjson(
    ndjson: *const c_char,
    len: usize,
    control: *const tree_control,
    drawings: *mut *mut tree_drawings,
) -> tree_status {
    call(|| {
        let place = unsafe { out(drawings, "drawings") }?;
        let text = unsafe { document(ndjson, len, &limits(control)?, "ndjson") }?;
        ask_to_parse(text)?;
        let read = unsafe { run(control, |_| from_ndjson(text).map_err(in_document)) }?;
        place.put(tree_drawings(read.into_iter().map(Arc::new).collect()));
        Ok(())
    })
}

/// Number of drawings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_drawings_count(
    drawings: *const tree_drawings,
    n_drawings: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { get(drawings, "drawings") }?.0.len();
        unsafe { out_value(n_drawings, n, "n_drawings") }
    })
}

/// One of the drawings, not copied; it may outlive the others. `index` is below `tree_drawings_count`. Free it with
/// `tree_drawing_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_drawings_at(
    drawings: *const tree_drawings,
    index: usize,
    drawing: *mut *mut tree_drawing,
) -> tree_status {
    call(|| {
        let place = unsafe { out(drawing, "drawing") }?;
        let found = at(&unsafe { get(drawings, "drawings") }?.0, index, "drawings")?;
        place.put(tree_drawing(found.clone()));
        Ok(())
    })
}

/// Frees drawings. Those taken out live on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_drawings_free(drawings: *mut tree_drawings) -> tree_status {
    call(|| unsafe { free(drawings, "drawings") })
}
