//! Base, height and scale of loosely taken photographs.
//!
//! Not in the thesis, where a person moves the images into place (3.1: "we do not need an exact
//! registration of these images and interactively arrange them"). This finds a first arrangement in the
//! mattes, and says where it may be wrong; a [`Camera`] written by hand does as well.
//!
//! 1. Leaves and branches near each other are joined; the largest part and those nearly as large are the
//!    tree, the rest are specks.
//! 2. The foot is the lowest point, where points count as higher the farther they are from the tree's
//!    middle, so that the tip of a low branch is no foot.
//! 3. From the foot up the silhouette is narrow (the trunk) until the crown begins.
//! 4. Base and top on the picture, and the height given, are the scale.
//! 5. [`align_all`] gives all views one height, and names those whose crown begins elsewhere or is of another
//!    width than in most.
//!
//! Cost: O(pixels), at most about a million of them: larger pictures are reduced.

use super::camera::{Camera, Projection};
use super::matte::Matte;
use crate::error::{ModelError, Result, check};
use glam::{Vec2, Vec3};

mod parts;
mod profile;

use parts::{Mask, tree_of};
use profile::{Profile, foot};

/// Crown bases that differ by more than this share of the height are reported.
const CROWN_BASES: f32 = 0.1;
/// Crown widths that differ by more than this factor are reported.
const CROWN_WIDTHS: f32 = 2.0;

/// What is known about a photograph.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct AlignParams {
    /// Height of the tree in metres, 0.01 to 1000. Default 10.
    pub height: f32,
    /// See [`Camera::yaw`]. Default 0.
    pub yaw: f32,
    /// See [`Camera::pitch`]. Default 0.
    pub pitch: f32,
    /// See [`Camera::projection`]. Default orthographic.
    pub projection: Projection,
}

impl Default for AlignParams {
    fn default() -> Self {
        Self { height: 10.0, yaw: 0.0, pitch: 0.0, projection: Projection::Orthographic }
    }
}

impl AlignParams {
    /// Checks all numbers.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the field.
    pub fn validate(&self) -> Result<()> {
        check("align.height", self.height, 0.01_f32, 1000.0)?;
        let (size, base) = (Vec2::ONE, Vec2::ZERO);
        self.camera(size, base, 1.0).validate("align")
    }

    fn camera(&self, size: Vec2, base: Vec2, scale: f32) -> Camera {
        let Self { yaw, pitch, projection, .. } = *self;
        Camera { yaw, pitch, projection, size, base, scale }
    }
}

/// What was found in a matte. Lengths are in pixels from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Alignment {
    /// The foot of the trunk.
    pub base: Vec2,
    /// The highest point of the tree.
    pub top: Vec2,
    /// The row where the crown begins: between it and the base the trunk is bare. The base's row where no
    /// bare trunk shows.
    pub crown_base: f32,
    /// Width of the bare trunk at about breast height (1.3 m); `None` where none shows.
    pub trunk_width: Option<f32>,
    /// Top left and bottom right of the crown.
    pub crown: (Vec2, Vec2),
    /// What may be wrong.
    pub warnings: Vec<AlignWarning>,
}

/// What was found in several views of one tree ([`align_all`]).
#[derive(Clone, Debug, PartialEq)]
pub struct AlignedViews {
    /// A camera for each view.
    pub cameras: Vec<Camera>,
    /// What was found in each view.
    pub alignments: Vec<Alignment>,
    /// Views that disagree with the others.
    pub warnings: Vec<AlignWarning>,
}

