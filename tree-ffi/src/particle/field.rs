//! Direction fields: where particles go, seen in one picture.

use super::grid::fill_vectors;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_PARAMETER, Versioned, call, free, get, init, out,
    out_value, read, read_or_default, slice, tree_status, vec2s, write,
};
use crate::control::{User, limits, run, tree_control};
use crate::mesh::column;
use crate::photo::{tree_attractor, tree_photo};
use glam::Vec2;
use std::ffi::c_void;
use tree_model::particle::field::{
    Blend, DirectionField, FieldParams, direction_field, direction_field_with,
};
use tree_model::tree_core::{Control, Limits, Resource};

/// How much a particle is directed towards the branches instead of along them, by its distance: one of the
/// `TREE_BLEND_` constants.
pub type tree_blend = u32;
/// From 0 on a branch to `blend_most` at a distance of `blend_reach` and beyond.
pub const TREE_BLEND_LINEAR: u32 = 0;
/// `blend_share` at every distance but 0: particles meet branches at a fixed angle.
pub const TREE_BLEND_CONSTANT: u32 = 1;
/// Straight lines between the points of `blend_table`.
pub const TREE_BLEND_TABLE: u32 = 2;
/// What `blend_function` says.
pub const TREE_BLEND_FUNCTION: u32 = 3;

/// The share of the direction towards the nearest branch, 0 to 1, at a distance as a share of the picture's
/// height. Not a number counts as 0. Called from any thread, by several at once; must give the same answer
/// for the same distance, and must not unwind.
pub type tree_blend_fn = Option<unsafe extern "C" fn(user: *mut c_void, distance: f32) -> f32>;

/// How a direction field is made. Begin with `tree_field_params_init`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct tree_field_params {
    /// `sizeof(tree_field_params)`.
    pub struct_size: usize,
    /// Table: two floats for each point: a distance as a share of the picture's height, ascending, and a
    /// share, 0 to 1. Before the first and after the last it is as there. Default NULL.
    pub blend_table: *const f32,
    /// Table: number of points, at least 1.
    pub n_blend_table: usize,
    /// Function. Default NULL. Sessions and `tree_from_photos` keep parameters longer than a call and take
    /// no functions: give them a table.
    pub blend_function: tree_blend_fn,
    /// Handed to `blend_function`.
    pub blend_user: *mut c_void,
    /// How directions towards and along branches are blended. Default `TREE_BLEND_LINEAR`.
    pub blend: tree_blend,
    /// Linear: distance as a share of the picture's height, 0.0001 to 10. Default 0.05.
    pub blend_reach: f32,
    /// Linear: greatest share, 0 to 1. Default 0.85.
    pub blend_most: f32,
    /// Constant: share, 0 to 1. Default 0.
    pub blend_share: f32,
    /// Cells over the height of the picture, 1 to 4096. Default 100. Cost grows with the square.
    pub rows: u32,
    /// How far the grid reaches beyond the picture on every side, as a share of its height, 0 to 2. Default
    /// 0.1.
    pub margin: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_field_params {
    const NAME: &'static str = "tree_field_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&FieldParams::default(), std::ptr::null())
    }
}

/// The numbers of a table of blending, two for each point; empty for other kinds.
pub(super) fn table_of(params: &FieldParams) -> Vec<f32> {
    match &params.blend {
        Blend::Custom(points) => points.iter().flat_map(|&(d, share)| [d, share]).collect(),
        _ => Vec::new(),
    }
}

impl tree_field_params {
    /// The parameters in C's form; fields of other kinds have their defaults. `table` holds what
    /// [`table_of`] gives.
    pub(super) fn of(params: &FieldParams, table: *const f32) -> Self {
        let mut value = Self {
            struct_size: size_of::<Self>(),
            blend_table: std::ptr::null(),
            n_blend_table: 0,
            blend_function: None,
            blend_user: std::ptr::null_mut(),
            blend: TREE_BLEND_LINEAR,
            blend_reach: 0.0,
            blend_most: 0.0,
            blend_share: 0.0,
            rows: params.rows,
            margin: params.margin,
        };
        if let Blend::Linear { reach, most } = Blend::default() {
            (value.blend_reach, value.blend_most) = (reach, most);
        }
        match params.blend {
            Blend::Linear { reach, most } => (value.blend_reach, value.blend_most) = (reach, most),
            Blend::Constant { share } => {
                (value.blend, value.blend_share) = (TREE_BLEND_CONSTANT, share);
            }
            Blend::Custom(ref points) => {
                value.blend = TREE_BLEND_TABLE;
                (value.blend_table, value.n_blend_table) = (table, points.len());
            }
            // The enum may grow; a blend without a constant cannot come from C.
            _ => {}
        }
        value
    }

