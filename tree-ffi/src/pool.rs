//! Threads that do the work: a number of them, or the host's own.

use crate::border::{
    Failure, Handle, Result, TREE_ERROR_NO_RESULT, TREE_ERROR_ORDER, TREE_ERROR_PARAMETER,
    Versioned, call, free, get, init, out, read_or_default, tree_status,
};
use crate::control::User;
use std::collections::BTreeMap;
use std::ffi::c_void;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{JoinHandle, available_parallelism};

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
    /// 0.
    pub reserved: u32,
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
            reserved: 0,
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
    workers: Workers,
    /// Those that the library started.
    own: Mutex<Vec<JoinHandle<()>>>,
}

impl Handle for tree_pool {
    const NAME: &'static str = "tree_pool";
}

/// How many threads of each pool are in their workers' code. For ever, because a thread that leaves must
/// not touch anything that the one who waits for it may free.
static RUNNING: Mutex<BTreeMap<u64, usize>> = Mutex::new(BTreeMap::new());
static LEFT: Condvar = Condvar::new();

/// The threads of one pool, by its number.
#[derive(Clone, Copy)]
struct Workers(u64);

impl Workers {
    fn new() -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        Self(NEXT.fetch_add(1, Ordering::Relaxed))
    }

    fn enter(self) {
        *running().entry(self.0).or_default() += 1;
    }

    /// The last thing that a worker does.
    fn leave(self) {
        let mut running = running();
        if let Some(count) = running.get_mut(&self.0) {
            *count -= 1;
            if *count == 0 {
                running.remove(&self.0);
            }
        }
        if running.is_empty() {
            // Gives back the map's memory too: a host counts what its allocator gave.
            *running = BTreeMap::new();
        }
        LEFT.notify_all();
    }

    fn wait(self) {
        let mut running = running();
        while running.contains_key(&self.0) {
            running = LEFT.wait(running).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

fn running() -> MutexGuard<'static, BTreeMap<u64, usize>> {
    RUNNING.lock().unwrap_or_else(PoisonError::into_inner)
}

struct Worker {
    thread: rayon::ThreadBuilder,
    workers: Workers,
}

impl Worker {
    /// Runs until the pool is freed. rayon catches what its jobs throw.
    fn run(self) {
        let Self { thread, workers } = self;
        thread.run();
        workers.leave();
    }
}

/// Runs a worker until its pool is freed.
unsafe extern "C" fn run_worker(worker: *mut c_void) {
    if worker.is_null() {
        return;
    }
    // SAFETY: made by `start`, and the host hands it back once.
    let worker = *unsafe { Box::from_raw(worker.cast::<Worker>()) };
    worker.run();
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
    let workers = Workers::new();
    let n_threads = match options.n_threads {
        // Not rayon's own default, which the environment may set to anything.
        0 => available_parallelism().map_or(1, |cores| cores.get().min(THREADS_MAX as usize)),
        n => n as usize,
    };
    let mut builder =
        rayon::ThreadPoolBuilder::new().num_threads(n_threads).thread_name(|i| format!("tree {i}"));
    if options.stack_size > 0 {
        builder = builder.stack_size(options.stack_size);
    }
    let (spawn, user) = (options.spawn, User(options.user));
    let own = Arc::new(Mutex::new(Vec::new()));
    let begun = own.clone();
    let built = builder
        .spawn_handler(move |thread| {
            let worker = Worker { thread, workers };
            workers.enter();
            let started = match spawn {
                None => begin(worker).map(|thread| {
                    begun.lock().unwrap_or_else(PoisonError::into_inner).push(thread);
                }),
                Some(spawn) => ask_host(spawn, user, worker),
            };
            started.inspect_err(|_| workers.leave())
        })
        .build();
    let own = std::mem::take(&mut *own.lock().unwrap_or_else(PoisonError::into_inner));
    match built {
        Ok(pool) => Ok(Shared { pool, workers, own: Mutex::new(own) }),
        Err(error) => {
            // Those that had started are told to end.
            workers.wait();
            join(own);
            Err(Failure::new(TREE_ERROR_NO_RESULT, format!("no threads: {error}")))
        }
    }
}

/// Starts a thread of the library's own.
fn begin(worker: Worker) -> std::io::Result<JoinHandle<()>> {
    let mut builder = std::thread::Builder::new();
    if let Some(name) = worker.thread.name() {
        builder = builder.name(name.to_owned());
    }
    if let Some(size) = worker.thread.stack_size() {
        builder = builder.stack_size(size);
    }
    builder.spawn(move || worker.run())
}

type Spawn = unsafe extern "C" fn(*mut c_void, tree_worker_fn, *mut c_void) -> i32;

/// Hands a worker to the host.
fn ask_host(spawn: Spawn, user: User, worker: Worker) -> std::io::Result<()> {
    let worker = Box::into_raw(Box::new(worker));
    // SAFETY: the host's function with the host's pointer.
    if unsafe { spawn(user.get(), Some(run_worker), worker.cast()) } == 0 {
        return Ok(());
    }
    // SAFETY: the host refused, so it does not keep the worker.
    drop(unsafe { Box::from_raw(worker) });
    Err(std::io::Error::other("the host has no thread"))
}

fn join(threads: Vec<JoinHandle<()>>) {
    for thread in threads {
        // A worker's panic stays in the job that it came from.
        let _ = thread.join();
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

/// Frees a pool, and returns when its threads have left its work. A host that unloads the library joins
/// threads of its own first: what the library keeps for each thread goes when the thread ends. `TREE_ERROR_ORDER`, and the
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
        let workers = shared.workers;
        let own = std::mem::take(&mut *shared.own.lock().unwrap_or_else(PoisonError::into_inner));
        unsafe { free(pool, "pool") }?;
        drop(shared);
        workers.wait();
        join(own);
        Ok(())
    })
}
