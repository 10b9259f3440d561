//! Masks of one bit per pixel.

use crate::quality::Score;

/// A mask: one bit per pixel, rows from top to bottom, each begun in a word of its own.
#[derive(Clone, PartialEq, Eq)]
pub struct Bits {
    width: u32,
    height: u32,
    words_per_row: usize,
    words: Vec<u64>,
}

impl std::fmt::Debug for Bits {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Bits({} × {}, {} set)", self.width, self.height, self.count())
    }
}

impl Bits {
    /// An empty mask.
    #[must_use]
    pub(crate) fn new(width: u32, height: u32) -> Self {
        let words_per_row = width.div_ceil(64) as usize;
        Self { width, height, words_per_row, words: vec![0; words_per_row * height as usize] }
    }

    /// Width in pixels.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in pixels.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Number of set bits.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.words.iter().map(|word| u64::from(word.count_ones())).sum()
    }

    /// Whether a pixel is set; outside the mask, none is.
    #[must_use]
    pub fn get(&self, x: u32, y: u32) -> bool {
        x < self.width && y < self.height && {
            let word = self.words[y as usize * self.words_per_row + x as usize / 64];
            word >> (x % 64) & 1 == 1
        }
    }

    /// Pixels of `self`, a simplified model, against those of the `full` one, a mask of the same size.
    #[must_use]
    pub fn score(&self, full: &Self) -> Score {
        let mut score = Score::default();
        for (ours, theirs) in self.rows().zip(full.rows()) {
            for (&a, &b) in ours.iter().zip(theirs) {
                score.both += u64::from((a & b).count_ones());
                score.wrong += u64::from((a & !b).count_ones());
                score.missed += u64::from((!a & b).count_ones());
            }
        }
        score
    }

    /// Words of a row, the pixel at x in bit x mod 64 of word x / 64.
    pub fn rows(&self) -> impl Iterator<Item = &[u64]> + '_ {
        self.words.chunks(self.words_per_row.max(1))
    }

    /// A byte per pixel, 255 where it is set: for pictures.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let row = |y| (0..self.width).map(move |x| if self.get(x, y) { 255 } else { 0 });
        (0..self.height).flat_map(row).collect()
    }

    /// Sets the pixels `first..end` of a row, which lie within the mask.
    #[inline]
    pub(crate) fn set_span(&mut self, y: u32, first: u32, end: u32) {
        let row = y as usize * self.words_per_row;
        for_words(first, end, |word, bits| self.words[row + word] |= bits);
    }

    /// The words of all rows, `height` times as many as the first row has: see [`rows`](Self::rows).
    #[must_use]
    pub fn words(&self) -> &[u64] {
        &self.words
    }

    /// Number of words of all rows.
    pub(crate) fn n_words(&self) -> usize {
        self.words.len()
    }

    /// Calls `each` for every word that the pixels `first..end` of a row touch, with their bits.
    #[inline]
    pub(crate) fn words_of(&self, y: u32, first: u32, end: u32, mut each: impl FnMut(usize, u64)) {
        let row = y as usize * self.words_per_row;
        for_words(first, end, |word, bits| each(row + word, bits));
    }
}

/// The words that a span touches, and the bits in each.
#[inline]
fn for_words(first: u32, end: u32, mut each: impl FnMut(usize, u64)) {
    if first >= end {
        return;
    }
    let (start, last) = (first as usize / 64, (end - 1) as usize / 64);
    let (low, high) = (!0_u64 << (first % 64), !0_u64 >> (63 - (end - 1) % 64));
    if start == last {
        return each(start, low & high);
    }
    each(start, low);
    for word in start + 1..last {
        each(word, !0);
    }
    each(last, high);
}
