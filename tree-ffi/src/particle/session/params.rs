//! All parameters of the way from photographs to a tree.

use crate::border::{Result, Versioned, call, init, read, read_or_default, tree_status};
use crate::control::{limits, tree_control};
use crate::particle::field::table_of;
use crate::particle::keep::Kept;
use crate::particle::{
    tree_density_params, tree_field_params, tree_finish_params, tree_flow_params,
};
use crate::photo::{tree_livewire_params, tree_seed_params, tree_stroke_params};
use std::ptr::null;
use tree_model::particle::session::PhotoParams;
use tree_model::tree_core::{Limits, Seed};

/// All parameters of the way from photographs to a tree. A part that is NULL, as all are after
/// `tree_photo_params_init`, is its default.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_photo_params {
    /// `sizeof(tree_photo_params)`.
    pub struct_size: usize,
    /// What points on the silhouettes are drawn with. They do not change with the tree's seed: what a
    /// photograph shows is the same for all trees made of it. Default 0.
    pub attractor_seed: u64,
    /// Which points of a silhouette may be seeds.
    pub seeds: *const tree_seed_params,
    /// How livewire finds branches.
    pub livewire: *const tree_livewire_params,
    /// How drawn strokes are joined.
    pub strokes: *const tree_stroke_params,
    /// How the density is found.
    pub density: *const tree_density_params,
    /// How branches steer particles.
    pub field: *const tree_field_params,
    /// How particles move.
    pub flow: *const tree_flow_params,
    /// How traces become a tree.
    pub finish: *const tree_finish_params,
    /// Height of the tree in metres, 0.01 to 1000. Default 10.
    pub height: f32,
    /// Points on each silhouette from which livewire seeks branches, 0 to 10,000. Default 40.
    pub branches: u32,
    /// Whether a side is imagined where all photographs are from one side (or its back): the first photograph,
    /// mirrored, from a quarter turn round. Without it the depth of the crown is filled evenly. Default 1.
    pub imagine: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_photo_params {
    const NAME: &'static str = "tree_photo_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let default = PhotoParams::default();
        Self {
            struct_size: size_of::<Self>(),
            attractor_seed: default.attractor_seed.0,
            seeds: null(),
            livewire: null(),
            strokes: null(),
            density: null(),
            field: null(),
            flow: null(),
            finish: null(),
            height: default.height,
            branches: default.branches,
            imagine: default.imagine.into(),
            reserved: 0,
        }
    }
}

impl tree_photo_params {
    /// The parameters in C's form; what they point at is kept in `kept`.
    pub(super) fn of(params: &PhotoParams, kept: &mut Kept) -> Self {
        let table = kept.all(table_of(&params.field));
        let finish = tree_finish_params::of(&params.finish, kept);
        Self {
            struct_size: size_of::<Self>(),
            attractor_seed: params.attractor_seed.0,
            seeds: kept.one(tree_seed_params::of(&params.seeds)),
            livewire: kept.one(tree_livewire_params::of(&params.livewire)),
            strokes: kept.one(tree_stroke_params::of(&params.strokes)),
            density: kept.one(tree_density_params::of(&params.density)),
            field: kept.one(tree_field_params::of(&params.field, table)),
            flow: kept.one(tree_flow_params::of(&params.flow)),
            finish: kept.one(finish),
            height: params.height,
            branches: params.branches,
            imagine: params.imagine.into(),
            reserved: 0,
        }
    }

    /// The parameters in Rust's form, not yet checked against their ranges.
    unsafe fn rust(&self, limits: &Limits) -> Result<PhotoParams> {
        let field = unsafe { read_or_default(self.field, "params.field") }?;
        let finish = unsafe { read_or_default(self.finish, "params.finish") }?;
        Ok(PhotoParams {
            height: self.height,
            branches: self.branches,
            imagine: self.imagine != 0,
            attractor_seed: Seed(self.attractor_seed),
            seeds: unsafe { read_or_default(self.seeds, "params.seeds") }?.rust(),
            livewire: unsafe { read_or_default(self.livewire, "params.livewire") }?.rust(),
            strokes: unsafe { read_or_default(self.strokes, "params.strokes") }?.rust(),
            density: unsafe { read_or_default(self.density, "params.density") }?.rust(),
            field: unsafe { field.rust(limits, "params.field") }?,
            flow: unsafe { read_or_default(self.flow, "params.flow") }?.rust(),
            finish: unsafe { finish.rust("params.finish") }?,
        })
    }
}

/// NULL is the default. Checked.
pub(super) unsafe fn photo_params(
    params: *const tree_photo_params,
    limits: &Limits,
) -> Result<PhotoParams> {
    let params = unsafe { read_or_default(params, "params")?.rust(limits) }?;
    params.validate()?;
    Ok(params)
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_params_init(
    params: *mut tree_photo_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Whether all fields and parts are in order: `TREE_OK`, or the error that their use would give. `control`
/// may be NULL; only its limits matter.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_params_check(
    params: *const tree_photo_params,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let params = unsafe { read(params, "params") }?;
        Ok(unsafe { params.rust(&limits(control)?) }?.validate()?)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use tree_model::particle::field::{Blend, FieldParams};

    #[test]
    fn parameters_come_back_from_c_as_they_went() {
        let default = PhotoParams::default();
        let limits = Limits::default();
        let null = tree_photo_params::default_value();
        assert_eq!(unsafe { null.rust(&limits) }.unwrap(), default);
        let blends = [
            Blend::Constant { share: 0.25 },
            Blend::Linear { reach: 0.5, most: 0.75 },
            Blend::Custom(vec![(0.0, 0.5), (0.25, 0.75)]),
        ];
        for blend in blends {
            let field = FieldParams { blend, rows: 20, margin: 0.25 };
            let mut params = PhotoParams { field, height: 3.0, branches: 7, ..default.clone() };
            params.imagine = false;
            params.flow.particles = 77;
            params.density.rays = 0.5;
            params.livewire.rows = 99;
            params.finish.twigs = None;
            let mut kept = Kept::default();
            let there = tree_photo_params::of(&params, &mut kept);
            assert_eq!(unsafe { there.rust(&limits) }.unwrap(), params);
        }
    }
}
