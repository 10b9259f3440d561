//! Skeletons from rows in any order, as files bring them.

use super::{NO_PARENT, Skeleton, check_columns};
use crate::error::{CoreError, Result};
use glam::Vec3;

/// A skeleton brought into parents-first order.
#[derive(Clone, Debug, PartialEq)]
pub struct Reordered {
    /// The skeleton.
    pub skeleton: Skeleton,
    /// For each node, the input row it came from.
    pub rows: Vec<u32>,
}

impl Skeleton {
    /// Makes a skeleton of rows in any order. The order is kept where it is parents-first already;
    /// otherwise nodes come breadth-first, siblings in the order of their rows.
    ///
    /// # Errors
    /// As [`Skeleton::from_columns`], with [`CoreError::NoRoot`] and [`CoreError::Cycle`] besides;
    /// nodes are named by input row.
    ///
    /// # Complexity
    /// O(rows) time and memory.
    pub fn from_unordered(
        positions: Vec<Vec3>,
        radii: Vec<f32>,
        parents: Vec<u32>,
    ) -> Result<Reordered> {
        check_columns(&positions, &radii, parents.len())?;
        let root = find_root(&parents)?;
        let in_order = root == 0 && (1..parents.len()).all(|row| (parents[row] as usize) < row);
        if in_order {
            let rows = (0..parents.len() as u32).collect();
            return Ok(Reordered { skeleton: Self { positions, radii, parents }, rows });
        }
        let rows = breadth_first(&parents, root)?;
        let mut node_of_row = vec![NO_PARENT; rows.len()];
        for (node, &row) in rows.iter().enumerate() {
            node_of_row[row as usize] = node as u32;
        }
        let pick = |row: &u32| *row as usize;
        let skeleton = Self {
            positions: rows.iter().map(|row| positions[pick(row)]).collect(),
            radii: rows.iter().map(|row| radii[pick(row)]).collect(),
            parents: rows
                .iter()
                .map(|row| match parents[pick(row)] {
                    NO_PARENT => NO_PARENT,
                    parent => node_of_row[parent as usize],
                })
                .collect(),
        };
        Ok(Reordered { skeleton, rows })
    }
}

/// The one row without parent; parents must name rows that exist.
fn find_root(parents: &[u32]) -> Result<usize> {
    let mut root = None;
    for (node, &parent) in parents.iter().enumerate() {
        if parent == NO_PARENT {
            if root.is_some() {
                return Err(CoreError::SecondRoot { node });
            }
            root = Some(node);
        } else if parent as usize >= parents.len() {
            return Err(CoreError::ParentOrder { node, parent });
        }
    }
    root.ok_or(CoreError::NoRoot)
}

/// Rows in breadth-first order; rows never reached lie on or behind a cycle.
fn breadth_first(parents: &[u32], root: usize) -> Result<Vec<u32>> {
    let mut first_child = vec![NO_PARENT; parents.len()];
    let mut next_sibling = vec![NO_PARENT; parents.len()];
    for row in (0..parents.len()).rev().filter(|&row| row != root) {
        let parent = parents[row] as usize;
        next_sibling[row] = first_child[parent];
        first_child[parent] = row as u32;
    }
    let mut rows = Vec::with_capacity(parents.len());
    let mut seen = vec![false; parents.len()];
    rows.push(root as u32);
    seen[root] = true;
    let mut head = 0;
    while head < rows.len() {
        let mut child = first_child[rows[head] as usize];
        while child != NO_PARENT {
            rows.push(child);
            seen[child as usize] = true;
            child = next_sibling[child as usize];
        }
        head += 1;
    }
    match seen.iter().position(|&reached| !reached) {
        Some(row) => Err(CoreError::Cycle { node: walk_into_cycle(parents, row) }),
        None => Ok(rows),
    }
}

/// From a row behind a cycle to a row on it: as many steps up as there are rows end on the cycle.
fn walk_into_cycle(parents: &[u32], mut row: usize) -> usize {
    for _ in 0..parents.len() {
        row = parents[row] as usize;
    }
    row
}
