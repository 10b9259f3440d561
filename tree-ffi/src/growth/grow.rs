//! From parameters to a tree in one call.

use super::grown::tree_grown;
use super::params::tree_growth_params;
use crate::border::{call, out, read_or_default, tree_status};
use crate::control::{run, tree_control};
use tree_model::tree_core::Seed;

/// Grows a tree that stands alone; for several that compete there is `tree_growth_stand`. The same parameters and `seed`
/// give the same bits for any number of threads. `params` and `control` may be NULL. Free it with `tree_grown_free`.
/// `TREE_ERROR_PARAMETER` names what is out of range; `TREE_ERROR_NO_RESULT` where the base or the first internode is in
/// the obstacle; `TREE_ERROR_LIMIT` comes before more nodes, voxels or leaves are made than allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_grow(
    params: *const tree_growth_params,
    seed: u64,
    control: *const tree_control,
    grown: *mut *mut tree_grown,
) -> tree_status {
    call(|| {
        let place = unsafe { out(grown, "grown") }?;
        let params = unsafe { read_or_default(params, "params")?.rust() }?;
        let body = |control: &_| Ok(params.grow(Seed(seed), control)?);
        place.put(tree_grown::new(unsafe { run(control, body) }?));
        Ok(())
    })
}
