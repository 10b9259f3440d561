//! Where the tree stands in a photograph with sky: between which columns, above which horizon, its trunk.

use super::colors::Colors;
use super::palette::{Palette, likelihoods, samples};
use super::sky::{Sky, distance};
use glam::Vec2;

/// Rise of the skyline, as a share of the picture's height, that ends a tree's flank: something else
/// begins there.
const RISE: f32 = 0.06;
/// The picture's width over the longest branch that sticks out alone.
const BRANCH: usize = 10;
/// How much a column's distance from the middle counts against its height, when the tree is looked for.
const CENTRALITY: f32 = 0.5;
/// Rows of a band below the horizon, as a share of the picture's height: the ground, hedges and fences
/// change from row to row, but hardly within it.
const BAND: f32 = 0.05;
/// Share of the widest row of the crown at which the crown ends below.
const CROWN_END: f32 = 0.3;
/// The picture's height over the least height of sky that is seen through a crown for certain.
const GAP: usize = 50;
/// The picture's height over the least height of sky below a crown: more than gaps in it.
const OPEN: usize = 10;
/// Log likelihood ratio by which the middle of the tree is more likely tree than its sides.
const PRIOR: f32 = 4.0;
/// Contrast of a trunk to its sides at which it counts for as much as its absence against.
const TRUNK_CONTRAST: f32 = 0.1;
/// Contrast above which more counts no more.
const MOST_CONTRAST: f32 = 0.3;
/// What a step aside costs, in contrast.
const BEND: f32 = 0.06;
/// Half widths of trunks that are looked for, in pixels of the scene.
const TRUNK_HALVES: [usize; 4] = [1, 2, 4, 7];

/// The tree's place.
pub(super) struct Scene {
    /// First and last column of the tree.
    pub(super) left: usize,
    pub(super) right: usize,
    /// For each column, the row where what is behind the tree begins to be something else than sky.
    pub(super) horizon: Vec<usize>,
    /// Log likelihood ratio of tree to background, averaged over a small neighbourhood; below the horizon.
    pub(super) ratio: Vec<f32>,
    /// For each column, its first row that is not sky.
    skyline: Vec<usize>,
    /// For each column, the last row of sky that is no gap in the crown; 0 without.
    under_sky: Vec<usize>,
    /// Last row of the crown.
    pub(super) crown_end: usize,
    /// The trunk: column and half its width, for each row from the first on.
    pub(super) trunk_top: usize,
    pub(super) trunk: Vec<(usize, usize)>,
}

impl Scene {
    /// Looks for the tree; `None` when nothing stands before the sky.
    pub(super) fn find(colors: &Colors, sky: &Sky) -> Option<Self> {
        let (w, h) = (colors.width, colors.height);
        let solid = largest(&(0..w * h).map(|i| !sky.is_sky(i)).collect::<Vec<_>>(), w, h);
        let skyline = skyline(&solid, w, h);
        let score = |x: usize| {
            let off = (x as f32 + 0.5) / w as f32 - 0.5;
            skyline[x] as f32 / h as f32 + CENTRALITY * off.abs()
        };
        let peak = (0..w).min_by(|&a, &b| score(a).total_cmp(&score(b)))?;
        if skyline[peak] + 8 > h {
            return None;
        }
        let rise = (RISE * h as f32) as usize;
        let left = flank((0..=peak).rev(), &skyline, rise);
        let right = flank(peak..w, &skyline, rise);
        let (low, high) = (skyline[left], skyline[right]);
        let line = |x: usize| {
            let t = x.saturating_sub(left) as f32 / (right - left).max(1) as f32;
            (low as f32 + t.min(1.0) * (high as f32 - low as f32)) as usize
        };
        let gaps = last_sky(sky, w, h, (h / GAP).max(2));
        let horizon = (0..w).map(|x| gaps[x].max(line(x))).collect();
        let mut scene = Self {
            left,
            right,
            horizon,
            ratio: Vec::new(),
            skyline,
            under_sky: last_sky(sky, w, h, (h / OPEN).max(2)),
            crown_end: h - 1,
            trunk_top: h,
            trunk: Vec::new(),
        };
        scene.ratio = scene.ratios(colors, sky);
        scene.crown_end = scene.find_crown_end(w, h, sky);
        scene.find_trunk(colors);
        Some(scene)
    }

    /// Row where the trunk meets the ground, or the crown where there is no trunk.
    pub(super) fn base(&self) -> usize {
        self.crown_end.max((self.trunk_top + self.trunk.len()).saturating_sub(1))
    }

    /// Where the trunk ends below; `None` without a trunk.
    pub(super) fn base_point(&self) -> Option<Vec2> {
        let &(x, _) = self.trunk.last()?;
        Some(Vec2::new(x as f32 + 0.5, (self.trunk_top + self.trunk.len()) as f32))
    }

