//! Scale and quality for each share of geometry.

use super::subject::tree_lod_subject;
use super::take::few;
use super::views::tree_around;
use crate::border::{
    Failure, Handle, Result, Versioned, call, free, get, init, out, out_value, read,
    read_or_default, tree_status,
};
use crate::control::{run, tree_control};
use crate::mesh::column;
use bytemuck::{Pod, Zeroable};
use std::ptr::null;
use tree_lod::quality::{Row, Scale, Table, TableParams};

/// Most rows of a table that a caller brings.
const ROWS_MAX: usize = 1 << 16;

/// Which scale a table is measured with: one of the `TREE_LOD_SCALE_` constants.
pub type tree_lod_scale = u32;

/// The best for each lambda (Neubert 2012, eq. 7.6).
pub const TREE_LOD_SCALE_BEST: u32 = 0;
/// 1 / lambda (Cook et al. 2007).
pub const TREE_LOD_SCALE_COOK: u32 = 1;
/// Always 1: leaves keep their size.
pub const TREE_LOD_SCALE_KEPT: u32 = 2;
/// That of the field `fixed`.
pub const TREE_LOD_SCALE_FIXED: u32 = 3;

/// A share of geometry, its best scale, and how good the model then is.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct tree_lod_row {
    /// Share of the foliage's triangles that is drawn, more than 0, at most 1.
    pub lambda: f32,
    /// Factor on the area of each element; lengths grow by its square root.
    pub scale: f32,
    /// Precision over the views that were looked at.
    pub precision: f32,
    /// Recall over them.
    pub recall: f32,
    /// Mean of the quality of the views.
    pub quality: f32,
}

impl tree_lod_row {
    fn of(row: &Row) -> Self {
        Self {
            lambda: row.lambda,
            scale: row.scale,
            precision: row.precision,
            recall: row.recall,
            quality: row.quality,
        }
    }

    fn rust(&self) -> Row {
        Row {
            lambda: self.lambda,
            scale: self.scale,
            precision: self.precision,
            recall: self.recall,
            quality: self.quality,
        }
    }
}

/// Best scale and quality of a model for each share of geometry: rows with rising lambda, the last of which
/// is the full model.
pub struct tree_lod_table {
    table: Table,
    /// The same as C sees them.
    rows: Vec<tree_lod_row>,
}

impl Handle for tree_lod_table {
    const NAME: &'static str = "tree_lod_table";
}

impl tree_lod_table {
    pub(super) fn new(table: Table) -> Self {
        Self { rows: table.rows().iter().map(tree_lod_row::of).collect(), table }
    }

    pub(super) fn rust(&self) -> &Table {
        &self.table
    }
}

/// How a table is measured. Begin with `tree_lod_table_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_lod_table_params {
    /// `sizeof(tree_lod_table_params)`.
    pub struct_size: usize,
    /// From where to look. NULL, the default: 8 azimuths, level, with 256 pixels; fewer and smaller for a large
    /// model, as `tree_around_for_table` says.
    pub around: *const tree_around,
    /// Rows of the table: rising, more than 0, the last 1. NULL, the default: 17 from 0.01 to 1.
    pub lambdas: *const f32,
    /// Number of lambdas, at most 256; 0 for the default.
    pub n_lambdas: usize,
    /// Which scale is measured: a `TREE_LOD_SCALE_` constant. Default `TREE_LOD_SCALE_BEST`.
    pub scale: tree_lod_scale,
    /// `TREE_LOD_SCALE_FIXED`: the scale, a factor on area, 0.01 to 10,000. Default 1.
    pub fixed: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_lod_table_params {
    const NAME: &'static str = "tree_lod_table_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            around: null(),
            lambdas: null(),
            n_lambdas: 0,
            scale: TREE_LOD_SCALE_BEST,
            fixed: 1.0,
        }
    }
}

