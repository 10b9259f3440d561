//! Drawings become plans.

use super::drawing::{role_of, tree_drawing, tree_role};
use super::plan::tree_plan;
use crate::border::{
    Failure, Result, Versioned, call, get, init, out, read, read_or_default, tree_status,
};
use crate::control::{run, tree_control};
use glam::Vec2;
use tree_model::sketch::clean::{CleanParams, Isolated, Repair, RepairKind, clean};

/// What becomes of strokes that lie far from the rest: a `TREE_ISOLATED_` constant.
pub type tree_isolated = u32;

/// A straight line joins them, however far they are.
pub const TREE_ISOLATED_BRIDGE: u32 = 0;
/// Those beyond the reach are left out.
pub const TREE_ISOLATED_DROP: u32 = 1;
/// Those beyond the reach are an error.
pub const TREE_ISOLATED_REFUSE: u32 = 2;

/// How a drawing is cleaned and joined. Shares are of the drawing's height (or of a tenth of its width, where
/// that is more). Begin with `tree_clean_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_clean_params {
    /// `sizeof(tree_clean_params)`.
    pub struct_size: usize,
    /// Height of branches and crown together in metres, 0.01 to 1000. Default 10.
    pub height: f32,
    /// Distance between nodes, a share, 0.001 to 0.2. Default 0.01. Corners get nodes of their own. Very long
    /// drawings are sampled more coarsely.
    pub spacing: f32,
    /// Gaps up to this share count as drawn to touch, 0 to 0.2. Default 0.03. Ends that stick out beyond the
    /// stroke they join by up to this share are cut off.
    pub snap: f32,
    /// A stroke that runs along another within this share is the same, 0 to 0.1. Default 0.012. 0: nothing is
    /// merged.
    pub merge: f32,
    /// How far a stroke may be from the rest, a share, 0 to 10. Default 0.25.
    pub reach: f32,
    /// What becomes of strokes beyond the reach. Default `TREE_ISOLATED_BRIDGE`.
    pub isolated: tree_isolated,
    /// Whether `root` says where the tree's base is. Default no: it is found.
    pub has_root: u32,
    /// Where the tree's base is, in units of the drawing.
    pub root: [f32; 2],
    /// Whether strokes without a role may be taken for a crown, the ground, sides of a trunk or marks on its
    /// bark. Default yes; no: what is not marked is a branch.
    pub guess: u32,
    /// Forks on one branch closer together than this share are one, 0 (off) to 0.1. Default 0.01.
    pub gather: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_clean_params {
    const NAME: &'static str = "tree_clean_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&CleanParams::default())
    }
}

impl tree_clean_params {
    pub(crate) fn of(params: &CleanParams) -> Self {
        let CleanParams { height, spacing, snap, merge, reach, isolated, root, guess, gather } =
            *params;
        Self {
            struct_size: size_of::<Self>(),
            height,
            spacing,
            snap,
            merge,
            reach,
            isolated: match isolated {
                Isolated::Bridge => TREE_ISOLATED_BRIDGE,
                Isolated::Drop => TREE_ISOLATED_DROP,
                Isolated::Refuse => TREE_ISOLATED_REFUSE,
            },
            has_root: root.is_some().into(),
            root: root.unwrap_or_default().to_array(),
            guess: guess.into(),
            gather,
            reserved: 0,
        }
    }

