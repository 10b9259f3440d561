//! Impostors: leaves, or whole trees, as pictures (Lluch et al. 2010, §4.2).
pub mod boxes;
pub mod cards;
pub mod choose;
pub mod octahedral;
pub mod texel;

#[cfg(test)]
pub(crate) mod tests;
