//! Parts of larger objects, which keep these alive.

use std::any::Any;
use std::sync::Arc;

/// A value of its own, or a part of something larger, shared by all handles of it.
pub(crate) struct Shared<T> {
    part: *const T,
    /// What the part lies in. It never moves, and nobody can change it.
    whole: Arc<dyn Any + Send + Sync>,
}

// SAFETY: it gives out shared references to the part alone, and `whole` may be dropped by any thread.
unsafe impl<T: Sync> Send for Shared<T> {}
// SAFETY: as above.
unsafe impl<T: Sync> Sync for Shared<T> {}

impl<T> Clone for Shared<T> {
    fn clone(&self) -> Self {
        Self { part: self.part, whole: self.whole.clone() }
    }
}

impl<T: Send + Sync + 'static> Shared<T> {
    pub(crate) fn new(value: T) -> Self {
        Self::of(Arc::new(value))
    }

    pub(crate) fn of(value: Arc<T>) -> Self {
        Self { part: Arc::as_ptr(&value), whole: value }
    }

    pub(crate) fn get(&self) -> &T {
        // SAFETY: the part lies in `whole`, which lives as long as this and is only lent out for reading.
        unsafe { &*self.part }
    }

    /// A part of this one.
    pub(crate) fn part<U>(&self, of: impl FnOnce(&T) -> &U) -> Shared<U> {
        Shared { part: of(self.get()), whole: self.whole.clone() }
    }

    /// As [`part`](Self::part), of a part that may not be there.
    pub(crate) fn part_if<U>(&self, of: impl FnOnce(&T) -> Option<&U>) -> Option<Shared<U>> {
        of(self.get()).map(|part| Shared { part, whole: self.whole.clone() })
    }
}
