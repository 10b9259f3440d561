//! Draw arguments into the caller's buffers.

use super::model::Draw;
use super::output::{DrawIndexed, InstanceLod, Written};
use super::scene::{Kept, Scene};
use super::state::{Memory, State};
use crate::error::{LodError, Result};

impl Scene {
    /// Writes a draw for each part of each instance in view, and a row for each instance: for multi-draw
    /// indirect. Draws of an instance follow one another; parts without indices are left out.
    ///
    /// # Errors
    /// [`LodError::Scene`] when a buffer is too small: its row tells how many are needed. Nothing is
    /// written then. [`Scene::most_draws`] and [`Scene::len`] always suffice.
    ///
    /// # Complexity
    /// O(instances in view × parts); no allocation.
    pub fn draws(
        &self,
        state: &State,
        draws: &mut [DrawIndexed],
        instances: &mut [InstanceLod],
    ) -> Result<Written> {
        state.check(self)?;
        let mut written = Written::default();
        room("instances", instances.len(), state.drawn.len())?;
        // Counted only where it could matter.
        if draws.len() < self.most_draws_of(state) {
            room("draws", draws.len(), self.n_draws(state))?;
        }
        for &number in &state.drawn {
            let Some(at) = self.shown(number, state) else { continue };
            let Some(slot) = instances.get_mut(written.instances) else { break };
            *slot = at.lod();
            put(at.model.draws_of(at.level), written.instances, 1, draws, &mut written.draws);
            written.instances += 1;
        }
        Ok(written)
    }

    /// The same, with one draw for each part of all instances of the same model at the same level.
    ///
    /// # Errors
    /// As [`draws`](Self::draws).
    ///
    /// # Complexity
    /// O(instances in view + levels of all models × parts); no allocation.
    pub fn batches(
        &self,
        state: &mut State,
        draws: &mut [DrawIndexed],
        instances: &mut [InstanceLod],
    ) -> Result<Written> {
        state.check(self)?;
        room("instances", instances.len(), state.drawn.len())?;
        self.count(state);
        room("draws", draws.len(), self.n_batches(state))?;
        let mut written = Written::default();
        for model in &self.models {
            for (level, bucket) in (model.bucket..model.bucket + model.levels.len()).enumerate() {
                let Some(count) = state.buckets.get_mut(bucket) else { continue };
                // From here on the bucket holds the row of its next instance.
                let n = std::mem::replace(count, written.instances as u32);
                if n > 0 {
                    put(model.draws_of(level), written.instances, n, draws, &mut written.draws);
                }
                written.instances += n as usize;
            }
        }
        for i in 0..state.drawn.len() {
            let Some(&number) = state.drawn.get(i) else { break };
            let Some(at) = self.shown(number, state) else { continue };
            let lod = at.lod();
            let Some(next) = state.buckets.get_mut(at.model.bucket + at.level) else { continue };
            if let Some(slot) = instances.get_mut(*next as usize) {
                *slot = lod;
            }
            *next += 1;
        }
        Ok(written)
    }

    /// More draws than the instances in view can have.
    fn most_draws_of(&self, state: &State) -> usize {
        self.models.iter().map(|model| model.parts).max().unwrap_or(0) * state.drawn.len()
    }

    /// Draws of the instances in view.
    fn n_draws(&self, state: &State) -> usize {
        let draws = |at: Shown<'_>| at.model.levels.get(at.level).map_or(0, |level| level.n_draws);
        state.drawn.iter().filter_map(|&number| self.shown(number, state)).map(draws).sum()
    }

    /// Instances in view, by level.
    fn count(&self, state: &mut State) {
        state.buckets.fill(0);
        for i in 0..state.drawn.len() {
            let Some(&number) = state.drawn.get(i) else { break };
            let Some(at) = self.shown(number, state) else { continue };
            if let Some(count) = state.buckets.get_mut(at.model.bucket + at.level) {
                *count += 1;
            }
        }
    }

    /// Draws of all levels in use.
    fn n_batches(&self, state: &State) -> usize {
        let used = |model: &Kept| {
            let buckets = state.buckets.get(model.bucket..model.bucket + model.levels.len());
            let pairs = buckets.unwrap_or(&[]).iter().zip(&model.levels);
            pairs.filter(|(n, _)| **n > 0).map(|(_, level)| level.n_draws).sum::<usize>()
        };
        self.models.iter().map(used).sum()
    }

    fn shown(&self, number: u32, state: &State) -> Option<Shown<'_>> {
        let (_, model) = self.row(number)?;
        let memory = *state.memory.get(number as usize)?;
        let level = usize::from(memory.level).min(model.levels.len().checked_sub(1)?);
        Some(Shown { id: *self.ids.get(number as usize)?, model, memory, level })
    }
}

/// An instance in view.
struct Shown<'a> {
    id: u32,
    model: &'a Kept,
    memory: Memory,
    level: usize,
}

impl Shown<'_> {
    /// Scale, fading and contrast lie between those of two levels, as λ does.
    #[inline]
    fn lod(&self) -> InstanceLod {
        let lambda = self.memory.lambda;
        let levels = &self.model.levels;
        let Some(above) = levels.get(self.level) else { return InstanceLod::default() };
        let below = self.level.checked_sub(1).and_then(|i| levels.get(i)).unwrap_or(above);
        let width = above.lambda - below.lambda;
        let t = if width > 0.0 { ((above.lambda - lambda) / width).clamp(0.0, 1.0) } else { 0.0 };
        let mix = |above: f32, below: f32| above + t * (below - above);
        InstanceLod {
            instance: self.id,
            scale: mix(above.scale, below.scale).sqrt(),
            lambda,
            fade: mix(above.fade, below.fade),
            contrast: mix(above.contrast, below.contrast),
        }
    }
}

/// Writes the parts of a level that have indices.
#[inline]
fn put(parts: &[Draw], first: usize, count: u32, draws: &mut [DrawIndexed], n: &mut usize) {
    for part in parts.iter().filter(|part| part.index_count > 0) {
        let Some(slot) = draws.get_mut(*n) else { return };
        *slot = DrawIndexed {
            index_count: part.index_count,
            instance_count: count,
            first_index: part.first_index,
            base_vertex: part.base_vertex,
            first_instance: first as u32,
        };
        *n += 1;
    }
}

fn room(what: &'static str, found: usize, needed: usize) -> Result<()> {
    if found >= needed {
        return Ok(());
    }
    let (what, problem) = match what {
        "draws" => ("output, draws needed:", "the buffer is smaller; nothing was written"),
        _ => ("output, instances needed:", "the buffer is smaller; nothing was written"),
    };
    Err(LodError::Scene { what, row: needed, problem })
}
