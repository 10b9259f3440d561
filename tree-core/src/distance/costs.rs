//! What single edits cost.

/// What a node weighs: the price of deleting or inserting it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Weight {
    /// Its radius in metres: thick branches count for more (Pirk et al. 2012). Of a run or an axis, the
    /// mean over its length.
    #[default]
    Radius,
    /// Radius times length of its segment in square metres, which goes with the bark. Independent of how
    /// finely a shoot is divided; the first node of a skeleton has no segment and weighs nothing.
    RadiusTimesLength,
    /// Radius squared times length in cubic metres, which goes with the wood.
    RadiusSquaredTimesLength,
    /// 1 each: structure only.
    Unit,
}

/// Local costs of editing one tree into another, by node of the first and of the second.
///
/// For a metric, costs are at least 0, `change` is at most `delete` plus `insert`, symmetric, and obeys
/// the triangle inequality.
pub trait EditCosts {
    /// Deleting a node of the first tree.
    fn delete(&self, first: u32) -> f64;
    /// Inserting a node of the second tree.
    fn insert(&self, second: u32) -> f64;
    /// Changing a node of the first tree into one of the second.
    fn change(&self, first: u32, second: u32) -> f64;
}

/// Deleting and inserting cost the weight, changing the difference of the weights.
pub(super) struct Difference<'a> {
    pub(super) first: &'a [f64],
    pub(super) second: &'a [f64],
}

impl EditCosts for Difference<'_> {
    fn delete(&self, first: u32) -> f64 {
        self.first[first as usize]
    }

    fn insert(&self, second: u32) -> f64 {
        self.second[second as usize]
    }

    #[inline]
    fn change(&self, first: u32, second: u32) -> f64 {
        (self.first[first as usize] - self.second[second as usize]).abs()
    }
}
