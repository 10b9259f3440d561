//! The best of all ways to simplify a blade.

use super::disc::Disc;
use super::judge::Judge;
use super::polish::{Way, polished};
use super::shape::Blade;
use super::{choice, collapse};
use glam::Vec3;

/// Most triangles of a blade for which choosing among its own triangles is worth a search.
const CHOICE_MAX: usize = 48;

/// At most so many triangles for each target, in rows of the blade's points. Where a blade cannot be
/// simplified so far it keeps the largest of its triangles.
pub(super) fn simplified(blade: &Blade, targets: &[usize], search: bool) -> Vec<Vec<[u32; 3]>> {
    let disc = Disc::of(blade);
    let up = disc.as_ref().map(|disc| disc.normal);
    let judge = search.then(|| Judge::new(blade, false));
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
        let faces_up = |t: &[u32; 3]| up.is_none_or(|up| blade.cross(*t).dot(up) > 0.0);
        if !collapsed.is_empty() && collapsed.len() <= target && collapsed.iter().all(faces_up) {
            ways.push(collapsed);
        }
        if ways.is_empty() {
            let judge = judge.as_ref().filter(|_| blade.triangles.len() <= CHOICE_MAX);
            ways.push(choice::chosen(blade, target, judge));
        }
        best(blade, ways, judge.as_ref(), up)
    };
    targets.iter().zip(collapsed).map(one).collect()
}

/// The way with the least error, after all changes that help; the first without a judge.
fn best(
    blade: &Blade,
    ways: Vec<Vec<[u32; 3]>>,
    judge: Option<&Judge<'_>>,
    up: Option<Vec3>,
) -> Vec<[u32; 3]> {
    let Some(judge) = judge else { return ways.into_iter().next().unwrap_or_default() };
    let second = Judge::new(blade, true);
    let plain =
        |triangles: Vec<[u32; 3]>| Way { error: judge.error(&triangles, f32::INFINITY), triangles };
    let both = ways.into_iter().map(plain).flat_map(|way| {
        let other = polished(blade, judge, way.clone(), up);
        [way, other]
    });
    // What a search found by luck of its views, other views show to be worse.
    let judged = both.map(|way| (way.error + second.error(&way.triangles, f32::INFINITY), way));
    let least = judged.reduce(|a, b| if b.0 < a.0 { b } else { a });
    least.map(|(_, way)| way.triangles).unwrap_or_default()
}
