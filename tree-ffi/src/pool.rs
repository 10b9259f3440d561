//! Threads that do the work: a number of them, or the host's own.

use crate::border::{
    Failure, Handle, Result, TREE_ERROR_NO_RESULT, TREE_ERROR_ORDER, TREE_ERROR_PARAMETER,
    Versioned, call, free, get, init, out, read_or_default, tree_status,
};
use crate::control::User;
use std::ffi::c_void;
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread::JoinHandle;

/// Most threads of a pool.
const THREADS_MAX: u32 = 1024;

/// What the host runs on one of its threads: `run(worker)`, once. It returns when the pool is freed.
pub type tree_worker_fn = Option<unsafe extern "C" fn(worker: *mut c_void)>;

/// Asks the host for a thread that calls `run(worker)`, on any thread but the asking one. Returns 0 when
/// it will, anything else when it cannot (then `run` must not be called).
pub type tree_spawn_fn = Option<
    unsafe extern "C" fn(user: *mut c_void, run: tree_worker_fn, worker: *mut c_void) -> i32,
>;

/// Which threads a pool has. Begin with `tree_pool_options_init`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct tree_pool_options {
    /// `sizeof(tree_pool_options)`.
    pub struct_size: usize,
    /// Number of threads, at most 1024. Default 0: one for each core.
    pub n_threads: u32,
    /// Bytes of stack of each thread that the library starts. Default 0: the system's.
    pub stack_size: usize,
    /// Gives the pool the host's own threads, for instance long-running jobs of its job system, each for
    /// the pool's whole life. Default NULL: the library starts threads.
    pub spawn: tree_spawn_fn,
    /// Handed to `spawn`.
    pub user: *mut c_void,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_pool_options {
    const NAME: &'static str = "tree_pool_options";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_threads: 0,
            stack_size: 0,
            spawn: None,
            user: std::ptr::null_mut(),
        }
    }
}

/// Makes `options`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pool_options_init(
    options: *mut tree_pool_options,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(options, size) })
}

/// Threads that do the work of the calls it is given to (`tree_control.pool`). What calls make does not
/// depend on it. A plug-in that may be unloaded gives every call a pool and frees it before that: the
/// threads of calls without a pool never end.
pub struct tree_pool(Arc<Shared>);

struct Shared {
    pool: rayon::ThreadPool,
    workers: Arc<Workers>,
}

impl Handle for tree_pool {
    const NAME: &'static str = "tree_pool";
}

/// How many threads are in their workers' code, and those of them that are the library's own.
#[derive(Default)]
struct Workers {
    running: Mutex<usize>,
    ended: Condvar,
    own: Mutex<Vec<JoinHandle<()>>>,
}

impl Workers {
    fn enter(&self) {
        *self.running.lock().unwrap_or_else(PoisonError::into_inner) += 1;
    }

    fn leave(&self) {
        *self.running.lock().unwrap_or_else(PoisonError::into_inner) -= 1;
        self.ended.notify_all();
    }

    fn wait(&self) {
        let mut running = self.running.lock().unwrap_or_else(PoisonError::into_inner);
        while *running > 0 {
            running = self.ended.wait(running).unwrap_or_else(PoisonError::into_inner);
        }
        drop(running);
        let own = std::mem::take(&mut *self.own.lock().unwrap_or_else(PoisonError::into_inner));
        for thread in own {
            // A worker's panic stays in the job that it came from.
            let _ = thread.join();
        }
    }
}

struct Worker {
    thread: rayon::ThreadBuilder,
    workers: Arc<Workers>,
}

/// Runs a worker until its pool is freed.
unsafe extern "C" fn run_worker(worker: *mut c_void) {
    if worker.is_null() {
        return;
    }
    // SAFETY: made by `spawn`, and the host hands it back once.
    let worker = unsafe { Box::from_raw(worker.cast::<Worker>()) };
    // rayon catches what its jobs throw.
    let Worker { thread, workers } = *worker;
    thread.run();
    workers.leave();
}