    /// How much more each pixel below the horizon looks like the crown than like what is beside the tree
    /// in the same rows.
    fn ratios(&self, colors: &Colors, sky: &Sky) -> Vec<f32> {
        let (w, h) = (colors.width, colors.height);
        let inside = |i: usize| (self.left..=self.right).contains(&(i % w));
        let tree = samples(colors, |i| inside(i) && i / w < self.horizon[i % w] && sky.is_not(i));
        let tree = likelihoods(colors, &Palette::new(&tree));
        let mut ratio = vec![0.0; w * h];
        let band = ((BAND * h as f32) as usize).max(2);
        let middle = 0.5 * (self.left + self.right) as f32;
        let top = self.horizon.iter().copied().min().unwrap_or(0);
        for first in (top..h).step_by(band) {
            let rows = first.saturating_sub(band)..(first + 2 * band).min(h);
            // Beside the tree; and the bottom of the picture, below most trees.
            let behind = samples(colors, |i| {
                let (x, y) = (i % w, i / w);
                let below = self.under_sky[x] > self.skyline[x] && y > self.under_sky[x];
                (rows.contains(&y) && (!inside(i) || below) && !sky.is_sky(i)) || y + band / 2 >= h
            });
            let palette = Palette::new(&behind);
            for y in first..(first + band).min(h) {
                for x in 0..w {
                    let i = y * w + x;
                    let r = tree[i] - palette.log_likelihood(colors.rgb[i]);
                    let off = 2.0 * (x as f32 - middle) / (self.right - self.left).max(1) as f32;
                    ratio[i] = r.clamp(-8.0, 8.0) + PRIOR * (0.5 - off.abs());
                }
            }
        }
        blurred(&ratio, w, h, 3)
    }

    fn find_crown_end(&self, w: usize, h: usize, sky: &Sky) -> usize {
        let covered = |y: usize| {
            (self.left..=self.right)
                .filter(|&x| {
                    let i = y * w + x;
                    if y < self.horizon[x] { !sky.is_sky(i) } else { self.ratio[i] > 0.0 }
                })
                .count()
        };
        let rows: Vec<usize> = (0..h).map(covered).collect();
        let Some(widest) = (0..h).max_by_key(|&y| (rows[y], h - y)) else { return 0 };
        let least = (CROWN_END * rows[widest] as f32) as usize;
        (widest..h).take_while(|&y| rows[y] > least).last().unwrap_or(widest)
    }

    /// The trunk below the crown: the path downwards of most contrast to both sides.
    fn find_trunk(&mut self, colors: &Colors) {
        let (w, h) = (colors.width, colors.height);
        let colors = blurred_down(colors, (h / 100).max(1));
        let margin = (self.right - self.left) / 5;
        let columns = self.left + margin..(self.right - margin).max(self.left + margin + 1);
        // It is looked for from a little above the crown's end.
        let top = self.crown_end.saturating_sub(h / 20);
        let best = TRUNK_HALVES
            .map(|half| (follow_down(&colors, half, columns.clone(), top), half))
            .into_iter()
            .max_by(|(a, _), (b, _)| a.score.total_cmp(&b.score));
        if let Some((path, half)) = best
            && top + path.columns.len() > self.crown_end + 2
        {
            self.trunk_top = top;
            self.trunk = path.columns.iter().map(|&x| (x.min(w - 1), half)).collect();
        }
    }
}

/// A path downwards.
struct Path {
    score: f32,
    columns: Vec<usize>,
}

/// The best path of a trunk of this half width: one column for each row from `top` to its end.
fn follow_down(colors: &Colors, half: usize, range: std::ops::Range<usize>, top: usize) -> Path {
    let n = range.len();
    let mut best = vec![0.0_f32; n];
    let mut steps: Vec<Vec<i8>> = Vec::new();
    let (mut score, mut x, mut last) = (0.0, 0, None);
    for y in top..colors.height {
        let before = best.clone();
        let from = |x: usize, step: i8| {
            let at = x.checked_add_signed(step.into()).filter(|&x| x < n)?;
            Some((before[at] - BEND * f32::from(step.abs()), step))
        };
        let mut row = Vec::with_capacity(n);
        for (i, best) in best.iter_mut().enumerate() {
            let ways = [1, -1, 0].into_iter().filter_map(|step| from(i, step));
            let (sum, step) = ways.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((0.0, 0));
            let off = ((i as f32 + 0.5) / n as f32 - 0.5).abs();
            let gain = ridge(colors, range.start + i, y, half).min(MOST_CONTRAST);
            *best = sum + gain - TRUNK_CONTRAST * (1.0 + off);
            row.push(step);
            if *best > score {
                (score, x, last) = (*best, i, Some(y));
            }
        }
        steps.push(row);
    }
    let mut columns = Vec::new();
    if let Some(last) = last {
        for row in steps[..=last - top].iter().rev() {
            columns.push(range.start + x);
            x = x.wrapping_add_signed(row[x].into());
        }
    }
    columns.reverse();
    Path { score, columns }
}

