//! A tree in the plane: branching systems within branching systems.

use super::tree_outline;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_INVALID, TREE_ERROR_NO_RESULT, Versioned, call, free, get,
    out, out_value, tree_status, write,
};
use crate::mesh::column;
use crate::silhouette::tree_leaf_outline;
use glam::Vec2;
use std::ptr::null;
use tree_model::silhouette::plan::{Lateral, Origin, Plan, System};

/// In place of a branch's id: the trunk, as a parent; none, as the source of a style. No branch has this id.
pub const TREE_NO_BRANCH: u32 = 0;

/// Why there is a branch: one of the `TREE_BRANCH_` constants.
pub type tree_branch_origin = u32;
/// A bump of the outline.
pub const TREE_BRANCH_OF_BUMP: u32 = 0;
/// The outline was not covered there.
pub const TREE_BRANCH_OF_COVERAGE: u32 = 1;
/// A person drew it.
pub const TREE_BRANCH_DRAWN: u32 = 2;

fn origin(origin: Origin) -> tree_branch_origin {
    match origin {
        Origin::Bump => TREE_BRANCH_OF_BUMP,
        Origin::Coverage => TREE_BRANCH_OF_COVERAGE,
        Origin::Drawn => TREE_BRANCH_DRAWN,
    }
}

/// A tree in the plane, level in level: trunk and crown, branches with the outlines of their foliage, their own branches
/// where those were drawn, the leaf. In metres, x to the right, y up, the trunk's base near the origin.
pub struct tree_outline_plan {
    plan: Plan,
    rows: Rows,
}

impl Handle for tree_outline_plan {
    const NAME: &'static str = "tree_outline_plan";
}

impl tree_outline_plan {
    pub(super) fn new(plan: Plan) -> Self {
        let rows = Rows::of(&plan);
        Self { plan, rows }
    }

    pub(super) fn rust(&self) -> &Plan {
        &self.plan
    }

    /// The branch of an id.
    fn branch(&self, id: u32) -> Result<(usize, &Lateral)> {
        let found = self.rows.ids.iter().position(|&other| other == id);
        let lateral = find(&self.plan.system, id).or_else(|| {
            let lent = || self.plan.lenders.iter();
            lent().find(|lateral| lateral.id == id).or_else(|| {
                lent()
                    .filter_map(|lateral| lateral.system.as_deref())
                    .find_map(|system| find(system, id))
            })
        });
        found.zip(lateral).ok_or_else(|| {
            Failure::new(TREE_ERROR_INVALID, format!("branch {id}: there is no branch of this id"))
        })
    }

    /// The system on a branch, or on the trunk.
    fn system(&self, id: u32) -> Result<&System> {
        if id == TREE_NO_BRANCH {
            return Ok(&self.plan.system);
        }
        self.branch(id)?.1.system.as_deref().ok_or_else(|| {
            let text = format!("branch {id}: its outline was not drawn, so it bears no system");
            Failure::new(TREE_ERROR_NO_RESULT, text)
        })
    }
}

fn find(system: &System, id: u32) -> Option<&Lateral> {
    system.laterals.iter().find_map(|lateral| {
        let inner = || lateral.system.as_deref().and_then(|inner| find(inner, id));
        if lateral.id == id { Some(lateral) } else { inner() }
    })
}

/// All branches in columns, level by level.
#[derive(Default)]
struct Rows {
    ids: Vec<u32>,
    parents: Vec<u32>,
    levels: Vec<u32>,
    origins: Vec<tree_branch_origin>,
    styles: Vec<u32>,
    places: Vec<f32>,
    radii: Vec<f32>,
    azimuths: Vec<f32>,
    stretches: Vec<[f32; 2]>,
    lefts: Vec<u8>,
    refined: Vec<u8>,
    n_own: usize,
    line_starts: Vec<u32>,
    lines: Vec<Vec2>,
    outline_starts: Vec<u32>,
    outlines: Vec<Vec2>,
}

impl Rows {
    fn of(plan: &Plan) -> Self {
        let mut rows = Self { line_starts: vec![0], outline_starts: vec![0], ..Self::default() };
        rows.add_all(&plan.system.laterals);
        rows.n_own = rows.ids.len();
        rows.add_all(&plan.lenders);
        rows
    }

