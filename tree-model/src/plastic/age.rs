//! When each branch grew (Pirk et al. 2012, section 4.1).
//!
//! Tips all stop growing today, so a branch that is short for its place grew slowly. Eq. 1 gives each segment a rate relative
//! to the fastest; its absolute rate is how many internodes it makes in a season, 1 for the slowest.
//!
//! Departure: Eq. 2 is printed as length / internode · rate. A fast branch would then need more seasons for a metre than a slow one,
//! and tips would not end together, which is what Eq. 1 is derived from. We divide by the rate.

use tree_core::Skeleton;

/// Below this share of the way to the farthest tip, a segment takes its parent's rate (`d_t` of the paper).
const TRUSTED: f32 = 0.2;

/// The ages of a skeleton's segments, all in the order of its nodes; the root's is that of the trunk's first season.
#[derive(Clone, Debug, PartialEq)]
pub struct Ages {
    /// Season in which the segment that ends at each node grew, from 0 at the base. Never below the parent's.
    pub season: Vec<u16>,
    /// Number of seasons.
    pub n_seasons: u32,
    /// Length of an internode in metres.
    pub internode: f32,
    /// Internodes per season, at least 1.
    pub rates: Vec<f32>,
}

/// The commonest of `lengths`: the highest peak of their density, found by mean shift (flat kernel of a quarter of the median).
/// O(n log n). `None` when no length is above 0.
#[must_use]
pub(super) fn commonest(lengths: &[f32]) -> Option<f32> {
    let mut sorted: Vec<f32> =
        lengths.iter().copied().filter(|&l| l > 0.0 && l.is_finite()).collect();
    sorted.sort_by(f32::total_cmp);
    let median = *sorted.get(sorted.len() / 2)?;
    let mut sums = vec![0.0_f64];
    for &length in &sorted {
        sums.push(sums[sums.len() - 1] + f64::from(length));
    }
    let width = 0.25 * median;
    let window = |at: f32| {
        let low = sorted.partition_point(|&l| l < at - width);
        let high = sorted.partition_point(|&l| l <= at + width);
        (low, high)
    };
    let mut best = (0_usize, median);
    // Starts a half width apart reach every peak that a start at every length reaches.
    let mut next = f32::NEG_INFINITY;
    for &start in &sorted {
        if start < next {
            continue;
        }
        next = start + 0.5 * width;
        let mut at = start;
        for _ in 0..100 {
            let (low, high) = window(at);
            if low == high {
                break;
            }
            let mean = ((sums[high] - sums[low]) / (high - low) as f64) as f32;
            if (mean - at).abs() <= 1e-5 * median {
                break;
            }
            at = mean;
        }
        let (low, high) = window(at);
        if high - low > best.0 {
            best = (high - low, at);
        }
    }
    Some(best.1)
}

/// Distances between forks (or ends) along the branches: the internodes as far as one sees them.
fn fork_distances(skeleton: &Skeleton) -> Vec<f32> {
    let children = skeleton.children();
    let lengths = skeleton.segment_lengths();
    let mut run = vec![0.0_f32; skeleton.len()];
    let mut found = Vec::new();
    for (parent, node) in skeleton.segments() {
        let (p, n) = (parent as usize, node as usize);
        let plain = parent != 0 && children.of(parent).len() == 1;
        run[n] = lengths[n] + if plain { run[p] } else { 0.0 };
        if children.of(node).len() != 1 {
            found.push(run[n]);
        }
    }
    found
}