    pub(crate) fn rust(&self) -> Result<CleanParams> {
        Ok(CleanParams {
            height: self.height,
            spacing: self.spacing,
            snap: self.snap,
            merge: self.merge,
            reach: self.reach,
            isolated: match self.isolated {
                TREE_ISOLATED_BRIDGE => Isolated::Bridge,
                TREE_ISOLATED_DROP => Isolated::Drop,
                TREE_ISOLATED_REFUSE => Isolated::Refuse,
                other => {
                    return Err(Failure::not_one_of("clean.isolated", other, "TREE_ISOLATED_"));
                }
            },
            root: (self.has_root != 0).then(|| Vec2::from_array(self.root)),
            guess: self.guess != 0,
            gather: self.gather,
        })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_clean_params_init(
    params: *mut tree_clean_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_clean_params_check(params: *const tree_clean_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust()?.validate()?))
}

/// What was done to a stroke: a `TREE_REPAIR_` constant. New ones may be added.
pub type tree_repair_kind = u32;

/// `count` points that are not finite, or absurdly far away, were left out.
pub const TREE_REPAIR_BAD_POINTS: u32 = 0;
/// It has no length worth speaking of, and was left out.
pub const TREE_REPAIR_EMPTY: u32 = 1;
/// It was taken for the ground, and left out.
pub const TREE_REPAIR_GROUND: u32 = 2;
/// It was taken for a mark on the trunk's bark, and left out.
pub const TREE_REPAIR_BARK_MARK: u32 = 3;
/// It is a small mark that touches nothing, and was left out.
pub const TREE_REPAIR_SPECK: u32 = 4;
/// It shows roots below the ground: what is below was left out.
pub const TREE_REPAIR_BELOW_GROUND: u32 = 5;
/// It runs along the crown's outline, stroke `other`: that part is its ink, and was left out.
pub const TREE_REPAIR_CROWN_INK: u32 = 6;
/// It was not marked, and was taken to show `role`.
pub const TREE_REPAIR_TAKEN_AS: u32 = 7;
/// It shows the trunk and the crown in one go, and was cut at the corner between them.
pub const TREE_REPAIR_CUT_AT_CORNER: u32 = 8;
/// It is one side of the trunk and stroke `other` the other side: the line between them was taken.
pub const TREE_REPAIR_MIDDLE_OF_SIDES: u32 = 9;
/// It is an outline: its middle line was taken.
pub const TREE_REPAIR_MIDDLE_OF_OUTLINE: u32 = 10;
/// All of it runs along stroke `other`, and was merged into that.
pub const TREE_REPAIR_MERGED: u32 = 11;
/// A part of it runs along stroke `other`, and was merged into that.
pub const TREE_REPAIR_MERGED_PARTLY: u32 = 12;
/// It was drawn towards the base, and was turned round.
pub const TREE_REPAIR_TURNED_ROUND: u32 = 13;
/// It passes through where it joins, and was split there in two.
pub const TREE_REPAIR_SPLIT: u32 = 14;
/// It crosses stroke `other` a little: the end beyond it, `share` long, was cut off.
pub const TREE_REPAIR_TRIMMED: u32 = 15;
/// Its end was joined over a small gap of `share`.
pub const TREE_REPAIR_SNAPPED: u32 = 16;
/// It was joined by a straight line over a gap of `share`.
pub const TREE_REPAIR_BRIDGED: u32 = 17;
/// It begins on the ground beside the base, `share` away, and was joined to the base.
pub const TREE_REPAIR_SECOND_ROOT: u32 = 18;
/// It is `share` away from the rest, and was left out.
pub const TREE_REPAIR_ISOLATED: u32 = 19;
/// There are no branches: a straight trunk was imagined below this crown.
pub const TREE_REPAIR_IMAGINED_TRUNK: u32 = 20;
/// Something else: `tree_plan_repairs_text` says what.
pub const TREE_REPAIR_OTHER: u32 = 21;
/// It shows the flare of a root at the trunk's foot, which was left out.
pub const TREE_REPAIR_ROOT_FLARE: u32 = 22;
/// No branch reaches into the crown, stroke `other`: this one was drawn on.
pub const TREE_REPAIR_DRAWN_ON: u32 = 23;

/// One thing that was done to one stroke of a drawing. Fields that its kind does not name are 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct tree_clean_repair {
    /// Index of the stroke in the drawing.
    pub stroke: u32,
    /// What was done. New ones may be added.
    pub kind: tree_repair_kind,
    /// Index of another stroke.
    pub other: u32,
    /// A number of points.
    pub count: u32,
    /// What it was taken to show.
    pub role: tree_role,
    /// A length, as a share of the drawing's height.
    pub share: f32,
}