    fn add_all(&mut self, laterals: &[Lateral]) {
        let mut level: Vec<(u32, &Lateral)> =
            laterals.iter().map(|lateral| (TREE_NO_BRANCH, lateral)).collect();
        let mut number = 1;
        while !level.is_empty() {
            level.iter().for_each(|&(parent, lateral)| self.add(parent, number, lateral));
            level = level
                .iter()
                .filter_map(|(_, lateral)| Some((lateral.id, lateral.system.as_deref()?)))
                .flat_map(|(id, system)| system.laterals.iter().map(move |lateral| (id, lateral)))
                .collect();
            number += 1;
        }
    }

    fn add(&mut self, parent: u32, level: u32, lateral: &Lateral) {
        self.ids.push(lateral.id);
        self.parents.push(parent);
        self.levels.push(level);
        self.origins.push(origin(lateral.origin));
        self.styles.push(lateral.style.unwrap_or(TREE_NO_BRANCH));
        self.places.push(lateral.t);
        self.radii.push(lateral.radius);
        self.azimuths.push(lateral.azimuth.unwrap_or(f32::NAN));
        self.stretches.push(lateral.stretch.unwrap_or([f32::NAN; 2]));
        self.lefts.push(lateral.left.into());
        self.refined.push(lateral.system.is_some().into());
        self.lines.extend(lateral.line.points());
        self.line_starts.push(self.lines.len() as u32);
        self.outlines.extend(lateral.outline.points());
        self.outline_starts.push(self.outlines.len() as u32);
    }
}

/// All branches of a `tree_outline_plan`, parents first: a view. Set `struct_size` first.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_outline_plan_columns {
    /// `sizeof(tree_outline_plan_columns)`.
    pub struct_size: usize,
    /// Number of rows.
    pub n_branches: usize,
    /// Rows of the tree itself. Those after them are branches of other trees that it may copy the style of.
    pub n_own: usize,
    /// Id of each, above 0.
    pub ids: *const u32,
    /// Id of the branch it stands on; `TREE_NO_BRANCH` for those on a trunk.
    pub parents: *const u32,
    /// 1 for those on the trunk, 2 for those on these, and so on.
    pub levels: *const u32,
    /// Why it is there.
    pub origins: *const tree_branch_origin,
    /// Id of the branch whose style it takes; `TREE_NO_BRANCH` for the nearest one whose outline was drawn.
    pub styles: *const u32,
    /// Where it leaves its parent, as a share of the parent's length.
    pub places: *const f32,
    /// Radius of its bump in metres, or of what stands for one.
    pub radii: *const f32,
    /// Where round the axis it was drawn, in radians from the right side of the plane; NaN where that is to be found.
    pub azimuths: *const f32,
    /// Two floats each: the part of the parent's outline it may share, as lengths along; NaN for all.
    pub stretches: *const f32,
    /// 1 where it is on the left side of its parent, looking towards the parent's tip.
    pub lefts: *const u8,
    /// 1 where the outline of its foliage was drawn, so that it bears a system.
    pub refined: *const u8,
    /// Number of points of all lines.
    pub n_line_points: usize,
    /// Where each line begins in `line_points`, and at last their number: `n_branches + 1` values.
    pub line_starts: *const u32,
    /// Two floats for each point, from base to end.
    pub line_points: *const f32,
    /// Number of points of all outlines.
    pub n_outline_points: usize,
    /// Where each outline begins in `outline_points`, and at last their number: `n_branches + 1` values.
    pub outline_starts: *const u32,
    /// Two floats for each point, against the clock, the first not repeated.
    pub outline_points: *const f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_outline_plan_columns {
    const NAME: &'static str = "tree_outline_plan_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Rows::default())
    }
}

impl tree_outline_plan_columns {
    fn of(rows: &Rows) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_branches: rows.ids.len(),
            n_own: rows.n_own,
            ids: column(&rows.ids),
            parents: column(&rows.parents),
            levels: column(&rows.levels),
            origins: column(&rows.origins),
            styles: column(&rows.styles),
            places: column(&rows.places),
            radii: column(&rows.radii),
            azimuths: column(&rows.azimuths),
            stretches: column(&rows.stretches).cast(),
            lefts: column(&rows.lefts),
            refined: column(&rows.refined),
            n_line_points: rows.lines.len(),
            line_starts: column(&rows.line_starts),
            line_points: column(&rows.lines).cast(),
            n_outline_points: rows.outlines.len(),
            outline_starts: column(&rows.outline_starts),
            outline_points: column(&rows.outlines).cast(),
        }
    }
}