/// What may be wrong with an alignment.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum AlignWarning {
    /// The foot is at the picture's bottom: the trunk may go on, and the tree be higher than it seems.
    BaseCropped,
    /// The crown touches the picture's border: the tree may go on beyond it.
    CrownCropped,
    /// No bare trunk shows: the base is the lowest point near the middle.
    NoTrunk,
    /// Besides the tree there are this many parts left out, of so large a share of the covered area.
    LeftOut {
        /// Parts apart from the tree.
        parts: usize,
        /// Their share of all that is covered, 0 to 1.
        share: f32,
    },
    /// The tree is in this many parts, as a crown in tufts is.
    Parts(usize),
    /// The crown begins at another height than in the other views ([`align_all`] only).
    CrownBase {
        /// Index into the views.
        view: usize,
        /// Height of its crown's base as a share of the tree's.
        found: f32,
        /// The middle of all views.
        usual: f32,
    },
    /// The crown is far wider or narrower than in the other views ([`align_all`] only).
    CrownWidth {
        /// Index into the views.
        view: usize,
        /// Width of its crown as a share of the tree's height.
        found: f32,
        /// The middle of all views.
        usual: f32,
    },
}

impl std::fmt::Display for AlignWarning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let percent = |share: &f32| 100.0 * share;
        match self {
            Self::BaseCropped => write!(f, "the trunk's foot is at the picture's bottom border"),
            Self::CrownCropped => write!(f, "the crown touches the picture's border"),
            Self::NoTrunk => write!(f, "no bare trunk shows; the base is a guess"),
            Self::LeftOut { parts, share } => {
                write!(f, "{parts} parts ({:.1} %) are apart from the tree", percent(share))
            }
            Self::Parts(parts) => write!(f, "the tree is in {parts} parts"),
            Self::CrownBase { view, found, usual } => write!(
                f,
                "in views[{view}] the crown begins at {:.0} % of the height, usual is {:.0} %",
                percent(found),
                percent(usual)
            ),
            Self::CrownWidth { view, found, usual } => write!(
                f,
                "in views[{view}] the crown is {:.0} % of the height wide, usual is {:.0} %",
                percent(found),
                percent(usual)
            ),
        }
    }
}

/// Finds the tree's base and top in a matte, and so its camera.
///
/// # Errors
/// [`ModelError::Parameter`] for parameters out of range; [`ModelError::Picture`] when nothing or
/// everything is covered, the tree is less than two rows high, or a camera of this pitch and projection
/// cannot see a tree so.
///
/// # Complexity
/// O(pixels).
pub fn align(matte: &Matte, params: &AlignParams) -> Result<(Camera, Alignment)> {
    params.validate()?;
    let mask = Mask::new(matte);
    let n_covered = mask.covered.iter().filter(|&&covered| covered).count();
    if n_covered == 0 || n_covered == mask.covered.len() {
        let found = if n_covered == 0 { "no pixel is" } else { "all pixels are" };
        let problem = format!(
            "{found} covered; a tree and what is around it must show: try another matting, or paint the matte"
        );
        return Err(ModelError::Picture { problem });
    }
    let mut warnings = Vec::new();
    let tree = tree_of(&mask, &mut warnings);
    let foot = foot(&tree);
    let profile = Profile::new(&tree, foot, params.height);
    let alignment = describe(&tree, &profile, warnings);
    let size = Vec2::new(matte.width() as f32, matte.height() as f32);
    let scale = scale(params, size, &alignment)?;
    Ok((params.camera(size, alignment.base, scale), alignment))
}

/// Several views of one tree, made consistent: each gets the scale that makes its tree `height` metres
/// high, so that tops and bases coincide. Heights in `params` are not used.
///
/// # Errors
/// [`ModelError::Parameter`] when there are not as many `params` as `mattes`, or none;
/// [`ModelError::View`] naming the view that cannot be aligned, and why.
///
/// # Complexity
/// O(pixels).
pub fn align_all(mattes: &[&Matte], params: &[AlignParams], height: f32) -> Result<AlignedViews> {
    check("mattes.len()", mattes.len() as f64, 1.0, 1000.0)?;
    check("params.len()", params.len() as f64, mattes.len() as f64, mattes.len() as f64)?;
    let (mut cameras, mut alignments) = (Vec::new(), Vec::new());
    for (view, (matte, params)) in mattes.iter().zip(params).enumerate() {
        let params = AlignParams { height, ..*params };
        let (camera, alignment) = align(matte, &params).map_err(|error| error.in_view(view))?;
        cameras.push(camera);
        alignments.push(alignment);
    }
    let warnings = disagreements(&alignments.iter().map(Some).collect::<Vec<_>>());
    Ok(AlignedViews { cameras, alignments, warnings })
}

