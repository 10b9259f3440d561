//! What is drawn for a share of the triangles.
//!
//! Going down from the full model, one element changes at a time. In each tier elements are dropped from
//! the end of the order until `kept` of the next tier are left; then those are drawn with the next tier,
//! the least important first; and so on. In the last tier all but one are dropped. PEERS.md shows why both
//! are needed: leaves behind others can be dropped for nothing, the others should keep their number as
//! long as their outlines can still be made simpler.
//!
//! The states form one row of falling numbers of triangles, and a share of geometry picks the first that
//! fits the budget: a binary search with prefix sums of the costs.

use crate::error::{LodError, Result, check_range};
use crate::order;
use crate::outline::Tier;

/// What is drawn of the elements; *ranks* are places in the order, the most important is 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cut {
    /// Tier of the ranks below `fine`.
    pub tier: u32,
    /// Ranks from here to `end` are drawn with the next tier.
    pub fine: u32,
    /// Ranks from here on are not drawn.
    pub end: u32,
    /// Triangles that are drawn.
    pub n_triangles: u64,
}

/// The states of a pruned model, from the full model down to one element.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Schedule {
    /// Of each tier: triangles of the ranks before each rank, and of all at the end.
    sums: Vec<Vec<u32>>,
    /// Elements with which each tier begins, falling from their number.
    kept: Vec<u32>,
    /// Steps before each tier.
    before: Vec<u64>,
    /// Ranks below this one are always drawn, so that there is always a triangle.
    least: u32,
}

impl Schedule {
    /// The states of these tiers, drawn in this order: a permutation of the elements, most important
    /// first. `kept` is the number of elements with which each tier begins: of the first all, then
    /// never more than before ([`plan`](super::plan) finds good ones); empty: each begins with all.
    ///
    /// # Errors
    /// [`LodError::Foliage`] when there are no tiers, no elements or no triangles, when tiers differ in
    /// their number of elements, or an element has more triangles in a tier than in the one before;
    /// [`LodError::Order`] when the order is no permutation of the elements; [`LodError::Length`] or
    /// [`LodError::Parameter`] for numbers of kept elements that are not one for each tier, or rise.
    ///
    /// # Complexity
    /// O(tiers · elements).
    pub fn new(tiers: &[Tier], order: &[u32], kept: &[u32]) -> Result<Self> {
        let Some(n) = tiers.first().and_then(|tier| tier.starts.len().checked_sub(1)) else {
            return Err(LodError::Foliage("there are no tiers"));
        };
        for tier in tiers {
            check_tier(tier, n)?;
        }
        order::check(order, n)?;
        let sums: Vec<_> = tiers.iter().map(|tier| sums(tier, order)).collect();
        for pair in sums.windows(2) {
            let costs = |sums: &[u32], rank: usize| sums[rank + 1] - sums[rank];
            if (0..n).any(|rank| costs(&pair[1], rank) > costs(&pair[0], rank)) {
                let problem = "a tier has more triangles of an element than the one before";
                return Err(LodError::Foliage(problem));
            }
        }
        let coarsest = sums.last().map_or(&[][..], |sums| sums);
        let least = coarsest.partition_point(|&sum| sum == 0) as u32;
        if least as usize > n {
            return Err(LodError::Foliage("the last tier has no triangles"));
        }
        let kept = if kept.is_empty() { vec![n as u32; tiers.len()] } else { kept.to_vec() };
        check_kept(&kept, tiers.len(), n as u32, least)?;
        let before = kept.iter().scan(0, |sum, &kept| {
            let before = *sum;
            *sum += u64::from(kept);
            Some(before)
        });
        Ok(Self { sums, before: before.collect(), kept, least })
    }

    /// The most that fits the budget of floor(λ · triangles of the full model). At least one element
    /// with triangles is drawn, even if it is over the budget.
    ///
    /// # Errors
    /// [`LodError::Parameter`] when λ is not within 0 to 1.
    ///
    /// # Complexity
    /// O(log(tiers · elements)).
    pub fn at(&self, lambda: f32) -> Result<Cut> {
        check_range("lambda", lambda.into(), 0.0, 1.0)?;
        // The product is rounded: a λ that stands for a whole number must not fall below it.
        let budget = (f64::from(lambda) * self.n_triangles() as f64).floor() as u64;
        let (mut low, mut high) = (0, self.n_steps() - 1);
        while low < high {
            let middle = low + (high - low) / 2;
            if self.cut(middle).n_triangles <= budget { high = middle } else { low = middle + 1 }
        }
        Ok(self.cut(low))
    }

    /// Number of states. Neighbours differ in one element.
    #[must_use]
    pub fn n_steps(&self) -> u64 {
        self.before[self.last()] + u64::from(self.kept[self.last()] - self.least) + 1
    }