/// Views all branches. Valid until `tree_outline_plan_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_plan_view(
    plan: *const tree_outline_plan,
    columns: *mut tree_outline_plan_columns,
) -> tree_status {
    call(|| {
        let value = tree_outline_plan_columns::of(&unsafe { get(plan, "plan") }?.rows);
        unsafe { write(columns, "columns", &value) }
    })
}

/// The row of the branch of this id. `TREE_ERROR_INVALID` for an id that is not there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_plan_find(
    plan: *const tree_outline_plan,
    id: u32,
    row: *mut usize,
) -> tree_status {
    call(|| {
        let (found, _) = unsafe { get(plan, "plan") }?.branch(id)?;
        unsafe { out_value(row, found, "row") }
    })
}

/// One branch of a plan: a view. Set `struct_size` first.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_outline_branch {
    /// `sizeof(tree_outline_branch)`.
    pub struct_size: usize,
    /// Number of points of its line.
    pub n_line_points: usize,
    /// Two floats for each, from base to end.
    pub line_points: *const f32,
    /// Number of points of the outline of its foliage.
    pub n_outline_points: usize,
    /// Two floats for each, against the clock, the first not repeated.
    pub outline_points: *const f32,
    /// Its id.
    pub id: u32,
    /// Id of the branch it stands on; `TREE_NO_BRANCH` for the trunk.
    pub parent: u32,
    /// 1 for one on the trunk, 2 for one on these, and so on.
    pub level: u32,
    /// Why it is there.
    pub origin: tree_branch_origin,
    /// Id of the branch whose style it takes; `TREE_NO_BRANCH` for the nearest one whose outline was drawn.
    pub style: u32,
    /// 1 where it is on the left side of its parent, looking towards the parent's tip.
    pub is_left: u32,
    /// 1 where the outline of its foliage was drawn, so that it bears a system.
    pub is_refined: u32,
    /// Where it leaves its parent, as a share of the parent's length.
    pub place: f32,
    /// Radius of its bump in metres, or of what stands for one.
    pub radius: f32,
    /// Where round the axis it was drawn, in radians from the right side of the plane; NaN where that is to be found.
    pub azimuth: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_outline_branch {
    const NAME: &'static str = "tree_outline_branch";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_line_points: 0,
            line_points: null(),
            n_outline_points: 0,
            outline_points: null(),
            id: TREE_NO_BRANCH,
            parent: TREE_NO_BRANCH,
            level: 0,
            origin: TREE_BRANCH_OF_BUMP,
            style: TREE_NO_BRANCH,
            is_left: 0,
            is_refined: 0,
            place: 0.0,
            radius: 0.0,
            azimuth: f32::NAN,
        }
    }
}

/// Views the branch of this id. Valid until `tree_outline_plan_free`. `TREE_ERROR_INVALID` for an id that is not there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_plan_branch(
    plan: *const tree_outline_plan,
    id: u32,
    branch: *mut tree_outline_branch,
) -> tree_status {
    call(|| {
        let plan = unsafe { get(plan, "plan") }?;
        let (row, lateral) = plan.branch(id)?;
        let value = tree_outline_branch {
            n_line_points: lateral.line.points().len(),
            line_points: column(lateral.line.points()).cast(),
            n_outline_points: lateral.outline.points().len(),
            outline_points: column(lateral.outline.points()).cast(),
            id,
            parent: plan.rows.parents[row],
            level: plan.rows.levels[row],
            origin: plan.rows.origins[row],
            style: plan.rows.styles[row],
            is_left: lateral.left.into(),
            is_refined: lateral.system.is_some().into(),
            place: lateral.t,
            radius: lateral.radius,
            azimuth: plan.rows.azimuths[row],
            ..tree_outline_branch::default_value()
        };
        unsafe { write(branch, "branch", &value) }
    })
}

/// An axis, the outline of its foliage and the angles at which branches leave it: a view. Set `struct_size` first.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_outline_system {
    /// `sizeof(tree_outline_system)`.
    pub struct_size: usize,
    /// Number of points of the axis: the trunk or branch.
    pub n_axis_points: usize,
    /// Two floats for each, from base to tip.
    pub axis_points: *const f32,
    /// Number of points of the outline of its foliage: the crown of the trunk.
    pub n_outline_points: usize,
    /// Two floats for each, against the clock, the first not repeated.
    pub outline_points: *const f32,
    /// Number of samples of the branching angles.
    pub n_angles: usize,
    /// Two floats for each: place along the axis, 0 at its base to 1 at its tip, in rising order; and angle, 0 (straight
    /// on) to π (backwards).
    pub angles: *const f32,
    /// Number of branches on it.
    pub n_branches: usize,
    /// Number of outlines in further planes; see `tree_outline_plan_section`.
    pub n_sections: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_outline_system {
    const NAME: &'static str = "tree_outline_system";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_axis_points: 0,
            axis_points: null(),
            n_outline_points: 0,
            outline_points: null(),
            n_angles: 0,
            angles: null(),
            n_branches: 0,
            n_sections: 0,
        }
    }
}

