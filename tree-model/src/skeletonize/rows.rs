//! Two small tools of all steps: disjoint sets, and rows of things that share a label.

/// Disjoint sets of `0..n`; the smallest member names its set, whatever the order of joins.
#[derive(Debug)]
pub(super) struct Sets(Vec<u32>);

impl Sets {
    pub(super) fn new(n: usize) -> Self {
        Self((0..n as u32).collect())
    }

    pub(super) fn find(&mut self, mut a: u32) -> u32 {
        while self.0[a as usize] != a {
            let above = self.0[self.0[a as usize] as usize];
            self.0[a as usize] = above;
            a = above;
        }
        a
    }

    pub(super) fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.find(a), self.find(b));
        let (low, high) = (a.min(b), a.max(b));
        self.0[high as usize] = low;
    }

    /// Numbers the sets from 0 in the order of their smallest members; returns each one's number
    /// and how many sets there are.
    pub(super) fn labels(mut self) -> (Vec<u32>, usize) {
        let mut labels = vec![0; self.0.len()];
        let mut n = 0;
        for i in 0..self.0.len() as u32 {
            let root = self.find(i);
            labels[i as usize] = if root == i {
                n += 1;
                n - 1
            } else {
                labels[root as usize]
            };
        }
        (labels, n as usize)
    }
}

/// Items `0..labels.len()` sorted by label, in compressed rows.
#[derive(Debug)]
pub(super) struct Rows {
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Rows {
    /// Groups items by label, which must be below `n`; items keep their order.
    pub(super) fn new(labels: &[u32], n: usize) -> Self {
        Self::of_pairs(labels.iter().zip(0..).map(|(&label, item)| (label, item)), n)
    }

    /// Groups (label, item) pairs by label.
    pub(super) fn of_pairs(pairs: impl Iterator<Item = (u32, u32)> + Clone, n: usize) -> Self {
        let mut starts = vec![0_u32; n + 1];
        for (label, _) in pairs.clone() {
            starts[label as usize + 1] += 1;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        let mut items = vec![0; starts[n] as usize];
        for (label, item) in pairs {
            let slot = &mut next[label as usize];
            items[*slot as usize] = item;
            *slot += 1;
        }
        Self { starts, items }
    }

    pub(super) fn of(&self, label: u32) -> &[u32] {
        let label = label as usize;
        &self.items[self.starts[label] as usize..self.starts[label + 1] as usize]
    }

    pub(super) fn len(&self) -> usize {
        self.starts.len() - 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_are_numbered_by_their_smallest_member() {
        let mut sets = Sets::new(6);
        sets.join(5, 1);
        sets.join(4, 3);
        sets.join(3, 5);
        assert_eq!(sets.labels(), (vec![0, 1, 2, 1, 1, 1], 3));
    }

    #[test]
    fn rows_keep_the_order_of_items() {
        let rows = Rows::new(&[1, 0, 1, 1], 3);
        assert_eq!((rows.of(0), rows.of(1), rows.of(2)), (&[1][..], &[0, 2, 3][..], &[][..]));
    }
}
