//! Why trees are out of the range of measured ones, where that is by design.

/// How a case begins, the measure (all for none), and the reason.
const REASONS: [(&str, Option<&str>, &str); 0] = [];

/// The reason why a tree misses a measure.
pub(super) fn reason(case: &str, measure: &str) -> String {
    let known = REASONS
        .iter()
        .find(|(start, of, _)| case.starts_with(start) && of.is_none_or(|of| of == measure));
    let why = known.map_or("not explained", |(_, _, why)| why);
    format!("{measure}, {case}: {why}")
}
