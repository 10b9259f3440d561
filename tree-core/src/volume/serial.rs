//! Volumes as data. They are written as their [`Solid`] and checked anew when read, so what is read
//! is as good as what was built.

use super::{MAX_DEPTH, Solid, Volume};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::cell::Cell;

impl Serialize for Volume {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.solid().serialize(serializer)
    }
}

thread_local! {
    /// Volumes being read on this thread, one within the other. Serde offers no other place to count
    /// them, and a format without a cap of its own would overflow the stack before [`Volume::new`]
    /// sees the first part.
    static N_OPEN: Cell<u32> = const { Cell::new(0) };
}

/// One volume being read; ends when dropped, also on errors.
struct Reading;

impl Reading {
    fn start() -> Option<Self> {
        let n_open = N_OPEN.get();
        (n_open <= MAX_DEPTH).then(|| {
            N_OPEN.set(n_open + 1);
            Self
        })
    }
}

impl Drop for Reading {
    fn drop(&mut self) {
        N_OPEN.set(N_OPEN.get().saturating_sub(1));
    }
}

impl<'de> Deserialize<'de> for Volume {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let _reading =
            Reading::start().ok_or_else(|| D::Error::custom(super::too_deep(MAX_DEPTH + 1)))?;
        Self::new(Solid::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}