/// Views whose crowns begin elsewhere or are of another width than those of most. Those without an alignment
/// have no say.
pub(super) fn disagreements(found: &[Option<&Alignment>]) -> Vec<AlignWarning> {
    let found: Vec<(usize, &Alignment)> =
        found.iter().enumerate().filter_map(|(view, found)| Some((view, (*found)?))).collect();
    let per_height = |alignment: &Alignment, length: f32| {
        length / (alignment.base.y - alignment.top.y).max(1e-6)
    };
    let bases: Vec<f32> =
        found.iter().map(|(_, a)| per_height(a, a.base.y - a.crown_base)).collect();
    let widths: Vec<f32> =
        found.iter().map(|(_, a)| per_height(a, a.crown.1.x - a.crown.0.x)).collect();
    let (base, width) = (middle(&bases), middle(&widths));
    let mut warnings = Vec::new();
    for (i, &(view, _)) in found.iter().enumerate() {
        if (bases[i] - base).abs() > CROWN_BASES {
            warnings.push(AlignWarning::CrownBase { view, found: bases[i], usual: base });
        }
        let factor = widths[i].max(1e-6) / width.max(1e-6);
        if factor.max(1.0 / factor) > CROWN_WIDTHS {
            warnings.push(AlignWarning::CrownWidth { view, found: widths[i], usual: width });
        }
    }
    warnings
}

/// The median, between the two middle values of an even number of them.
fn middle(values: &[f32]) -> f32 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f32::total_cmp);
    let n = sorted.len();
    if n == 0 { 0.0 } else { 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]) }
}

/// In pixels of the picture.
fn describe(tree: &Mask, profile: &Profile, mut warnings: Vec<AlignWarning>) -> Alignment {
    let cell = tree.cell;
    if profile.base_row + 1 >= tree.ny {
        warnings.push(AlignWarning::BaseCropped);
    }
    if profile.trunk_width.is_none() {
        warnings.push(AlignWarning::NoTrunk);
    }
    let (low, high) = profile.crown;
    if low.x <= 0.0 || low.y <= 0.0 || high.x >= tree.nx as f32 || high.y >= tree.ny as f32 {
        warnings.push(AlignWarning::CrownCropped);
    }
    let within = |point: Vec2| (point * cell).min(tree.size);
    Alignment {
        base: within(Vec2::new(profile.base_column, profile.base_row as f32 + 1.0)),
        top: within(profile.top),
        crown_base: (profile.crown_base as f32 * cell).min(tree.size.y),
        trunk_width: profile.trunk_width.map(|width| width * cell),
        crown: (within(low), within(high)),
        warnings,
    }
}

/// Metres for a pixel at the base, such that a point `height` above it falls on the row of the top.
fn scale(params: &AlignParams, size: Vec2, alignment: &Alignment) -> Result<f32> {
    let rows = alignment.base.y - alignment.top.y;
    if rows < 2.0 {
        let problem = format!("the tree is {rows} pixels high; at least 2 are needed");
        return Err(ModelError::Picture { problem });
    }
    let frame = params.camera(size, alignment.base, 1.0).frame();
    let (up, forward) = (frame.up.dot(Vec3::Y), frame.forward.dot(Vec3::Y));
    let shown = match params.projection {
        Projection::Orthographic => up,
        // From v = (off · scale − height · up) · focal / (focal · scale + height · forward), where v and
        // off are the rows of top and base below the middle.
        Projection::Perspective { fov } => {
            let focal = 0.5 * size.y / libm::tanf(0.5 * fov);
            up + (alignment.top.y - 0.5 * size.y) / focal * forward
        }
    };
    let scale = params.height * shown / rows;
    if shown <= 1e-3 || params.camera(size, alignment.base, scale).validate("align").is_err() {
        let problem = "a camera of this pitch and field of view cannot show a tree upright there";
        return Err(ModelError::Picture { problem: problem.into() });
    }
    Ok(scale)
}

#[cfg(test)]
mod tests;
