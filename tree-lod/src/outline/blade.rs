//! The best of all ways to simplify a blade.

use super::disc::Disc;
use super::judge::Judge;
use super::shape::Blade;
use super::{choice, collapse};

/// Most triangles of a blade for which choosing among its own triangles is worth a search.
const CHOICE_MAX: usize = 48;

/// At most so many triangles for each target, in rows of the blade's points. Where a blade cannot be
/// simplified so far it keeps the largest of its triangles.
pub(super) fn simplified(blade: &Blade, targets: &[usize], search: bool) -> Vec<Vec<[u32; 3]>> {
    let disc = Disc::of(blade);
    let judge = search.then(|| Judge::new(blade));
    let collapsed = collapse::collapsed(blade, targets);
    let one = |(&target, collapsed): (&usize, Vec<[u32; 3]>)| {
        if target == 0 {
            return Vec::new();
        }
        if target >= blade.triangles.len() {
            return blade.triangles.clone();
        }
        let polygon = disc.as_ref().and_then(|disc| disc.polygon(target, judge.as_ref()));
        let mut ways: Vec<Vec<[u32; 3]>> = polygon.into_iter().collect();
        if !collapsed.is_empty() && collapsed.len() <= target {
            ways.push(collapsed);
        }
        if ways.is_empty() {
            let judge = judge.as_ref().filter(|_| blade.triangles.len() <= CHOICE_MAX);
            ways.push(choice::chosen(blade, target, judge));
        }
        best(ways, judge.as_ref())
    };
    targets.iter().zip(collapsed).map(one).collect()
}

/// The way with the least error; the first without a judge.
fn best(ways: Vec<Vec<[u32; 3]>>, judge: Option<&Judge<'_>>) -> Vec<[u32; 3]> {
    let error = |way: &Vec<[u32; 3]>| judge.map_or(0.0, |judge| judge.error(way));
    let judged = ways.into_iter().map(|way| (error(&way), way));
    judged.reduce(|a, b| if b.0 < a.0 { b } else { a }).map(|(_, way)| way).unwrap_or_default()
}
