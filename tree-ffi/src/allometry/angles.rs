//! Angles at which two branches leave a third.

use crate::border::{Result, call, out_value, tree_status};
use tree_model::tree_core::allometry::{
    ForkAngles, PipeModel, murray_angles, pipe_angles, strand_angles,
};

/// Exponent of the pipe model by Leonardo da Vinci: the cross-sections above a fork together are the
/// cross-section below.
pub const TREE_PIPE_DA_VINCI: f32 = 2.0;
/// Exponent of the pipe model by Murray (1927), who measured circumferences against the weight they
/// carry.
pub const TREE_PIPE_MURRAY: f32 = 2.49;
/// Exponent of the pipe model by Mandelbrot (1983), 8/3.
pub const TREE_PIPE_MANDELBROT: f32 = 2.666_666_7;

// The header needs literals; they are the library's own.
const _: () = assert!(
    TREE_PIPE_DA_VINCI == PipeModel::DA_VINCI
        && TREE_PIPE_MURRAY == PipeModel::MURRAY
        && TREE_PIPE_MANDELBROT == PipeModel::MANDELBROT
);

unsafe fn hand_out(found: ForkAngles, angles: *mut [f32; 2]) -> Result<()> {
    unsafe { out_value(angles, [found.alpha1, found.alpha2], "angles") }
}

/// Murray's angles, at which a vessel of radius `r0` parts into `r1` and `r2` with the least volume:
/// between the branch below and the first branch, then the second, in radians. Radii are above 0, and
/// `r0` is from √|r1² - r2²| to √(r1² + r2²): elsewhere no such fork is.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_murray_angles(
    r0: f32,
    r1: f32,
    r2: f32,
    angles: *mut [f32; 2],
) -> tree_status {
    call(|| unsafe { hand_out(murray_angles(r0, r1, r2)?, angles) })
}

/// Murray's angles where the branch below follows the pipe model with `exponent`, 2 to 10; exact for
/// twigs however thin. `r1` and `r2` are above 0. Otherwise as `tree_murray_angles`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pipe_angles(
    exponent: f32,
    r1: f32,
    r2: f32,
    angles: *mut [f32; 2],
) -> tree_status {
    call(|| unsafe { hand_out(pipe_angles(exponent, r1, r2)?, angles) })
}

/// Holton's angles: the more strands a branch has, the less it turns. `s1` and `s2` are the strands of
/// the two branches, not both 0; `sum` is the angle between them in radians, 0 to 2π. Otherwise as
/// `tree_murray_angles`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_strand_angles(
    s1: u64,
    s2: u64,
    sum: f32,
    angles: *mut [f32; 2],
) -> tree_status {
    call(|| unsafe { hand_out(strand_angles(s1, s2, sum)?, angles) })
}
