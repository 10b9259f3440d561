//! Corners of faces: their indices as text, and the vertices they become.

use glam::{Vec2, Vec3};
use rayon::prelude::*;

/// Stands for a texture coordinate or normal that is not given.
pub(super) const NONE: u32 = u32::MAX;

/// Rows of position, texture coordinate and normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Corner {
    pub(super) position: u32,
    pub(super) uv: u32,
    pub(super) normal: u32,
}

/// `v`, `v/vt`, `v//vn` or `v/vt/vn`, counted from 1 or backwards from −1, among so many rows.
pub(super) fn corner(word: &str, counts: [usize; 3]) -> Result<Corner, String> {
    let mut rows = [NONE; 3];
    let mut parts = word.split('/');
    for ((row, count), what) in rows.iter_mut().zip(counts).zip(["v", "vt", "vn"]) {
        let Some(part) = parts.next() else { break };
        if !part.is_empty() {
            *row = index(part, count).ok_or_else(|| {
                let part: String = part.chars().take(20).collect();
                format!("'{part}' is no {what}; {count} come before the face, counted from 1")
            })?;
        }
    }
    let [position, uv, normal] = rows;
    if position == NONE || parts.next().is_some() {
        let word: String = word.chars().take(40).collect();
        return Err(format!("'{word}' is no corner: v, v/vt, v//vn or v/vt/vn is read"));
    }
    Ok(Corner { position, uv, normal })
}

fn index(text: &str, count: usize) -> Option<u32> {
    let number: i64 = text.parse().ok()?;
    let count = i64::try_from(count).ok()?;
    let row = if number < 0 { count.checked_add(number)? } else { number.checked_sub(1)? };
    let exists = (0..count).contains(&row) && row < i64::from(NONE);
    exists.then(|| u32::try_from(row).ok()).flatten()
}

/// Corners that are equal become one vertex. Returns the first corner of each vertex, in order, and the
/// vertex of each corner.
///
/// # Complexity
/// O(n log n): sorted, as chains of equal positions would be quadratic for hostile files.
pub(super) fn weld(corners: &[Corner]) -> (Vec<Corner>, Vec<u32>) {
    let mut order: Vec<u32> = (0..corners.len() as u32).collect();
    order.par_sort_unstable_by_key(|&i| (corners[i as usize], i));
    // For each corner the first that is equal, which is the first of its run.
    let mut first: Vec<u32> = vec![0; corners.len()];
    let mut run = 0;
    for (place, &i) in order.iter().enumerate() {
        if place == 0 || corners[i as usize] != corners[run as usize] {
            run = i;
        }
        first[i as usize] = run;
    }
    let mut vertices = Vec::new();
    for i in 0..corners.len() {
        let equal = first[i] as usize;
        // Those before are numbers of vertices already.
        first[i] = if equal == i {
            vertices.push(corners[i]);
            vertices.len() as u32 - 1
        } else {
            first[equal]
        };
    }
    (vertices, first)
}

/// What a file lists.
#[derive(Debug, Default)]
pub(super) struct Lists {
    pub(super) positions: Vec<Vec3>,
    pub(super) uvs: Vec<Vec2>,
    pub(super) normals: Vec<Vec3>,
}

impl Lists {
    pub(super) fn counts(&self) -> [usize; 3] {
        [self.positions.len(), self.uvs.len(), self.normals.len()]
    }
}