/// Views the system on the branch of this id, or with `TREE_NO_BRANCH` that of the trunk, whose outline is the crown.
/// Valid until `tree_outline_plan_free`. `TREE_ERROR_INVALID` for an id that is not there, `TREE_ERROR_NO_RESULT` for a
/// branch whose outline was not drawn.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_plan_system(
    plan: *const tree_outline_plan,
    id: u32,
    system: *mut tree_outline_system,
) -> tree_status {
    call(|| {
        let found = unsafe { get(plan, "plan") }?.system(id)?;
        let value = tree_outline_system {
            n_axis_points: found.axis.points().len(),
            axis_points: column(found.axis.points()).cast(),
            n_outline_points: found.outline.points().len(),
            outline_points: column(found.outline.points()).cast(),
            n_angles: found.angles.samples.len(),
            angles: column(&found.angles.samples).cast(),
            n_branches: found.laterals.len(),
            n_sections: found.sections.len(),
            ..tree_outline_system::default_value()
        };
        unsafe { write(system, "system", &value) }
    })
}

/// Of the system on a branch, or on the trunk, the outline in a further plane: how far the plane is turned about the
/// axis, in radians from +X towards +Z, goes into `azimuth`. Free the outline with `tree_outline_free`.
/// `TREE_ERROR_INVALID` for a section that is not there; else as `tree_outline_plan_system`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_plan_section(
    plan: *const tree_outline_plan,
    id: u32,
    section: usize,
    azimuth: *mut f32,
    outline: *mut *mut tree_outline,
) -> tree_status {
    call(|| {
        let place = unsafe { out(outline, "outline") }?;
        let system = unsafe { get(plan, "plan") }?.system(id)?;
        let found = system.sections.get(section).ok_or_else(|| {
            let n = system.sections.len();
            let text = format!("section is {section}, there are {n}");
            Failure::new(TREE_ERROR_INVALID, text)
        })?;
        unsafe { out_value(azimuth, found.azimuth, "azimuth") }?;
        place.put(tree_outline::new(found.outline.clone()));
        Ok(())
    })
}

/// The outline of a branch's foliage, or with `TREE_NO_BRANCH` the crown, as an object of its own. Free it with
/// `tree_outline_free`. `TREE_ERROR_INVALID` for an id that is not there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_plan_outline(
    plan: *const tree_outline_plan,
    id: u32,
    outline: *mut *mut tree_outline,
) -> tree_status {
    call(|| {
        let place = unsafe { out(outline, "outline") }?;
        let plan = unsafe { get(plan, "plan") }?;
        let found = match id {
            TREE_NO_BRANCH => &plan.plan.system.outline,
            id => &plan.branch(id)?.1.outline,
        };
        place.put(tree_outline::new(found.clone()));
        Ok(())
    })
}

/// Number of levels of outlines that were drawn: 1 for the crown only, 2 with that of a branch, and so on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_plan_count_levels(
    plan: *const tree_outline_plan,
    n_levels: *mut u32,
) -> tree_status {
    call(|| {
        let found = unsafe { get(plan, "plan") }?.plan.n_levels();
        unsafe { out_value(n_levels, found, "n_levels") }
    })
}

/// The drawn leaf, one long, and its length in metres. Free it with `tree_leaf_outline_free`. `TREE_ERROR_NO_RESULT`
/// where none was drawn.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_plan_leaf(
    plan: *const tree_outline_plan,
    length: *mut f32,
    leaf: *mut *mut tree_leaf_outline,
) -> tree_status {
    call(|| {
        let place = unsafe { out(leaf, "leaf") }?;
        let Some(found) = &unsafe { get(plan, "plan") }?.plan.leaf else {
            return Err(Failure::new(TREE_ERROR_NO_RESULT, "no leaf was drawn"));
        };
        unsafe { out_value(length, found.length, "length") }?;
        place.put(tree_leaf_outline::new(found.outline.clone()));
        Ok(())
    })
}

/// Frees a plan.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_plan_free(plan: *mut tree_outline_plan) -> tree_status {
    call(|| unsafe { free(plan, "plan") })
}
