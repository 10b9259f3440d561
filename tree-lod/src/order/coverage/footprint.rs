//! Which pixels each candidate covers in every view, as words of bits.

use super::Scene;
use super::pivot::Pivots;
use crate::cover::Piece;
use crate::error::Result;
use glam::Vec3;
use rayon::prelude::*;
use tree_core::{Control, LimitError, Resource};

/// Elements per parallel piece.
const PIECE: usize = 64;

/// Masks of all options of all candidates: option k of candidate c is row `c · options + k`.
pub(super) struct Footprints {
    pub(super) options: usize,
    views: usize,
    /// Where the words of each row and view begin.
    starts: Vec<u32>,
    /// Word of the masks of all views, one after another.
    words: Vec<u32>,
    bits: Vec<u64>,
}

impl Footprints {
    /// Draws every candidate at a scale on length, about each of its pivots.
    ///
    /// # Errors
    /// [`LimitError`] when the words of all would not fit 32 bits; [`Cancelled`](tree_core::Cancelled).
    pub(super) fn new(
        scene: &Scene<'_>,
        candidates: &[u32],
        growth: f32,
        pivots: &Pivots,
        control: &Control,
    ) -> Result<Self> {
        let views = scene.stage.n_views();
        let pieces: Vec<Vec<Drawn>> = candidates
            .par_chunks(PIECE)
            .enumerate()
            .map(|(number, piece)| {
                control.check()?;
                let mut canvas = Vec::new();
                let first = number * PIECE;
                let rows = piece.iter().enumerate().flat_map(|(i, &element)| {
                    pivots.of(first + i).iter().map(move |&pivot| (element as usize, pivot))
                });
                let drawn =
                    rows.map(|(element, pivot)| draw(scene, element, growth, pivot, &mut canvas));
                Ok(drawn.collect())
            })
            .collect::<Result<_>>()?;
        let drawn = || pieces.iter().flatten();
        let n: usize = drawn().map(|drawn| drawn.words.len()).sum();
        let (requested, cap) = (n as u64 * 64, u64::from(u32::MAX) * 64);
        if requested > cap {
            return Err(LimitError { resource: Resource::Pixels, requested, cap }.into());
        }
        let mut prints = Self {
            options: pivots.options,
            views,
            starts: Vec::with_capacity(candidates.len() * pivots.options * views + 1),
            words: Vec::with_capacity(n),
            bits: Vec::with_capacity(n),
        };
        for one in drawn() {
            let first = prints.words.len() as u32;
            prints.starts.extend(one.starts.iter().map(|start| first + start));
            prints.words.extend(&one.words);
            prints.bits.extend(&one.bits);
        }
        prints.starts.push(prints.words.len() as u32);
        Ok(prints)
    }

    /// Words and bits of a row, view by view.
    #[inline]
    pub(super) fn row(&self, row: usize) -> impl Iterator<Item = (&[u32], &[u64])> + '_ {
        let starts = &self.starts[row * self.views..=(row + 1) * self.views];
        starts.windows(2).map(|pair| {
            let range = pair[0] as usize..pair[1] as usize;
            (&self.words[range.clone()], &self.bits[range])
        })
    }
}

/// One row.
struct Drawn {
    starts: Vec<u32>,
    words: Vec<u32>,
    bits: Vec<u64>,
}

fn draw(
    scene: &Scene<'_>,
    element: usize,
    growth: f32,
    pivot: Vec3,
    canvas: &mut Vec<(u32, u64)>,
) -> Drawn {
    let piece = Piece {
        surface: scene.elements.surface[element],
        triangles: scene.tier.of(element),
        center: pivot,
        growth,
    };
    let mut drawn = Drawn { starts: Vec::new(), words: Vec::new(), bits: Vec::new() };
    let mut first_word = 0;
    for shot in scene.stage.shots() {
        canvas.clear();
        drawn.starts.push(drawn.words.len() as u32);
        scene.stage.runs(shot, piece, |row, first, end| {
            shot.full.words_of(row, first, end, |word, bits| {
                canvas.push((first_word + word as u32, bits));
            });
        });
        // Triangles of one element share words, and may cover each other.
        canvas.sort_unstable_by_key(|&(word, _)| word);
        for &(word, bits) in canvas.iter() {
            if drawn.words.len() > drawn.starts.last().copied().unwrap_or(0) as usize
                && drawn.words.last() == Some(&word)
            {
                if let Some(last) = drawn.bits.last_mut() {
                    *last |= bits;
                }
            } else {
                drawn.words.push(word);
                drawn.bits.push(bits);
            }
        }
        first_word += shot.full.n_words() as u32;
    }
    drawn
}