    /// The parameters in Rust's form, not yet checked against their ranges, and the caller's function; `name`
    /// is what they are called by.
    unsafe fn with_function(
        &self,
        limits: &Limits,
        name: &str,
    ) -> Result<(FieldParams, Option<impl Fn(f32) -> f32 + Send + Sync + use<>>)> {
        let mut function = None;
        let blend = match self.blend {
            TREE_BLEND_LINEAR => Blend::Linear { reach: self.blend_reach, most: self.blend_most },
            TREE_BLEND_CONSTANT => Blend::Constant { share: self.blend_share },
            TREE_BLEND_TABLE => Blend::Custom(unsafe { self.table(limits, name) }?),
            TREE_BLEND_FUNCTION => {
                let (Some(own), user) = (self.blend_function, User(self.blend_user)) else {
                    return Err(Failure::null(&format!("{name}.blend_function")));
                };
                // SAFETY: the caller's function with the caller's pointer, as the header says.
                function = Some(move |distance: f32| unsafe { own(user.get(), distance) });
                Blend::default()
            }
            other => {
                return Err(Failure::not_one_of(&format!("{name}.blend"), other, "TREE_BLEND_"));
            }
        };
        Ok((FieldParams { rows: self.rows, margin: self.margin, blend }, function))
    }

    unsafe fn table(&self, limits: &Limits, name: &str) -> Result<Vec<(f32, f32)>> {
        let (n, name) = (self.n_blend_table, format!("{name}.blend_table"));
        let rows: &[[f32; 2]] =
            unsafe { slice(self.blend_table.cast(), n, limits, Resource::Nodes, &name) }?;
        Ok(rows.iter().map(|&[distance, share]| (distance, share)).collect())
    }

