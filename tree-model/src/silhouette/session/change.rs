//! What an edit changed.

use crate::silhouette::plan::{Lateral, Plan};
use std::collections::BTreeMap;

/// What an edit changed. Branches are named by their ids, in rising order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Change {
    /// Branches that are new.
    pub added: Vec<u32>,
    /// Branches that are gone.
    pub removed: Vec<u32>,
    /// Branches whose line, outline or place is another.
    pub reshaped: Vec<u32>,
    /// Branches that bear a drawn system which they did not, or another one, or take their style from elsewhere.
    pub restyled: Vec<u32>,
    /// Whether the trunk or the crown is another.
    pub trunk: bool,
    /// Whether the leaf is another.
    pub leaf: bool,
    /// What was repaired in the stroke, in sentences.
    pub repairs: Vec<String>,
}

impl Change {
    /// Whether nothing changed. Repairs do not count.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        let branches = [&self.added, &self.removed, &self.reshaped, &self.restyled];
        branches.iter().all(|ids| ids.is_empty()) && !self.trunk && !self.leaf
    }

    /// The difference of two plans.
    pub(super) fn between(before: Option<&Plan>, after: Option<&Plan>) -> Self {
        let (old, new) = (branches(before), branches(after));
        let mut change = Self {
            trunk: before
                .map(|plan| (&plan.system.axis, &plan.system.outline, &plan.system.sections))
                != after
                    .map(|plan| (&plan.system.axis, &plan.system.outline, &plan.system.sections)),
            leaf: before.and_then(|plan| plan.leaf.as_ref())
                != after.and_then(|plan| plan.leaf.as_ref()),
            ..Self::default()
        };
        change.removed.extend(old.keys().filter(|id| !new.contains_key(id)));
        for (&id, now) in &new {
            let Some(then) = old.get(&id) else {
                change.added.push(id);
                continue;
            };
            let place = |lateral: &Lateral| (lateral.t, lateral.left, lateral.azimuth);
            if then.line != now.line || then.outline != now.outline || place(then) != place(now) {
                change.reshaped.push(id);
            }
            let system = |lateral: &Lateral| {
                lateral.system.as_ref().map(|system| (system.axis.clone(), system.outline.clone()))
            };
            if system(then) != system(now) || then.style != now.style {
                change.restyled.push(id);
            }
        }
        change
    }
}

/// All branches of a plan by id.
fn branches(plan: Option<&Plan>) -> BTreeMap<u32, &Lateral> {
    let mut out = BTreeMap::new();
    let mut open: Vec<&Lateral> = plan.iter().flat_map(|plan| &plan.system.laterals).collect();
    while let Some(lateral) = open.pop() {
        open.extend(lateral.system.iter().flat_map(|system| &system.laterals));
        out.insert(lateral.id, lateral);
    }
    out
}