impl tree_lod_table_params {
    /// For a model of so many triangles.
    pub(super) unsafe fn rust(&self, n_triangles: usize) -> Result<TableParams> {
        let default = TableParams::for_triangles(n_triangles);
        // More than Rust allows, so that Rust says how many are allowed.
        let lambdas = unsafe { few(self.lambdas, self.n_lambdas, ROWS_MAX, "lambdas") }?;
        let around = unsafe { tree_around::read_or(self.around, default.around.clone()) }?;
        let scale = match self.scale {
            TREE_LOD_SCALE_BEST => Scale::Best,
            TREE_LOD_SCALE_COOK => Scale::Cook,
            TREE_LOD_SCALE_KEPT => Scale::Kept,
            TREE_LOD_SCALE_FIXED => Scale::Fixed(self.fixed),
            other => return Err(Failure::not_one_of("params.scale", other, "TREE_LOD_SCALE_")),
        };
        let mut params = TableParams { around, scale, ..default };
        if !lambdas.is_empty() {
            params.lambdas = lambdas.to_vec();
        }
        Ok(params)
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_table_params_init(
    params: *mut tree_lod_table_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range, and lambdas
/// that do not rise to 1 are `TREE_ERROR_INVALID`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_table_params_check(
    params: *const tree_lod_table_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params")?.rust(0) }?.validate()?))
}

/// A table of `n_rows` rows, which are copied: of a model that was measured before. Free it with
/// `tree_lod_table_free`. `TREE_ERROR_INVALID` when there are no rows, when lambda does not rise, leaves 0 to 1
/// or does not end at 1, or when a number is not finite or a scale not positive; its text names the row.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_table_from_rows(
    rows: *const tree_lod_row,
    n_rows: usize,
    table: *mut *mut tree_lod_table,
) -> tree_status {
    call(|| {
        let place = unsafe { out(table, "table") }?;
        let rows = unsafe { few(rows, n_rows, ROWS_MAX, "rows") }?;
        let made = Table::new(rows.iter().map(tree_lod_row::rust).collect())?;
        place.put(tree_lod_table::new(made));
        Ok(())
    })
}

/// Measures a table: for every lambda the pruned model is drawn into masks from all sides, at several scales,
/// and compared with the full one; the scale of best mean quality is kept. It takes about ten drawings of
/// lambda times the triangles for each lambda and view. `params` and `control` may be NULL. Free the table
/// with `tree_lod_table_free`.
///
/// `TREE_ERROR_INVALID` when the parts of the subject do not belong together; see
/// `tree_lod_table_params_check` for the rest.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_table_measure(
    subject: *const tree_lod_subject,
    params: *const tree_lod_table_params,
    control: *const tree_control,
    table: *mut *mut tree_lod_table,
) -> tree_status {
    call(|| {
        let place = unsafe { out(table, "table") }?;
        let held = unsafe { tree_lod_subject::read(subject, control) }?;
        let n_triangles = held.rust().elements.n_triangles();
        let params = unsafe { read_or_default(params, "params")?.rust(n_triangles) }?;
        let body = |control: &_| Ok(Table::measure(&held.rust(), &params, control)?);
        place.put(tree_lod_table::new(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// The rows of a table. They stay for as long as the table does.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_table_rows(
    table: *const tree_lod_table,
    rows: *mut *const tree_lod_row,
    n_rows: *mut usize,
) -> tree_status {
    call(|| {
        let table = unsafe { get(table, "table") }?;
        unsafe { out_value(rows, column(&table.rows), "rows") }?;
        unsafe { out_value(n_rows, table.rows.len(), "n_rows") }
    })
}

/// The row for a lambda, interpolated linearly; lambda is brought into the range of the table.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_table_at(
    table: *const tree_lod_table,
    lambda: f32,
    row: *mut tree_lod_row,
) -> tree_status {
    call(|| {
        let found = unsafe { get(table, "table") }?.rust().at(lambda);
        unsafe { out_value(row, tree_lod_row::of(&found), "row") }
    })
}

/// The least lambda from which on the quality is at least `quality`; 1 when only the full model is so good.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_table_lambda_for(
    table: *const tree_lod_table,
    quality: f32,
    lambda: *mut f32,
) -> tree_status {
    call(|| {
        let found = unsafe { get(table, "table") }?.rust().lambda_for(quality);
        unsafe { out_value(lambda, found, "lambda") }
    })
}

/// Frees a table, and with it all views of it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_table_free(table: *mut tree_lod_table) -> tree_status {
    call(|| unsafe { free(table, "table") })
}
