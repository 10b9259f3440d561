//! From where to look.

use super::take::few;
use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, Versioned, call, init, out_value, read, read_or_default,
    tree_status, write,
};
use crate::preview::tree_view;
use std::ptr::null;
use std::sync::OnceLock;
use tree_lod::cover::Around;
use tree_lod::order::CoverageParams;
use tree_lod::preview::View;
use tree_lod::quality::TableParams;

/// Most pitches.
const PITCHES_MAX: usize = 64;

/// Views around a model, each of which frames all of it. Begin with `tree_around_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_around {
    /// `sizeof(tree_around)`.
    pub struct_size: usize,
    /// How far the cameras look down in radians, -pi/2 to pi/2, each with all azimuths: every next ring is
    /// turned by a share of the step, so that no two stand above each other. NULL, the default: one ring,
    /// level.
    pub pitches: *const f32,
    /// Number of pitches, at most 64; 0 for the default.
    pub n_pitches: usize,
    /// Directions around the trunk for each pitch, evenly spread, 1 to 360. Default 8.
    pub azimuths: u32,
    /// Width and height of the masks in pixels, 8 to 4096. Default 512.
    pub size: u32,
    /// Where the first stands, in radians. Default 0. Views for measuring should not be those that an order
    /// was made with.
    pub turn: f32,
    /// Vertical field of view in radians, 0.017 to 2.8, for perspective. 0, the default: parallel projection.
    pub fov: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_around {
    const NAME: &'static str = "tree_around";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self { pitches: null(), n_pitches: 0, ..Self::of(&Around::default(), &[]) }
    }
}

impl tree_around {
    fn of(around: &Around, pitches: &'static [f32]) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            pitches: crate::mesh::column(pitches),
            n_pitches: pitches.len(),
            azimuths: around.azimuths,
            size: around.size,
            turn: around.turn,
            fov: around.fov.unwrap_or(0.0),
        }
    }

    unsafe fn rust(&self) -> Result<Around> {
        let pitches = unsafe { few(self.pitches, self.n_pitches, PITCHES_MAX, "around.pitches") }?;
        let level = Around::default();
        Ok(Around {
            azimuths: self.azimuths,
            turn: self.turn,
            pitches: if pitches.is_empty() { level.pitches } else { pitches.to_vec() },
            size: self.size,
            fov: (self.fov != 0.0).then_some(self.fov),
        })
    }

    /// The views, or `default` for NULL.
    pub(super) unsafe fn read_or(around: *const Self, default: Around) -> Result<Around> {
        if around.is_null() { Ok(default) } else { unsafe { read(around, "around")?.rust() } }
    }

    /// The views, checked; the default for NULL.
    pub(super) unsafe fn read(around: *const Self) -> Result<Around> {
        let around = unsafe { read_or_default(around, "around")?.rust() }?;
        around.validate()?;
        Ok(around)
    }
}

/// Makes `around`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_around_init(around: *mut tree_around, size: usize) -> tree_status {
    call(|| unsafe { init(around, size) })
}

/// Makes `around`, of `size` bytes, the views from which `tree_order_coverage` looks at a model whose foliage has
/// so many triangles: 12 azimuths at pitches of 0 and 0.35 with 256 pixels, and fewer and smaller ones for a
/// large model. Its pitches are never freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_around_for_order(
    around: *mut tree_around,
    size: usize,
    n_triangles: usize,
) -> tree_status {
    static PITCHES: OnceLock<Pitches> = OnceLock::new();
    call(|| {
        unsafe { init(around, size) }?;
        let found = CoverageParams::for_triangles(n_triangles).around;
        let pitches = PITCHES.get_or_init(|| Pitches::of(&found)).rows();
        unsafe { write(around, "around", &tree_around::of(&found, pitches)) }
    })
}

/// Makes `around`, of `size` bytes, the views from which `tree_lod_table_measure` looks at a model whose foliage
/// has so many triangles: 8 azimuths, level, with 256 pixels, and fewer and smaller ones for a large model.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_around_for_table(
    around: *mut tree_around,
    size: usize,
    n_triangles: usize,
) -> tree_status {
    static PITCHES: OnceLock<Pitches> = OnceLock::new();
    call(|| {
        unsafe { init(around, size) }?;
        let found = TableParams::for_triangles(n_triangles).around;
        let pitches = PITCHES.get_or_init(|| Pitches::of(&found)).rows();
        unsafe { write(around, "around", &tree_around::of(&found, pitches)) }
    })
}

/// Pitches that stay, without memory that a host would want back.
struct Pitches([f32; PITCHES_MAX], usize);

impl Pitches {
    fn of(around: &Around) -> Self {
        let n = around.pitches.len().min(PITCHES_MAX);
        Self(std::array::from_fn(|i| around.pitches.get(i).copied().unwrap_or(0.0)), n)
    }

    fn rows(&self) -> &[f32] {
        self.0.get(..self.1).unwrap_or(&[])
    }
}

/// Checks every number of `around`; `TREE_ERROR_PARAMETER` names the first that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_around_check(around: *const tree_around) -> tree_status {
    call(|| Ok(unsafe { read(around, "around")?.rust() }?.validate()?))
}

/// Number of the views: azimuths times pitches.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_around_count(
    around: *const tree_around,
    n_views: *mut usize,
) -> tree_status {
    call(|| {
        let around = unsafe { read(around, "around")?.rust() }?;
        around.validate()?;
        unsafe { out_value(n_views, around.cameras().len(), "n_views") }
    })
}

/// View `number` (0 is the first), for pictures and masks from there: a framed camera, as wide and high as the
/// masks. Set `view->struct_size` first. `TREE_ERROR_PARAMETER` when there is no such view.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_around_view(
    around: *const tree_around,
    number: usize,
    view: *mut tree_view,
) -> tree_status {
    call(|| {
        let around = unsafe { read(around, "around")?.rust() }?;
        around.validate()?;
        let cameras = around.cameras();
        let Some(&camera) = cameras.get(number) else {
            let text = format!("number is {number}, but there are {} views", cameras.len());
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        };
        let found = View { width: around.size, height: around.size, camera, ..View::default() };
        unsafe { write(view, "view", &tree_view::of(&found)) }
    })
}
