//! The tree of branches (the paper's *tree abstract data type*, section 4.1.2).

use super::shown::shown;
use crate::error::{LodError, Result};
use tree_core::{Foliage, NO_PARENT, Skeleton, Tree};

/// One module of a bracketed chain, as far as its branches are concerned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Token {
    /// `[`: a branch begins.
    Push,
    /// `]`: it ends.
    Pop,
    /// Any other module, with the length that it draws: 0 for all that do not advance.
    Module(f64),
}

/// Branches with their modules, lengths and children, in columns; parents come before their children.
#[derive(Clone, Debug, PartialEq)]
pub struct Adt {
    /// Parent of each branch; [`NO_PARENT`] for branch 0, the root.
    pub(super) parents: Vec<u32>,
    /// How many of the parent's modules come before each branch.
    pub(super) after: Vec<u32>,
    /// Where the modules of each branch begin in `modules`, and where the last ends.
    pub(super) starts: Vec<u32>,
    /// Modules of all branches: places in the chain, or nodes of the skeleton.
    pub(super) modules: Vec<u32>,
    /// Length of each branch alone.
    pub(super) lengths: Vec<f64>,
    /// Area that each branch alone shows from the side, with its own leaves.
    pub(super) areas: Vec<f64>,
    /// Where the children of each branch begin in `children`.
    pub(super) child_starts: Vec<u32>,
    /// Children in the order of the chain.
    pub(super) children: Vec<u32>,
}

impl Adt {
    /// The branches of a chain: one for each bracket, and one for what is in none (Fig. 2a). Modules are
    /// named by their places in the chain, brackets counted. All are equally wide: areas are lengths.
    ///
    /// # Errors
    /// [`LodError::Chain`] for brackets that do not match, a chain of 2³² modules or more, and lengths
    /// that are negative or not finite.
    ///
    /// # Complexity
    /// O(modules), no recursion.
    pub fn of_tokens(tokens: impl IntoIterator<Item = Token>) -> Result<Self> {
        let mut rows = Rows::default();
        let mut open = vec![rows.branch(NO_PARENT, 0)];
        for (module, token) in tokens.into_iter().enumerate() {
            let fail = |problem| Err(LodError::Chain { module, problem });
            let Ok(place) = u32::try_from(module) else {
                return fail("the chain is too long: 2³² modules at most");
            };
            let Some(&current) = open.last() else { return fail("']' without a '[' before it") };
            match token {
                Token::Push => {
                    let after = rows.n_modules[current as usize];
                    open.push(rows.branch(current, after));
                }
                Token::Pop if open.len() == 1 => return fail("']' without a '[' before it"),
                Token::Pop => {
                    open.pop();
                }
                Token::Module(length) if length >= 0.0 && length.is_finite() => {
                    rows.module(current, place, length);
                }
                Token::Module(_) => return fail("its length must be finite, 0 or more"),
            }
        }
        if open.len() > 1 {
            let module = rows.owners.len() + rows.parents.len();
            return Err(LodError::Chain { module, problem: "a '[' is never closed" });
        }
        Ok(rows.finish())
    }

    /// The branches of a skeleton: the runs of nodes between forks. Modules are its nodes; the length of a
    /// node is that of the segment to its parent, in metres. Areas are in m², as the wood is seen from the side: where
    /// branches lie before each other, they share what is seen.
    ///
    /// # Complexity
    /// O(nodes).
    #[must_use]
    pub fn of_skeleton(skeleton: &Skeleton) -> Self {
        Self::of_columns(skeleton, &Foliage::default())
    }

    /// As [`of_skeleton`](Self::of_skeleton); leaves hide and share too, and count among the areas of the branches that
    /// bear them.
    ///
    /// # Complexity
    /// O(nodes + leaves).
    #[must_use]
    pub fn of_tree(tree: &Tree) -> Self {
        Self::of_columns(tree.skeleton(), tree.foliage())
    }