    /// As [`with_function`](Self::with_function), without one.
    pub(super) unsafe fn rust(&self, limits: &Limits, name: &str) -> Result<FieldParams> {
        match unsafe { self.with_function(limits, name) }? {
            (params, None) => Ok(params),
            _ => {
                let text = format!(
                    "{name}.blend is TREE_BLEND_FUNCTION, which cannot be kept; use TREE_BLEND_TABLE"
                );
                Err(Failure::new(TREE_ERROR_PARAMETER, text))
            }
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_field_params_init(
    params: *mut tree_field_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_field_params_check(params: *const tree_field_params) -> tree_status {
    call(|| {
        let params = unsafe { read(params, "params") }?;
        Ok(unsafe { params.with_function(&Limits::default(), "params") }?.0.validate()?)
    })
}

/// The share of the direction towards the branches at a distance, as a share of the picture's height.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_field_params_blend_at(
    params: *const tree_field_params,
    distance: f32,
    measure: *mut f32,
) -> tree_status {
    call(|| {
        let params = unsafe { read(params, "params") }?;
        let (params, function) = unsafe { params.with_function(&Limits::default(), "params") }?;
        params.validate()?;
        let found = match function {
            Some(function) => function(distance),
            None => params.blend.at(distance),
        };
        unsafe { out_value(measure, found, "measure") }
    })
}

/// Directions on a grid of cells over a picture.
pub struct tree_direction_field(DirectionField);

impl Handle for tree_direction_field {
    const NAME: &'static str = "tree_direction_field";
}

impl tree_direction_field {
    pub(super) fn new(field: DirectionField) -> Self {
        Self(field)
    }

    pub(super) fn rust(&self) -> &DirectionField {
        &self.0
    }
}

/// A view of a direction field.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_direction_field_columns {
    /// `sizeof(tree_direction_field_columns)`.
    pub struct_size: usize,
    /// Two floats for each cell, row by row from the top left: x to the right, y up, length 0 to 1. 0, 0
    /// where there is no direction.
    pub vectors: *const f32,
    /// Number of cells: `size[0] * size[1]`.
    pub n_vectors: usize,
    /// Cells across and down.
    pub size: [u32; 2],
    /// Pixels for a cell.
    pub cell: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_direction_field_columns {
    const NAME: &'static str = "tree_direction_field_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            vectors: std::ptr::null(),
            n_vectors: 0,
            size: [0; 2],
            cell: 0.0,
            reserved: 0,
        }
    }
}

/// The direction field of the branches in one picture of `width` by `height` pixels, each 1 to 1e6: near a
/// branch along it and towards the tree's base, elsewhere towards the branch. A graph without segments has no
/// directions: the field is zero. `base_x` and `base_y` are the base in pixels, where what lies beyond the
/// graph's roots is directed. `params` and `control` may be NULL. Free it with `tree_direction_field_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_direction_field_new(
    attractor: *const tree_attractor,
    width: f32,
    height: f32,
    base_x: f32,
    base_y: f32,
    params: *const tree_field_params,
    control: *const tree_control,
    field: *mut *mut tree_direction_field,
) -> tree_status {
    call(|| {
        let place = unsafe { out(field, "field") }?;
        let graph = unsafe { get(attractor, "attractor") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?;
        let (params, function) = unsafe { params.with_function(&limits(control)?, "params") }?;
        let (size, base) = (Vec2::new(width, height), Vec2::new(base_x, base_y));
        let body = |control: &Control| {
            Ok(match &function {
                Some(blend) => direction_field_with(graph, size, base, &params, blend, control)?,
                None => direction_field(graph, size, base, &params, control)?,
            })
        };
        place.put(tree_direction_field(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Views a direction field. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_direction_field_view(
    field: *const tree_direction_field,
    columns: *mut tree_direction_field_columns,
) -> tree_status {
    call(|| {
        let field = unsafe { get(field, "field") }?.rust();
        let value = tree_direction_field_columns {
            vectors: column(field.vectors()).cast(),
            n_vectors: field.vectors().len(),
            size: field.size(),
            cell: field.cell(),
            ..tree_direction_field_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// The directions at `n_spots` points of the picture, two floats each in pixels, between cells by bilinear
/// interpolation; outside the grid that of the nearest cell. `directions` has room for `capacity` floats, two
/// for each point: x to the right, y up. `control` may be NULL; `nodes` of its limits caps the points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_direction_field_sample(
    field: *const tree_direction_field,
    spots: *const f32,
    n_spots: usize,
    control: *const tree_control,
    directions: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let field = unsafe { get(field, "field") }?.rust();
        let limits = unsafe { limits(control) }?;
        let spots = unsafe { vec2s(spots, n_spots, &limits, Resource::Nodes, "spots") }?;
        let body = |_: &_| Ok(spots.iter().map(|&spot| field.sample(spot).to_array()).collect());
        let found: Vec<[f32; 2]> = unsafe { run(control, body) }?;
        unsafe { fill_vectors(directions, capacity, &found, "directions") }
    })
}

/// A picture of the field: one pixel for each cell; red is x and green is y, 128 for none. Free it with
/// `tree_photo_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_direction_field_picture(
    field: *const tree_direction_field,
    picture: *mut *mut tree_photo,
) -> tree_status {
    call(|| {
        let place = unsafe { out(picture, "picture") }?;
        let field = unsafe { get(field, "field") }?.rust();
        place.put(tree_photo::new(field.to_photo()?));
        Ok(())
    })
}

/// A copy of a photograph, or any other picture of the same size, with the field as arrows over it. `color` is
/// `0xRRGGBBAA`. Free it with `tree_photo_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_direction_field_draw_over(
    field: *const tree_direction_field,
    photo: *const tree_photo,
    color: u32,
    drawn: *mut *mut tree_photo,
) -> tree_status {
    call(|| {
        let place = unsafe { out(drawn, "drawn") }?;
        let field = unsafe { get(field, "field") }?.rust();
        let photo = unsafe { get(photo, "photo") }?.rust();
        place.put(tree_photo::new(field.draw_over(photo, color.to_be_bytes())?));
        Ok(())
    })
}

/// Frees a direction field.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_direction_field_free(
    field: *mut tree_direction_field,
) -> tree_status {
    call(|| unsafe { free(field, "field") })
}