/// Each pixel the mean of those above and below it: a trunk stays, grass does not.
fn blurred_down(colors: &Colors, radius: usize) -> Colors {
    let (width, height) = (colors.width, colors.height);
    let mut rgb = Vec::with_capacity(colors.rgb.len());
    for y in 0..height {
        let rows = y.saturating_sub(radius)..(y + radius + 1).min(height);
        for x in 0..width {
            let mut sum = [0.0_f32; 3];
            for row in rows.clone() {
                for (s, c) in sum.iter_mut().zip(colors.rgb[row * width + x]) {
                    *s += c / rows.len() as f32;
                }
            }
            rgb.push(sum);
        }
    }
    Colors { width, height, rgb }
}

/// How much a strip of a row differs from what is left and right of it: the smaller of both.
fn ridge(colors: &Colors, x: usize, y: usize, half: usize) -> f32 {
    let w = colors.width;
    if x < 3 * half + 2 || x + 3 * half + 2 >= w {
        return 0.0;
    }
    let mean = |from: usize, to: usize| {
        let mut sum = [0.0_f32; 3];
        for color in &colors.rgb[y * w + from..=y * w + to] {
            for (s, c) in sum.iter_mut().zip(color) {
                *s += c / (to - from + 1) as f32;
            }
        }
        sum
    };
    let own = mean(x - half / 2, x + half / 2);
    let left = mean(x - 3 * half - 1, x - half - 1);
    let right = mean(x + half + 1, x + 3 * half + 1);
    distance(own, left).min(distance(own, right))
}

/// For each column, the first row from which on it is solid for a while.
fn skyline(solid: &[bool], w: usize, h: usize) -> Vec<usize> {
    let run = (h / 60).max(2);
    let starts = |x: usize, y: usize| (y..(y + run).min(h)).all(|y| solid[y * w + x]);
    (0..w).map(|x| (0..h).find(|&y| starts(x, y)).unwrap_or(h - 1)).collect()
}

/// For each column, the last row of the lowest run of so many rows of sky; 0 without.
fn last_sky(sky: &Sky, w: usize, h: usize, run: usize) -> Vec<usize> {
    let ends = |x: usize, y: usize| (y + 1 - run..=y).all(|y| sky.flooded[y * w + x]);
    (0..w).map(|x| (run..h).rev().find(|&y| ends(x, y)).unwrap_or(0)).collect()
}

/// The largest connected part of a mask.
pub(super) fn largest(mask: &[bool], w: usize, h: usize) -> Vec<bool> {
    let mut label = vec![0_u32; mask.len()];
    let (mut parts, mut best) = (0, (0, 0));
    for start in 0..mask.len() {
        if !mask[start] || label[start] > 0 {
            continue;
        }
        parts += 1;
        let (mut open, mut size) = (vec![start], 0);
        label[start] = parts;
        while let Some(i) = open.pop() {
            size += 1;
            let (x, y) = (i % w, i / w);
            for row in y.saturating_sub(1)..(y + 2).min(h) {
                for column in x.saturating_sub(1)..(x + 2).min(w) {
                    let j = row * w + column;
                    if mask[j] && label[j] == 0 {
                        label[j] = parts;
                        open.push(j);
                    }
                }
            }
        }
        best = best.max((size, parts));
    }
    label.iter().map(|&l| l > 0 && l == best.1).collect()
}

/// Follows the skyline from the peak outwards to where it is lowest before it rises again, for longer
/// than a branch does.
fn flank(columns: impl Iterator<Item = usize>, skyline: &[usize], rise: usize) -> usize {
    let (mut lowest, mut at, mut risen) = (0, 0, 0);
    for (i, x) in columns.enumerate() {
        // Of equally low columns, the nearest: beyond a crown's edge the horizon is level.
        if i == 0 || skyline[x] > lowest + rise / 3 {
            (lowest, at) = (skyline[x], x);
        }
        risen = if skyline[x] + rise < lowest { risen + 1 } else { 0 };
        if risen > skyline.len() / BRANCH {
            break;
        }
    }
    at
}

/// Mean over squares of `2 radius + 1`.
pub(super) fn blurred(values: &[f32], w: usize, h: usize, radius: usize) -> Vec<f32> {
    let pass = |values: &[f32], n: usize, stride: usize, lines: usize, line: usize| {
        let mut out = vec![0.0; values.len()];
        for l in 0..lines {
            for i in 0..n {
                let range = i.saturating_sub(radius)..(i + radius + 1).min(n);
                let count = range.len() as f32;
                out[l * line + i * stride] =
                    range.map(|j| values[l * line + j * stride]).sum::<f32>() / count;
            }
        }
        out
    };
    let rows = pass(values, w, 1, h, w);
    pass(&rows, h, w, w, 1)
}
