//! Progress and cancellation: taken by every operation that can run long.

use crate::limits::Limits;
use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// How far a long operation has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// The stage at work, for example `level 2`.
    pub stage: &'static str,
    /// Share of the whole operation that is done, 0 to 1. Never falls within one operation.
    pub fraction: f32,
}

/// The caller cancelled the work. Nothing was changed and nothing was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("cancelled by the caller")]
pub struct Cancelled;

/// A flag that stops running work from any thread; clones share it.
#[derive(Clone, Debug, Default)]
pub struct CancelFlag(Arc<AtomicBool>);

impl CancelFlag {
    /// Asks the work to stop. It returns [`Cancelled`] at its next check: mostly within milliseconds,
    /// at the latest after one pass over the data at hand.
    pub fn cancel(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether [`cancel`](Self::cancel) was called.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

type Callback = dyn Fn(Progress) + Send + Sync;
type Stop = dyn Fn() -> bool + Send + Sync;

/// What a caller hands to long work: where to report progress, when to stop, how much to use.
///
/// The default reports nowhere, cannot be cancelled and has the default [`Limits`].
///
/// ```
/// use tree_core::{CancelFlag, Control};
/// let stop = CancelFlag::default();
/// let control = Control::default()
///     .with_cancel(stop.clone())
///     .with_progress(|p| eprintln!("{}: {:.0} %", p.stage, 100.0 * p.fraction));
/// stop.cancel();
/// assert!(control.check().is_err());
/// ```
#[derive(Clone, Default)]
pub struct Control {
    /// Caps on nodes, voxels, pixels and so on.
    pub limits: Limits,
    progress: Option<Arc<Callback>>,
    cancel: CancelFlag,
    stop: Option<Arc<Stop>>,
}

impl Control {
    /// Calls `callback` with progress, from whichever thread does the work.
    #[must_use]
    pub fn with_progress(mut self, callback: impl Fn(Progress) + Send + Sync + 'static) -> Self {
        self.progress = Some(Arc::new(callback));
        self
    }

    /// Stops when `flag` is cancelled.
    #[must_use]
    pub fn with_cancel(mut self, flag: CancelFlag) -> Self {
        self.cancel = flag;
        self
    }

    /// Stops when `stop` says so: for conditions that are asked after instead of announced, such as the
    /// memory in use. It is asked at every check, from any thread, so it must be cheap.
    #[must_use]
    pub fn with_stop(mut self, stop: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        self.stop = Some(Arc::new(stop));
        self
    }

    /// Replaces the limits.
    #[must_use]
    pub fn with_limits(mut self, limits: Limits) -> Self {
        self.limits = limits;
        self
    }

    /// The same for a part of the work: what the part reports as 0 to 1 arrives as `from` to `to`.
    #[must_use]
    pub fn part(&self, from: f32, to: f32) -> Self {
        let progress = self.progress.clone().map(|callback| -> Arc<Callback> {
            Arc::new(move |p: Progress| {
                callback(Progress { fraction: from + (to - from) * p.fraction, ..p });
            })
        });
        Self { progress, ..self.clone() }
    }

    /// Cheap enough for inner loops (one relaxed load, and what [`with_stop`](Self::with_stop) costs).
    ///
    /// # Errors
    /// [`Cancelled`] once the flag is set or the stop condition holds.
    pub fn check(&self) -> Result<(), Cancelled> {
        let stopped = || self.stop.as_ref().is_some_and(|stop| stop());
        if self.cancel.is_cancelled() || stopped() { Err(Cancelled) } else { Ok(()) }
    }

    /// Reports progress, then checks for cancellation.
    ///
    /// # Errors
    /// [`Cancelled`] once the flag is set.
    pub fn report(&self, stage: &'static str, fraction: f32) -> Result<(), Cancelled> {
        if let Some(callback) = &self.progress {
            callback(Progress { stage, fraction: fraction.clamp(0.0, 1.0) });
        }
        self.check()
    }
}

impl fmt::Debug for Control {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Control")
            .field("limits", &self.limits)
            .field("progress", &self.progress.is_some())
            .field("cancelled", &self.cancel.is_cancelled())
            .finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;

    #[test]
    fn a_part_of_the_work_reports_its_share() {
        let seen = Arc::new(Mutex::new(Vec::new()));
        let sink = seen.clone();
        let control =
            Control::default().with_progress(move |p| sink.lock().unwrap().push(p.fraction));
        control.part(0.0, 0.5).report("a", 1.0).unwrap();
        control.part(0.5, 1.0).part(0.0, 0.5).report("b", 1.0).unwrap();
        assert_eq!(*seen.lock().unwrap(), [0.5, 0.75]);
        assert!(Control::default().part(0.0, 0.5).report("c", 1.0).is_ok());
    }

    #[test]
    fn progress_arrives_clamped_and_in_order() {
        let seen = Arc::new(Mutex::new(Vec::new()));
        let sink = seen.clone();
        let control =
            Control::default().with_progress(move |p| sink.lock().unwrap().push(p.fraction));
        control.report("a", -1.0).unwrap();
        control.report("b", 2.0).unwrap();
        assert_eq!(*seen.lock().unwrap(), [0.0, 1.0]);
    }

    #[test]
    fn a_cancelled_flag_stops_every_clone() {
        let flag = CancelFlag::default();
        let control = Control::default().with_cancel(flag.clone());
        let clone = control.clone();
        assert_eq!(clone.check(), Ok(()));
        flag.cancel();
        assert_eq!(clone.report("x", 0.5), Err(Cancelled));
    }

    #[test]
    fn a_stop_condition_is_asked_at_every_check() {
        let flag = CancelFlag::default();
        let asked = flag.clone();
        let control = Control::default().with_stop(move || asked.is_cancelled());
        assert_eq!(control.check(), Ok(()));
        flag.cancel();
        assert_eq!(control.check(), Err(Cancelled));
    }
}