    fn of_columns(skeleton: &Skeleton, foliage: &Foliage) -> Self {
        let (positions, parents) = (skeleton.positions(), skeleton.parents());
        let mut n_children = vec![0_u32; skeleton.len()];
        skeleton.segments().for_each(|(parent, _)| n_children[parent as usize] += 1);
        let mut rows = Rows::default();
        let mut branch_of = vec![rows.branch(NO_PARENT, 0)];
        rows.module(0, 0, 0.0);
        for node in 1..skeleton.len() {
            let parent = parents[node] as usize;
            let mut branch = branch_of[parent];
            if n_children[parent] != 1 {
                branch = rows.branch(branch, rows.n_modules[branch as usize]);
            }
            branch_of.push(branch);
            let length = (positions[node].as_dvec3() - positions[parent].as_dvec3()).length();
            rows.module(branch, node as u32, length);
        }
        let mut adt = rows.finish();
        let first = |node: usize| n_children[parents[node] as usize] != 1;
        adt.areas = shown(skeleton, foliage, &branch_of, adt.len(), first);
        adt
    }

    /// Number of branches, at least 1.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "the root is always there")]
    pub fn len(&self) -> usize {
        self.parents.len()
    }

    /// Parent of each branch; [`NO_PARENT`] for branch 0, the root.
    #[must_use]
    pub fn parents(&self) -> &[u32] {
        &self.parents
    }

    /// Length of each branch alone: the paper's l(n).
    #[must_use]
    pub fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    /// Area that each branch alone shows from the side, in m², with the leaves that it bears itself where they are known;
    /// of chains their lengths.
    #[must_use]
    pub fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// The modules of a branch; empty for one that is not there.
    #[must_use]
    pub fn modules(&self, branch: u32) -> &[u32] {
        row(&self.starts, &self.modules, branch)
    }

    /// The children of a branch, in the order of the chain.
    #[must_use]
    pub fn children(&self, branch: u32) -> &[u32] {
        row(&self.child_starts, &self.children, branch)
    }

    /// Whether a branch stems from the end of its parent, so that a path may lead on into it.
    pub(super) fn is_at_end(&self, branch: u32) -> bool {
        let parent = self.parents[branch as usize];
        self.after[branch as usize] as usize == self.modules(parent).len()
    }
}

fn row<'a>(starts: &[u32], values: &'a [u32], branch: u32) -> &'a [u32] {
    let branch = branch as usize;
    match (starts.get(branch), starts.get(branch + 1)) {
        (Some(&start), Some(&end)) => &values[start as usize..end as usize],
        _ => &[],
    }
}

/// Branches and modules as they are met.
#[derive(Default)]
struct Rows {
    parents: Vec<u32>,
    after: Vec<u32>,
    lengths: Vec<f64>,
    n_modules: Vec<u32>,
    /// The modules in the order of the chain: branch and place.
    owners: Vec<(u32, u32)>,
}

impl Rows {
    fn branch(&mut self, parent: u32, after: u32) -> u32 {
        self.parents.push(parent);
        self.after.push(after);
        self.lengths.push(0.0);
        self.n_modules.push(0);
        self.parents.len() as u32 - 1
    }

    fn module(&mut self, branch: u32, place: u32, length: f64) {
        self.owners.push((branch, place));
        self.lengths[branch as usize] += length;
        self.n_modules[branch as usize] += 1;
    }

    fn finish(self) -> Adt {
        let n = self.parents.len();
        let (starts, modules) = sorted(n, self.owners.iter().copied());
        let owned = self.parents.iter().zip(0..).skip(1).map(|(&parent, child)| (parent, child));
        let (child_starts, children) = sorted(n, owned);
        let Self { parents, after, lengths, .. } = self;
        let areas = lengths.clone();
        Adt { parents, after, starts, modules, lengths, areas, child_starts, children }
    }
}

/// Values sorted by owner into compressed rows, in their order.
fn sorted(n: usize, owned: impl Iterator<Item = (u32, u32)> + Clone) -> (Vec<u32>, Vec<u32>) {
    let mut starts = vec![0_u32; n + 1];
    let mut count = 0;
    for (owner, _) in owned.clone() {
        starts[owner as usize + 1] += 1;
        count += 1;
    }
    for i in 1..=n {
        starts[i] += starts[i - 1];
    }
    let mut next = starts.clone();
    let mut values = vec![0; count];
    for (owner, value) in owned {
        let at = &mut next[owner as usize];
        values[*at as usize] = value;
        *at += 1;
    }
    (starts, values)
}
