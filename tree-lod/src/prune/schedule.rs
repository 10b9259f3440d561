//! What is drawn for a share of the triangles.
//!
//! Going down from the full model, one element changes at a time. First elements are drawn with the next
//! coarser tier, in the order of their importance; when all are, the next tier follows. In the last tier
//! elements are dropped from the end of the order. Leaves thus keep their number while their outlines can
//! still be made simpler, which PEERS.md shows to be worth more than anything else on modelled leaves.
//!
//! The states form one row of falling numbers of triangles, and a share of geometry picks the first that
//! fits the budget: a binary search with prefix sums of the costs.

use crate::error::{LodError, Result, check_range};
use crate::outline::Tier;

/// What is drawn of the elements; *ranks* are places in the order, the most important is 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cut {
    /// Tier of the ranks from `coarse` to `end`.
    pub tier: u32,
    /// Ranks below this one are drawn with the next tier. 0 in the last tier.
    pub coarse: u32,
    /// Ranks from here on are not drawn. All are, but in the last tier.
    pub end: u32,
    /// Triangles that are drawn.
    pub n_triangles: u64,
}

/// The states of a pruned model, from the full model down to one element.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Schedule {
    /// Of each tier: triangles of the ranks before each rank, and of all at the end.
    sums: Vec<Vec<u32>>,
    /// Number of elements.
    n: u32,
    /// Ranks below this one are always drawn, so that there is always a triangle.
    least: u32,
}

impl Schedule {
    /// The states of these tiers, drawn in this order: a permutation of the elements, most important
    /// first.
    ///
    /// # Errors
    /// [`LodError::Foliage`] when there are no tiers, no elements or no triangles, when tiers differ in
    /// their number of elements, or an element has more triangles in a tier than in the one before;
    /// [`LodError::Order`] when the order is no permutation of the elements.
    ///
    /// # Complexity
    /// O(tiers · elements).
    pub fn new(tiers: &[Tier], order: &[u32]) -> Result<Self> {
        let Some(n) = tiers.first().and_then(|tier| tier.starts.len().checked_sub(1)) else {
            return Err(LodError::Foliage("there are no tiers"));
        };
        for tier in tiers {
            check_tier(tier, n)?;
        }
        check_order(order, n)?;
        let sums: Vec<_> = tiers.iter().map(|tier| sums(tier, order)).collect();
        for pair in sums.windows(2) {
            let costs = |sums: &[u32], rank: usize| sums[rank + 1] - sums[rank];
            if (0..n).any(|rank| costs(&pair[1], rank) > costs(&pair[0], rank)) {
                let problem = "a tier has more triangles of an element than the one before";
                return Err(LodError::Foliage(problem));
            }
        }
        let coarsest = sums.last().map_or(&[][..], |sums| sums);
        let least = coarsest.partition_point(|&sum| sum == 0);
        if least > n {
            return Err(LodError::Foliage("the last tier has no triangles"));
        }
        Ok(Self { sums, n: n as u32, least: least as u32 })
    }

    /// As [`new`](Self::new), of the first `last` tiers only.
    ///
    /// # Errors
    /// As [`new`](Self::new), and [`LodError::Parameter`] when `last` is 0 or more than there are.
    pub fn with_tiers(tiers: &[Tier], order: &[u32], last: usize) -> Result<Self> {
        match tiers.get(..last) {
            Some(used) if last > 0 => Self::new(used, order),
            _ => Err(LodError::Parameter {
                field: "tiers",
                found: last as f64,
                min: 1.0,
                max: tiers.len() as f64,
            }),
        }
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
        let shrinking = u64::from(self.n - self.least) + 1;
        self.last() as u64 * u64::from(self.n) + shrinking
    }

    /// A state, counted from the full model down; from [`n_steps`](Self::n_steps) on the last.
    #[must_use]
    pub fn cut(&self, step: u64) -> Cut {
        let (n, last) = (u64::from(self.n), self.last());
        let sliding = last as u64 * n;
        if step < sliding {
            let (tier, coarse) = ((step / n) as usize, (step % n) as u32);
            let (fine, next) = (&self.sums[tier], &self.sums[tier + 1]);
            let before = coarse as usize;
            let n_triangles = u64::from(fine[n as usize] - fine[before]) + u64::from(next[before]);
            return Cut { tier: tier as u32, coarse, end: self.n, n_triangles };
        }
        let dropped = (step - sliding).min(u64::from(self.n - self.least)) as u32;
        let end = self.n - dropped;
        let n_triangles = self.sums[last][end as usize].into();
        Cut { tier: last as u32, coarse: 0, end, n_triangles }
    }

    /// Triangles of the full model.
    #[must_use]
    pub fn n_triangles(&self) -> u64 {
        self.sums[0][self.n as usize].into()
    }

    /// Number of elements.
    #[must_use]
    pub fn n_elements(&self) -> u32 {
        self.n
    }

    /// Number of tiers.
    #[must_use]
    pub fn n_tiers(&self) -> usize {
        self.sums.len()
    }

    /// The least λ with this number of triangles: [`at`](Self::at) gives them for it.
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
        let sum = self.sums[self.last()].get(rank as usize + 1);
        sum.map_or(1.0, |&sum| self.lambda_of(sum.into()))
    }

    /// λ of the last state in which all elements are drawn, all with the last tier.
    #[must_use]
    pub fn lambda_of_all(&self) -> f32 {
        self.lambda_of(self.sums[self.last()][self.n as usize].into())
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

fn check_order(order: &[u32], n: usize) -> Result<()> {
    let mut seen = vec![false; n];
    for (row, &element) in order.iter().enumerate() {
        match seen.get_mut(element as usize) {
            None => return Err(LodError::Order { row, problem: "there is no such element" }),
            Some(true) => {
                return Err(LodError::Order { row, problem: "the element is there twice" });
            }
            Some(seen) => *seen = true,
        }
    }
    if order.len() < n {
        let problem = "the order ends here: every element must be in it";
        return Err(LodError::Order { row: order.len(), problem });
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
