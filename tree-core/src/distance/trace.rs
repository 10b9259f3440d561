//! The mapping: the choices of the recurrences, followed back from the roots.

use super::costs::EditCosts;
use super::matching::Matcher;
use super::table::Table;

/// Two subtrees or the two forests below them.
enum Pair {
    Trees(usize, usize),
    Forests(usize, usize),
}

impl<C: EditCosts> Table<'_, C> {
    /// The pairs of nodes changed into one another, rising. All rows must have been kept.
    pub(super) fn trace(&self) -> Vec<[u32; 2]> {
        let mut mapping = Vec::new();
        let mut stack = vec![Pair::Trees(0, 0)];
        let mut matcher = Matcher::default();
        while let Some(pair) = stack.pop() {
            match pair {
                Pair::Trees(i, j) => self.trace_trees(i, j, &mut mapping, &mut stack),
                Pair::Forests(i, j) => self.trace_forests(i, j, &mut matcher, &mut stack),
            }
        }
        mapping.sort_unstable();
        mapping
    }

    fn trace_trees(&self, i: usize, j: usize, mapping: &mut Vec<[u32; 2]>, stack: &mut Vec<Pair>) {
        let changed = self.forest(i, j) + self.costs.change(i as u32, j as u32);
        let (into, t) = self.tree_in_second(i, j);
        let (from, s) = self.tree_in_first(i, j);
        if changed <= into.min(from) {
            mapping.push([i as u32, j as u32]);
            stack.push(Pair::Forests(i, j));
        } else if into <= from {
            stack.push(Pair::Trees(i, t as usize));
        } else {
            stack.push(Pair::Trees(s as usize, j));
        }
    }

    fn trace_forests(&self, i: usize, j: usize, matcher: &mut Matcher, stack: &mut Vec<Pair>) {
        let (below_i, below_j) = (self.first.children(i), self.second.children(j));
        if below_i.is_empty() || below_j.is_empty() {
            return;
        }
        let matched = self.matched(i, j, matcher);
        let (into, t) = self.forest_in_second(i, j);
        let (from, s) = self.forest_in_first(i, j);
        if matched <= into.min(from) {
            let saving = |a: usize, b: usize| self.saving(below_i[a], below_j[b]);
            matcher.pair(below_i.len(), below_j.len(), saving);
            stack.extend(
                matcher
                    .pairs
                    .iter()
                    .map(|&(a, b)| Pair::Trees(below_i[a] as usize, below_j[b] as usize)),
            );
        } else if into <= from {
            stack.push(Pair::Forests(i, t as usize));
        } else {
            stack.push(Pair::Forests(s as usize, j));
        }
    }
}
