//! The seasons of any skeleton.

use crate::border::{Failure, TREE_ERROR_PARAMETER, call, fill, get, out_value, tree_status};
use crate::skeleton::tree_skeleton;
use tree_model::plastic::ages;

/// Most seasons that can be told apart.
const MOST_SEASONS: u32 = 10_000;

/// Estimates the season in which the segment that ends at each node grew, from 0 at the base, and how many internodes it
/// made in a season, at least 1. `internode` is the length of one in metres; 0 takes the commonest distance between
/// forks. `most`, 1 to 10,000, is how many seasons are told apart; a tree that has more is told them several at a time.
/// `seasons` and `rates` have room for `capacity` numbers, at least one for each node.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_ages(
    skeleton: *const tree_skeleton,
    internode: f32,
    most: u32,
    seasons: *mut u16,
    rates: *mut f32,
    capacity: usize,
    n_seasons: *mut usize,
) -> tree_status {
    call(|| {
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        if !(internode.is_finite() && internode >= 0.0) {
            let text = format!("internode is {internode}; finite and 0 or more is right");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        if !(1..=MOST_SEASONS).contains(&most) {
            let text = format!("most is {most}, allowed is 1 to {MOST_SEASONS}");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        let found = ages(skeleton, internode, most);
        unsafe { fill(seasons, capacity, &found.season, "seasons") }?;
        unsafe { fill(rates, capacity, &found.rates, "rates") }?;
        unsafe { out_value(n_seasons, found.n_seasons as usize, "n_seasons") }
    })
}
