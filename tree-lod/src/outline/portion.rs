//! Triangles divided among the blades of an element.

use super::shape::Blade;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// How many of `target` triangles each blade gets: by area, each at least one. When there are fewer
/// triangles than blades, the smallest blades get none (petioles are among them).
///
/// # Complexity
/// O(target log blades).
pub(super) fn divided(blades: &[Blade], target: usize) -> Vec<usize> {
    let mut portions = vec![0; blades.len()];
    // Areas are finite and not negative, so that their bits order as they do. Ties: the first one.
    let wish = |i: usize, has: usize| {
        (has == 0, (blades[i].area / (has as f32 + 1.0)).to_bits(), Reverse(i))
    };
    let mut wishes: BinaryHeap<_> = (0..blades.len()).map(|i| wish(i, 0)).collect();
    for _ in 0..target {
        let Some((_, _, Reverse(i))) = wishes.pop() else { break };
        portions[i] += 1;
        if portions[i] < blades[i].triangles.len() {
            wishes.push(wish(i, portions[i]));
        }
    }
    portions
}