    /// A state, counted from the full model down; from [`n_steps`](Self::n_steps) on the last.
    #[must_use]
    pub fn cut(&self, step: u64) -> Cut {
        let step = step.min(self.n_steps() - 1);
        let tier = self.before.partition_point(|&before| before <= step).max(1) - 1;
        let fine = self.kept[tier] - (step - self.before[tier]) as u32;
        let own = self.sums[tier][fine as usize];
        let next = self.kept.get(tier + 1).zip(self.sums.get(tier + 1));
        let (end, others) = match next {
            Some((&end, sums)) if end > fine => (end, sums[end as usize] - sums[fine as usize]),
            _ => (fine, 0),
        };
        Cut { tier: tier as u32, fine, end, n_triangles: u64::from(own) + u64::from(others) }
    }

    /// Elements with which each tier begins.
    #[must_use]
    pub fn kept(&self) -> &[u32] {
        &self.kept
    }

    /// Triangles of the full model.
    #[must_use]
    pub fn n_triangles(&self) -> u64 {
        self.sums[0][self.kept[0] as usize].into()
    }

    /// Number of elements.
    #[must_use]
    pub fn n_elements(&self) -> u32 {
        self.kept[0]
    }

    /// Number of tiers.
    #[must_use]
    pub fn n_tiers(&self) -> usize {
        self.sums.len()
    }

    /// The least λ with this number of triangles: [`at`](Self::at) gives them for it, up to 2²⁴ triangles,
    /// beyond which numbers of 32 bits cannot tell neighbours apart.
    #[must_use]
    pub fn lambda_of(&self, n_triangles: u64) -> f32 {
        let all = self.n_triangles() as f64;
        let lambda = (n_triangles as f64 / all) as f32;
        let enough = (f64::from(lambda) * all).floor() >= n_triangles as f64;
        if enough { lambda.min(1.0) } else { lambda.next_up().min(1.0) }
    }

    /// λ from which on an element is drawn: of the state in which it is the last. 0 for those that are
    /// always drawn, 1 for ranks that do not exist.
    #[must_use]
    pub fn lambda_of_rank(&self, rank: u32) -> f32 {
        if rank < self.least {
            return 0.0;
        }
        // It is dropped in the last tier that begins with it.
        let tier = self.kept.partition_point(|&kept| kept > rank);
        let sums = tier.checked_sub(1).and_then(|tier| self.sums.get(tier));
        let sum = sums.and_then(|sums| sums.get(rank as usize + 1));
        sum.map_or(1.0, |&sum| self.lambda_of(sum.into()))
    }

    /// λ of the last state in which all elements are drawn.
    #[must_use]
    pub fn lambda_of_all(&self) -> f32 {
        let n = self.n_elements();
        let tier = self.kept.partition_point(|&kept| kept == n).max(1) - 1;
        self.lambda_of(self.sums[tier][n as usize].into())
    }

    /// The least λ that can be kept: of the state with the fewest elements.
    #[must_use]
    pub fn least_lambda(&self) -> f32 {
        self.lambda_of(self.sums[self.last()][self.least as usize].into())
    }

    fn last(&self) -> usize {
        self.sums.len() - 1
    }
}

fn check_tier(tier: &Tier, n: usize) -> Result<()> {
    if n == 0 {
        return Err(LodError::Foliage("there are no elements"));
    }
    if tier.starts.len() != n + 1 {
        return Err(LodError::Foliage("tiers differ in their number of elements"));
    }
    let ends = tier.starts.first().is_some_and(|&first| first == 0)
        && tier.starts.last().is_some_and(|&last| last as usize == tier.triangles.len());
    if !ends || tier.starts.windows(2).any(|pair| pair[0] > pair[1]) {
        return Err(LodError::Foliage("starts of a tier must rise from 0 to its triangles"));
    }
    Ok(())
}

fn check_kept(kept: &[u32], n_tiers: usize, n: u32, least: u32) -> Result<()> {
    if kept.len() != n_tiers {
        let (found, expected) = (kept.len(), n_tiers);
        return Err(LodError::Length { what: "kept", found, expected });
    }
    let mut most = n;
    for (tier, &kept) in kept.iter().enumerate() {
        let min = if tier == 0 { n } else { least };
        check_range("kept", kept.into(), min.into(), most.into())?;
        most = kept;
    }
    Ok(())
}

fn sums(tier: &Tier, order: &[u32]) -> Vec<u32> {
    let mut sums = Vec::with_capacity(order.len() + 1);
    let mut sum = 0;
    sums.push(0);
    for &element in order {
        sum += tier.cost(element as usize);
        sums.push(sum);
    }
    sums
}

#[cfg(test)]
#[path = "schedule_tests.rs"]
mod tests;
