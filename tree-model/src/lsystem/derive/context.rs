//! Neighbours across branches, as in the bracketed L-systems of ABOP, section 1.8.
//!
//! The left context of a module is the way back to the root of the tree: branches that end before it are
//! skipped, and a module at the beginning of a branch continues the branch it sits on. The right context
//! follows the same axis away from the root: branches are skipped, unless the context has brackets itself; then
//! the branches at that place are searched in order for one that begins as the context says.

use super::choose::Scratch;
use super::pass::Pass;
use crate::error::{ModelError, Result};
use crate::lsystem::grammar::{Item, Rule};
use crate::lsystem::{Symbols, Word};

/// Branches and unseen modules that one context with brackets looks past, at most: without an end to it, a long
/// row of them would take time with the square of its length.
const MOST_SEARCHED: u32 = 4096;
/// No neighbour.
const NONE: u32 = u32::MAX;

/// For each module its neighbours among those that contexts see.
pub(super) struct Neighbours {
    /// Towards the root.
    left: Vec<u32>,
    /// Away from the root on the same axis; of a `[`, the first module of its branch.
    right: Vec<u32>,
    /// Of a `[`, its `]`.
    close: Vec<u32>,
    /// Where the parameters begin.
    params: Vec<u32>,
    seen: Vec<bool>,
}

impl Neighbours {
    /// Reads the word once from each end.
    pub(super) fn new(word: &Word, symbols: &Symbols, seen: Vec<bool>) -> Result<Self> {
        let n = word.len();
        if n.max(word.params().len()) >= NONE as usize {
            let problem = format!("a word with contexts can have at most {NONE} modules");
            return Err(ModelError::Word { module: NONE as usize, problem });
        }
        let mut all = Self {
            left: vec![NONE; n],
            right: vec![NONE; n],
            close: vec![NONE; n],
            params: Vec::with_capacity(n),
            seen,
        };
        let (mut open, mut last, mut at) = (Vec::new(), NONE, 0);
        for (i, &kind) in word.kinds().iter().enumerate() {
            all.params.push(at);
            at += symbols.arity(kind) as u32;
            all.left[i] = last;
            match kind {
                Symbols::PUSH => open.push((i, last)),
                Symbols::POP => {
                    let Some((start, before)) = open.pop() else { continue };
                    all.close[start] = i as u32;
                    last = before;
                }
                _ if all.sees(kind) => last = i as u32,
                _ => {}
            }
        }
        let (mut open, mut next) = (Vec::new(), NONE);
        for (i, &kind) in word.kinds().iter().enumerate().rev() {
            all.right[i] = next;
            match kind {
                Symbols::POP => {
                    open.push(next);
                    next = NONE;
                }
                Symbols::PUSH => next = open.pop().unwrap_or(NONE),
                _ if all.sees(kind) => next = i as u32,
                _ => {}
            }
        }
        Ok(all)
    }

    fn sees(&self, kind: crate::lsystem::Kind) -> bool {
        self.seen.get(usize::from(kind.0)).copied().unwrap_or(true)
    }
}

fn at(column: &[u32], i: u32) -> u32 {
    column.get(i as usize).copied().unwrap_or(NONE)
}

impl Pass<'_> {
    /// Whether the contexts of a rule match; the modules matched are left in the scratch space.
    pub(super) fn matches(&self, rule: &Rule, module: usize, scratch: &mut Scratch) -> bool {
        scratch.matched.clear();
        let Some(neighbours) = &self.neighbours else { return false };
        let kinds = self.word.kinds();
        let mut place = module as u32;
        for &kind in &rule.left {
            place = at(&neighbours.left, place);
            if kinds.get(place as usize) != Some(&kind) {
                return false;
            }
            scratch.matched.push(place);
        }
        let mut left_to_search = MOST_SEARCHED;
        self.matches_right(neighbours, &rule.right, module as u32, scratch, &mut left_to_search)
    }

    /// Matches items behind a place. It recurses into branches, as deep as the grammar's reader allows.
    fn matches_right(
        &self,
        neighbours: &Neighbours,
        items: &[Item],
        from: u32,
        scratch: &mut Scratch,
        left_to_search: &mut u32,
    ) -> bool {
        let kinds = self.word.kinds();
        // The last module matched, and how far the branches behind it were searched.
        let (mut axis, mut searched) = (from, from);
        let mut i = 0;
        while let Some(&item) = items.get(i) {
            i += 1;
            match item {
                Item::Module(kind) => {
                    axis = at(&neighbours.right, axis);
                    searched = axis;
                    if kinds.get(axis as usize) != Some(&kind) {
                        return false;
                    }
                    scratch.matched.push(axis);
                }
                Item::Open(n) => {
                    let inside = items.get(i..i + n).unwrap_or_default();
                    i += n + 1;
                    loop {
                        let branch = self.next_branch(neighbours, searched, left_to_search);
                        let Some(branch) = branch else { return false };
                        searched = at(&neighbours.close, branch);
                        let n_matched = scratch.matched.len();
                        if self.matches_right(neighbours, inside, branch, scratch, left_to_search) {
                            break;
                        }
                        scratch.matched.truncate(n_matched);
                    }
                }
                Item::Close => {}
            }
        }
        true
    }

    /// The next branch behind a place, before the next module of the axis.
    fn next_branch(
        &self,
        neighbours: &Neighbours,
        behind: u32,
        left_to_search: &mut u32,
    ) -> Option<u32> {
        let mut place = behind.checked_add(1)?;
        loop {
            *left_to_search = left_to_search.checked_sub(1)?;
            match *self.word.kinds().get(place as usize)? {
                Symbols::PUSH => return Some(place),
                Symbols::POP => return None,
                kind if neighbours.sees(kind) => return None,
                _ => place += 1,
            }
        }
    }

    /// Parameters of any module of the word.
    pub(super) fn params_of(&self, module: u32) -> &[f64] {
        let Some(neighbours) = &self.neighbours else { return &[] };
        let start = at(&neighbours.params, module) as usize;
        let kind = self.word.kinds().get(module as usize);
        self.params(start..start + kind.map_or(0, |&kind| self.symbols.arity(kind)))
    }
}
