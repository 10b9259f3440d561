//! All parameters of the way from a drawing to a tree.

use crate::border::{Result, Versioned, call, init, read, read_or_default, tree_status, tree_str};
use crate::particle::Kept;
use crate::sketch::{
    tree_clean_params, tree_crown_params, tree_sketch_finish_params, tree_sketch_infer_params,
    tree_sketch_propagate_params, tree_template_select_params,
};
use std::ptr::null;
use tree_model::sketch::session::SketchParams;

/// All parameters of the way from a drawing to a tree. A part that is NULL, as all are after
/// `tree_sketch_params_init`, is its default.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sketch_params {
    /// `sizeof(tree_sketch_params)`.
    pub struct_size: usize,
    /// Name of the template. Empty, the default: the one that suits the drawing best.
    pub template_name: tree_str,
    /// Species whose twigs and leaves the tree bears: one of the names that `tree_foliage_preset_name` gives. Empty,
    /// the default: the template's.
    pub species: tree_str,
    /// How strokes are cleaned and joined. Its `height` is not used here.
    pub clean: *const tree_clean_params,
    /// How the crown is closed.
    pub crown: *const tree_crown_params,
    /// How templates are compared with the drawing.
    pub select: *const tree_template_select_params,
    /// How depths are inferred. Its `slenderness` is not used here.
    pub infer: *const tree_sketch_infer_params,
    /// How branches are propagated.
    pub propagate: *const tree_sketch_propagate_params,
    /// How branches become a tree. Its `species` is not used here, its `slenderness` counts relative to the default:
    /// the template has its own.
    pub finish: *const tree_sketch_finish_params,
    /// Height of the drawing, branches and crown, in metres, 0.01 to 1000. 0, the default: the template's.
    pub height: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_sketch_params {
    const NAME: &'static str = "tree_sketch_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            template_name: tree_str::EMPTY,
            species: tree_str::EMPTY,
            clean: null(),
            crown: null(),
            select: null(),
            infer: null(),
            propagate: null(),
            finish: null(),
            height: 0.0,
            reserved: 0,
        }
    }
}

impl tree_sketch_params {
    /// The parameters in C's form; what they point at is kept in `kept`.
    pub(super) fn of(params: &SketchParams, kept: &mut Kept) -> Self {
        let finish = tree_sketch_finish_params::of(&params.finish, kept);
        let mut text = |text: &Option<String>| match text {
            Some(text) => kept.text(text),
            None => tree_str::EMPTY,
        };
        let (template_name, species) = (text(&params.template), text(&params.species));
        Self {
            struct_size: size_of::<Self>(),
            template_name,
            species,
            clean: kept.one(tree_clean_params::of(&params.clean)),
            crown: kept.one(tree_crown_params::of(&params.crown)),
            select: kept.one(tree_template_select_params::of(&params.select)),
            infer: kept.one(tree_sketch_infer_params::of(&params.infer)),
            propagate: kept.one(tree_sketch_propagate_params::of(&params.propagate)),
            finish: kept.one(finish),
            height: params.height.unwrap_or(0.0),
            reserved: 0,
        }
    }

    /// The parameters in Rust's form, not yet checked against their ranges.
    unsafe fn rust(&self) -> Result<SketchParams> {
        let text = |text: tree_str, name: &str| -> Result<Option<String>> {
            let text = unsafe { text.get(name) }?;
            Ok((!text.is_empty()).then(|| text.to_owned()))
        };
        let finish = unsafe { read_or_default(self.finish, "params.finish") }?;
        Ok(SketchParams {
            height: (self.height != 0.0).then_some(self.height),
            template: text(self.template_name, "params.template_name")?,
            species: text(self.species, "params.species")?,
            clean: unsafe { read_or_default(self.clean, "params.clean") }?.rust()?,
            crown: unsafe { read_or_default(self.crown, "params.crown") }?.rust(),
            select: unsafe { read_or_default(self.select, "params.select") }?.rust(),
            infer: unsafe { read_or_default(self.infer, "params.infer") }?.rust(),
            propagate: unsafe { read_or_default(self.propagate, "params.propagate") }?.rust(),
            finish: unsafe { finish.rust("params.finish") }?,
        })
    }
}

/// NULL is the default. Checked.
pub(super) unsafe fn sketch_params(params: *const tree_sketch_params) -> Result<SketchParams> {
    let params = unsafe { read_or_default(params, "params")?.rust() }?;
    params.validate()?;
    Ok(params)
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_params_init(
    params: *mut tree_sketch_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Whether all fields and parts are in range: `TREE_OK`, or the error that their use would give. The name of the
/// template is looked up when it is needed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_params_check(
    params: *const tree_sketch_params,
) -> tree_status {
    call(|| {
        let params = unsafe { read(params, "params") }?;
        Ok(unsafe { params.rust() }?.validate()?)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_come_back_from_c_as_they_went() {
        let default = SketchParams::default();
        let null = tree_sketch_params::default_value();
        assert_eq!(unsafe { null.rust() }.unwrap(), default);
        let mut params = SketchParams {
            height: Some(7.0),
            template: Some("my spruce".into()),
            species: Some("birch".into()),
            ..default
        };
        params.clean.snap = 0.05;
        params.select.hand = 0.5;
        params.infer.keep_omega = true;
        params.infer.rounds = 3;
        params.propagate.jitter = 0.5;
        params.propagate.below_first = true;
        params.finish.leaves = false;
        params.finish.species = "spruce".into();
        let mut kept = Kept::default();
        let there = tree_sketch_params::of(&params, &mut kept);
        assert_eq!(unsafe { there.rust() }.unwrap(), params);
    }
}