/// Starts a pool, or asks the host for its threads. `options` may be NULL. Free it with
/// `tree_pool_free`. Fails with `TREE_ERROR_NO_RESULT` when a thread cannot be had.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pool_new(
    options: *const tree_pool_options,
    pool: *mut *mut tree_pool,
) -> tree_status {
    call(|| {
        let place = unsafe { out(pool, "pool") }?;
        let options = unsafe { read_or_default(options, "options") }?;
        place.put(tree_pool(Arc::new(start(&options)?)));
        Ok(())
    })
}

fn start(options: &tree_pool_options) -> Result<Shared> {
    if options.n_threads > THREADS_MAX {
        let text =
            format!("options.n_threads is {}, allowed is 0 to {THREADS_MAX}", options.n_threads);
        return Err(Failure::new(TREE_ERROR_PARAMETER, text));
    }
    let workers = Arc::<Workers>::default();
    let mut builder = rayon::ThreadPoolBuilder::new()
        .num_threads(options.n_threads as usize)
        .thread_name(|i| format!("tree {i}"));
    if options.stack_size > 0 {
        builder = builder.stack_size(options.stack_size);
    }
    let (spawn, user) = (options.spawn, User(options.user));
    let started = workers.clone();
    let built = builder
        .spawn_handler(move |thread| {
            let worker = Worker { thread, workers: started.clone() };
            started.enter();
            let refused = |error| {
                started.leave();
                Err(error)
            };
            let Some(spawn) = spawn else {
                let mut builder = std::thread::Builder::new();
                if let Some(name) = worker.thread.name() {
                    builder = builder.name(name.to_owned());
                }
                if let Some(size) = worker.thread.stack_size() {
                    builder = builder.stack_size(size);
                }
                let begun = builder.spawn(move || {
                    let Worker { thread, workers } = worker;
                    thread.run();
                    workers.leave();
                });
                return match begun {
                    Ok(thread) => {
                        started.own.lock().unwrap_or_else(PoisonError::into_inner).push(thread);
                        Ok(())
                    }
                    Err(error) => refused(error),
                };
            };
            let worker = Box::into_raw(Box::new(worker));
            // SAFETY: the host's function with the host's pointer.
            if unsafe { spawn(user.get(), Some(run_worker), worker.cast()) } == 0 {
                return Ok(());
            }
            // SAFETY: the host refused, so it does not keep the worker.
            drop(unsafe { Box::from_raw(worker) });
            refused(std::io::Error::other("the host has no thread"))
        })
        .build();
    match built {
        Ok(pool) => Ok(Shared { pool, workers }),
        Err(error) => {
            // Those that had started are told to end.
            workers.wait();
            Err(Failure::new(TREE_ERROR_NO_RESULT, format!("no threads: {error}")))
        }
    }
}

impl tree_pool {
    /// Does `work` on the pool's threads.
    pub(crate) fn install<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        let shared = self.0.clone();
        shared.pool.install(work)
    }
}

/// Number of threads of a pool.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pool_threads(
    pool: *const tree_pool,
    n_threads: *mut u32,
) -> tree_status {
    call(|| {
        let n = unsafe { get(pool, "pool") }?.0.pool.current_num_threads();
        unsafe { crate::border::out_value(n_threads, n as u32, "n_threads") }
    })
}

/// Frees a pool, and returns when its threads are out of the library's code. `TREE_ERROR_ORDER`, and the
/// pool lives on, while a call is at work on it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pool_free(pool: *mut tree_pool) -> tree_status {
    call(|| {
        if pool.is_null() {
            return Ok(());
        }
        let shared = unsafe { get(pool.cast_const(), "pool") }?.0.clone();
        // The handle's and ours.
        if Arc::strong_count(&shared) > 2 {
            return Err(Failure::new(
                TREE_ERROR_ORDER,
                "pool is at work: wait for its calls first",
            ));
        }
        let workers = shared.workers.clone();
        unsafe { free(pool, "pool") }?;
        drop(shared);
        workers.wait();
        Ok(())
    })
}
