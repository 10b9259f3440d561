//! One index buffer from which every level of detail is drawn (Neubert 2012, §7.2.2 and §7.4).

mod schedule;

pub use schedule::{Cut, Schedule};
