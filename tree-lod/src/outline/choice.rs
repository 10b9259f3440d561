//! Some of a blade's own triangles.
//!
//! For thin tubes and other pieces that neither are discs nor can be collapsed: a few of their
//! triangles, which grow as everything does, stand for all.

use super::judge::Judge;
use super::shape::Blade;

/// `target` triangles of the blade: greedily those that leave the least error, or the largest.
///
/// # Complexity
/// O(target × triangles) looks of the judge; O(triangles log triangles) without.
pub(super) fn chosen(blade: &Blade, target: usize, judge: Option<&Judge<'_>>) -> Vec<[u32; 3]> {
    let mut rows = Vec::new();
    let mut left: Vec<usize> = (0..blade.triangles.len()).collect();
    let Some(judge) = judge else {
        let size = |row: usize| blade.cross(blade.triangles[row]).length_squared();
        left.sort_by(|&a, &b| size(b).total_cmp(&size(a)));
        left.truncate(target);
        left.sort_unstable();
        return left.iter().map(|&row| blade.triangles[row]).collect();
    };
    while rows.len() < target && !left.is_empty() {
        let mut best = (f32::INFINITY, 0);
        for (i, &row) in left.iter().enumerate() {
            let with: Vec<_> = rows.iter().chain([&row]).map(|&r| blade.triangles[r]).collect();
            let error = judge.error(&with, best.0);
            if error < best.0 {
                best = (error, i);
            }
        }
        rows.push(left.remove(best.1));
    }
    rows.sort_unstable();
    rows.iter().map(|&row| blade.triangles[row]).collect()
}
