//! Precision, recall and quality.

use super::take::{few, fill_some, room_for};
use super::views::tree_around;
use crate::border::{Failure, Result, TREE_ERROR_PARAMETER, call, get, out_value, tree_status};
use crate::control::{run, tree_control};
use crate::mesh::tree_mesh;
use bytemuck::{Pod, Zeroable};
use tree_lod::quality::{Score, mean_quality};

/// Most scores of one mean.
const SCORES_MAX: usize = 1 << 20;
/// Most pixels of one kind: sums of three of them stay within 64 bits.
const PIXELS_MAX: u64 = 1 << 62;

/// Pixels of a simplified model against those of the full one: of one view, or added up over many.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct tree_score {
    /// Covered by both.
    pub both: u64,
    /// Covered by the simplified model only.
    pub wrong: u64,
    /// Covered by the full model only.
    pub missed: u64,
}

impl tree_score {
    pub(super) fn of(score: &Score) -> Self {
        Self { both: score.both, wrong: score.wrong, missed: score.missed }
    }

    fn rust(&self, argument: &str) -> Result<Score> {
        let Self { both, wrong, missed } = *self;
        if [both, wrong, missed].into_iter().any(|n| n > PIXELS_MAX) {
            let text = format!("{argument}: there are no pictures of more than 2^62 pixels");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        Ok(Score { both, wrong, missed })
    }
}

/// What a score is worth (Neubert 2012, eq. 7.3 to 7.7). `precision` is the share of the simplified model's pixels
/// that are right, `recall` the share of the full model's pixels that are there, both 0 to 1, and 1 when there
/// are none. `quality` is `1 - sqrt((1 - precision)^2 + (1 - recall)^2)`: 1 is perfect, 0 and less is useless.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_score_quality(
    score: *const tree_score,
    precision: *mut f64,
    recall: *mut f64,
    quality: *mut f64,
) -> tree_status {
    call(|| {
        let score = match unsafe { few(score, 1, 1, "score") }? {
            [score] => score.rust("score")?,
            _ => return Err(Failure::null("score")),
        };
        unsafe { out_value(precision, score.precision(), "precision") }?;
        unsafe { out_value(recall, score.recall(), "recall") }?;
        unsafe { out_value(quality, score.quality(), "quality") }
    })
}

/// Mean of the qualities of several views: what a table says of a model. 0 of none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_score_mean_quality(
    scores: *const tree_score,
    n_scores: usize,
    quality: *mut f64,
) -> tree_status {
    call(|| {
        let scores = unsafe { few(scores, n_scores, SCORES_MAX, "scores") }?;
        let scores = scores.iter().map(|score| score.rust("scores"));
        let scores = scores.collect::<Result<Vec<_>>>()?;
        unsafe { out_value(quality, mean_quality(&scores), "quality") }
    })
}

/// Scores of a simplified mesh against the full one, one for each view; both are framed as the full one is.
/// `around`, NULL for the default, says from where to look; `scores` has room for `capacity` scores, at least
/// `tree_around_count`. `control` may be NULL; `pixels` of its limits caps those of all views.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_score(
    simplified: *const tree_mesh,
    full: *const tree_mesh,
    around: *const tree_around,
    control: *const tree_control,
    scores: *mut tree_score,
    capacity: usize,
) -> tree_status {
    call(|| {
        let simplified = unsafe { get(simplified, "simplified") }?.rust();
        let full = unsafe { get(full, "full") }?.rust();
        let around = unsafe { tree_around::read(around) }?;
        let cameras = around.cameras();
        room_for(cameras.len(), capacity, "scores")?;
        let body = |control: &_| {
            Ok(tree_lod::cover::score(simplified, full, &cameras, around.size, control)?)
        };
        unsafe { fill_scores(scores, capacity, &run(control, body)?) }
    })
}

pub(super) unsafe fn fill_scores(
    scores: *mut tree_score,
    capacity: usize,
    found: &[Score],
) -> Result<()> {
    let found: Vec<tree_score> = found.iter().map(tree_score::of).collect();
    unsafe { fill_some(scores, capacity, &found, "scores") }
}