/// Estimates the season of every segment. `internode` of 0 means: the commonest distance between forks. More than `most` seasons
/// are told several at a time. O(n log n).
#[must_use]
pub fn ages(skeleton: &Skeleton, internode: f32, most: u32) -> Ages {
    let n = skeleton.len();
    let to_root = skeleton.distances_to_root();
    let to_tip = skeleton.distances_to_tip();
    let lengths = skeleton.segment_lengths();
    let reach = to_tip[0];
    let internode = if internode > 0.0 {
        internode
    } else {
        commonest(&fork_distances(skeleton)).unwrap_or(1.0)
    };
    if reach <= 0.0 {
        return Ages { season: vec![0; n], n_seasons: 1, internode, rates: vec![1.0; n] };
    }
    let mut rates = vec![1.0_f32; n];
    let mut slowest = 1.0_f32;
    for (parent, node) in skeleton.segments() {
        let (p, s) = (parent as usize, node as usize);
        // Both distances are taken at the segment's lower end, so that the way through it counts as still to grow.
        let left = to_tip[s] + lengths[s];
        let slack = reach - to_root[p];
        rates[s] = if to_tip[s] > TRUSTED * reach && slack > 0.0 {
            (left / slack).clamp(0.0, 1.0)
        } else {
            rates[p]
        };
        slowest = slowest.min(rates[s]);
    }
    for rate in &mut rates {
        *rate /= slowest;
    }
    let mut when = vec![0.0_f32; n];
    let mut last = 0.0_f32;
    for (parent, node) in skeleton.segments() {
        let (p, s) = (parent as usize, node as usize);
        when[s] = when[p] + lengths[s] / (internode * rates[s]);
        last = last.max(when[s]);
    }
    let longest = most as f32;
    let squeeze = if last > longest { longest / last } else { 1.0 };
    let n_seasons = (libm::ceilf(last * squeeze) as u32).clamp(1, most);
    let season = when.iter().map(|&t| ((t * squeeze) as u32).min(n_seasons - 1) as u16).collect();
    Ages { season, n_seasons, internode, rates }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use proptest::prelude::*;
    use tree_core::Skeleton;

    #[test]
    fn the_commonest_length_is_where_most_lie() {
        let lengths = [0.1, 0.11, 0.5, 0.51, 0.52, 0.49, 0.5, 2.0, 2.1];
        let found = commonest(&lengths).unwrap();
        assert!((found - 0.504).abs() < 0.01, "{found}");
        assert_eq!(commonest(&[0.0, f32::NAN]), None);
    }

    /// A trunk of ten internodes with a side branch of five that starts half way up, and one of two internodes there.
    fn fork() -> Skeleton {
        let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
        let mut at = 0;
        for k in 1..=10 {
            at = builder.add(at, Vec3::Y * k as f32, 0.1).unwrap();
        }
        let mut side = 5;
        for k in 1..=5 {
            side = builder.add(side, Vec3::new(k as f32, 5.0, 0.0), 0.1).unwrap();
        }
        let mut short = 5;
        for k in 1..=4 {
            short = builder.add(short, Vec3::new(0.0, 5.0, k as f32), 0.1).unwrap();
        }
        builder.finish()
    }

    #[test]
    fn branches_that_reach_as_far_grow_as_fast_and_end_together() {
        let ages = ages(&fork(), 1.0, 40);
        assert_eq!(ages.season[10], ages.season[15]);
        assert!(ages.rates[1] > ages.rates[16], "{:?}", ages.rates);
        assert_eq!(u32::from(ages.season[10]) + 1, ages.n_seasons);
    }

    #[test]
    fn too_many_seasons_are_told_several_at_a_time() {
        let ages = ages(&fork(), 0.01, 7);
        assert_eq!(ages.n_seasons, 7);
        assert_eq!(ages.season.iter().max(), Some(&6));
    }

    proptest! {
        #[test]
        fn no_branch_is_older_than_what_it_stands_on(
            steps in prop::collection::vec((any::<prop::sample::Index>(), -1.0_f32..1.0, 0.0_f32..1.0, -1.0_f32..1.0), 1..60),
        ) {
            let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
            let mut positions = vec![Vec3::ZERO];
            for (parent, x, y, z) in steps {
                let parent = parent.index(positions.len());
                positions.push(positions[parent] + Vec3::new(x, y, z));
                builder.add(parent as u32, positions[positions.len() - 1], 0.05).unwrap();
            }
            let skeleton = builder.finish();
            let ages = ages(&skeleton, 0.0, 40);
            for (parent, node) in skeleton.segments() {
                prop_assert!(ages.season[node as usize] >= ages.season[parent as usize]);
            }
            prop_assert!(ages.n_seasons <= 40);
            prop_assert!(ages.season.iter().all(|&s| u32::from(s) < ages.n_seasons));
        }
    }
}
