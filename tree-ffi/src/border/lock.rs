//! Objects that change: one call at a time.

use super::failure::{Failure, Result};
use super::status::TREE_ERROR_ORDER;
use std::sync::{Mutex, MutexGuard, TryLockError};

/// What is in an object that changes, for this call alone; `name` is what the caller calls the object. Waits for no one:
/// a call out of another's progress callback would wait for ever.
pub(crate) fn lock_now<'a, T>(held: &'a Mutex<T>, name: &str) -> Result<MutexGuard<'a, T>> {
    match held.try_lock() {
        Ok(held) => Ok(held),
        // A change that panicked was not done.
        Err(TryLockError::Poisoned(poisoned)) => Ok(poisoned.into_inner()),
        Err(TryLockError::WouldBlock) => {
            let text = format!("{name} is at work in another call: one call at a time");
            Err(Failure::new(TREE_ERROR_ORDER, text))
        }
    }
}
