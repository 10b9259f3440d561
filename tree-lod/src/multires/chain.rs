//! The multiresolution chain (section 4.1.3).

use super::adt::Adt;
use super::order::Paths;
use crate::error::{LodError, Result};
use tree_core::NO_PARENT;

/// One module of a multi-chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Item {
    /// A module of the plain chain, by its place there.
    Module(u32),
    /// The turtle keeps its state under this number.
    Save(u32),
    /// The turtle goes back to the state of this number: a level begins.
    Restore(u32),
}

/// The modules of a chain, most relevant branches first. The first `k` levels are a prefix, and every prefix
/// that ends with a level is drawn by a turtle that knows `SAVE` and `RESTORE`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MultiChain {
    items: Vec<Item>,
    levels: Vec<u32>,
    n_states: u32,
}

impl MultiChain {
    /// Writes paths one after another. States have numbers from 0, branch by branch
    /// along the plain chain; only those that are needed are saved.
    ///
    /// # Errors
    /// [`LodError::Order`] for paths of another tree of branches.
    ///
    /// # Complexity
    /// O(modules).
    pub fn new(adt: &Adt, paths: &Paths) -> Result<Self> {
        check_paths(adt, paths)?;
        let forks = Forks::new(adt, paths);
        let mut items = Vec::with_capacity(adt.modules.len() + 2 * paths.len());
        let mut levels = Vec::with_capacity(paths.len());
        for path in paths.iter() {
            for (i, &branch) in path.iter().enumerate() {
                if i == 0 && adt.parents[branch as usize] != NO_PARENT {
                    items.push(Item::Restore(forks.state[branch as usize]));
                }
                forks.write(adt, branch, &mut items);
            }
            levels.push(items.len() as u32);
        }
        Ok(Self { items, levels, n_states: forks.n_states })
    }

    /// All items.
    #[must_use]
    pub fn items(&self) -> &[Item] {
        &self.items
    }

    /// Number of levels.
    #[must_use]
    pub fn n_levels(&self) -> usize {
        self.levels.len()
    }

    /// Number of states that a turtle has to keep at once.
    #[must_use]
    pub fn n_states(&self) -> u32 {
        self.n_states
    }

    /// The items of the first `n` levels, at most all.
    ///
    /// # Complexity
    /// O(1).
    #[must_use]
    pub fn prefix(&self, n: usize) -> &[Item] {
        let last = n.min(self.levels.len()).checked_sub(1);
        &self.items[..last.map_or(0, |last| self.levels[last] as usize)]
    }

    /// The items of one level; empty for one that is not there.
    #[must_use]
    pub fn level(&self, level: usize) -> &[Item] {
        self.prefix(level + 1).get(self.prefix(level).len()..).unwrap_or_default()
    }

    /// The chain as text; `module` writes a module of the plain chain.
    #[must_use]
    pub fn text(&self, n_levels: usize, mut module: impl FnMut(u32) -> String) -> String {
        let write = |item: &Item| match *item {
            Item::Module(place) => module(place),
            Item::Save(state) => format!("SAVE({state})"),
            Item::Restore(state) => format!("RESTORE({state})"),
        };
        self.prefix(n_levels).iter().map(write).collect()
    }
}

/// Checks that every branch is there once, after the one it stems from.
fn check_paths(adt: &Adt, paths: &Paths) -> Result<()> {
    let mut there = vec![false; adt.len()];
    for (row, &branch) in paths.branches().iter().enumerate() {
        let fail = |problem| Err(LodError::Order { row, problem });
        let Some(&parent) = adt.parents.get(branch as usize) else {
            return fail("there is no such branch: these are paths of another tree");
        };
        if there[branch as usize] || (parent != NO_PARENT && !there[parent as usize]) {
            return fail("a branch comes twice, or before the one it stems from");
        }
        there[branch as usize] = true;
    }
    match there.iter().position(|&there| !there) {
        Some(row) => Err(LodError::Order { row, problem: "a branch is missing" }),
        None => Ok(()),
    }
}

/// Where states are kept.
struct Forks {
    /// For each branch the state it stems from.
    state: Vec<u32>,
    /// For each branch: whether the paths before lead into it without a state.
    goes_on: Vec<bool>,
    n_states: u32,
}

impl Forks {
    fn new(adt: &Adt, paths: &Paths) -> Self {
        let mut goes_on = vec![false; adt.len()];
        paths.iter().flat_map(|path| &path[1..]).for_each(|&b| goes_on[b as usize] = true);
        let mut state = vec![u32::MAX; adt.len()];
        let mut n_states = 0;
        for parent in 0..adt.len() as u32 {
            // Children come in the order of the chain, so those of one fork are neighbours.
            let mut fork = None;
            for &child in adt.children(parent).iter().filter(|&&c| !goes_on[c as usize]) {
                let after = adt.after[child as usize];
                if fork != Some(after) {
                    n_states += 1;
                    fork = Some(after);
                }
                state[child as usize] = n_states - 1;
            }
        }
        Self { state, goes_on, n_states }
    }

    /// The modules of a branch, with a `SAVE` at each of its forks.
    fn write(&self, adt: &Adt, branch: u32, items: &mut Vec<Item>) {
        let modules = adt.modules(branch);
        let mut written = 0;
        let mut last = None;
        let stays = |child: &&u32| !self.goes_on[**child as usize];
        for &child in adt.children(branch).iter().filter(stays) {
            let state = self.state[child as usize];
            if last == Some(state) {
                continue;
            }
            let after = adt.after[child as usize] as usize;
            items.extend(modules[written..after].iter().map(|&place| Item::Module(place)));
            items.push(Item::Save(state));
            (written, last) = (after, Some(state));
        }
        items.extend(modules[written..].iter().map(|&place| Item::Module(place)));
    }
}
