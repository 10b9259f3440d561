//! Where branches stand on their parent, round it and along it (Wither et al. 2009, section 5).

pub mod gibbs;
pub mod revolve;