impl tree_clean_repair {
    pub(super) fn of(repair: &Repair) -> Self {
        use RepairKind as K;
        let plain = |kind| Self { stroke: repair.stroke, kind, ..Self::default() };
        let by = |kind, other| Self { other, ..plain(kind) };
        let far = |kind, share| Self { share, ..plain(kind) };
        match repair.kind {
            K::BadPoints(count) => Self { count, ..plain(TREE_REPAIR_BAD_POINTS) },
            K::Empty => plain(TREE_REPAIR_EMPTY),
            K::Ground => plain(TREE_REPAIR_GROUND),
            K::BarkMark => plain(TREE_REPAIR_BARK_MARK),
            K::Speck => plain(TREE_REPAIR_SPECK),
            K::BelowGround => plain(TREE_REPAIR_BELOW_GROUND),
            K::CrownInk(other) => by(TREE_REPAIR_CROWN_INK, other),
            K::TakenAs(role) => Self { role: role_of(Some(role)), ..plain(TREE_REPAIR_TAKEN_AS) },
            K::CutAtCorner => plain(TREE_REPAIR_CUT_AT_CORNER),
            K::MiddleOfSides(other) => by(TREE_REPAIR_MIDDLE_OF_SIDES, other),
            K::MiddleOfOutline => plain(TREE_REPAIR_MIDDLE_OF_OUTLINE),
            K::Merged(other) => by(TREE_REPAIR_MERGED, other),
            K::MergedPartly(other) => by(TREE_REPAIR_MERGED_PARTLY, other),
            K::TurnedRound => plain(TREE_REPAIR_TURNED_ROUND),
            K::Split => plain(TREE_REPAIR_SPLIT),
            K::Trimmed(other, share) => Self { other, ..far(TREE_REPAIR_TRIMMED, share) },
            K::Snapped(share) => far(TREE_REPAIR_SNAPPED, share),
            K::Bridged(share) => far(TREE_REPAIR_BRIDGED, share),
            K::SecondRoot(share) => far(TREE_REPAIR_SECOND_ROOT, share),
            K::Isolated(share) => far(TREE_REPAIR_ISOLATED, share),
            K::ImaginedTrunk => plain(TREE_REPAIR_IMAGINED_TRUNK),
            K::RootFlare => plain(TREE_REPAIR_ROOT_FLARE),
            K::DrawnOn(other) => by(TREE_REPAIR_DRAWN_ON, other),
            _ => plain(TREE_REPAIR_OTHER),
        }
    }
}

/// Cleans a drawing and joins its strokes to one tree in the plane: points that are none go, what nobody marked
/// is told apart (ground, crown, wood), of wood drawn by its outline the middle line is taken, strokes drawn over
/// one another become one, gaps are closed. What was done is told by `tree_plan_repairs`. `params` and `control` may
/// be NULL; `nodes` of the limits caps the points. Free the plan with `tree_plan_free`. `TREE_ERROR_INVALID` where no
/// stroke has a length, or one is too far from the rest and `TREE_ISOLATED_REFUSE` was asked for: the text names the
/// stroke.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_drawing_clean(
    drawing: *const tree_drawing,
    params: *const tree_clean_params,
    control: *const tree_control,
    plan: *mut *mut tree_plan,
) -> tree_status {
    call(|| {
        let place = unsafe { out(plan, "plan") }?;
        let drawing = unsafe { get(drawing, "drawing") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust()?;
        let made = unsafe { run(control, |control| Ok(clean(drawing, &params, control)?)) }?;
        place.put(tree_plan::new(made));
        Ok(())
    })
}
