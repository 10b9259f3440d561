//! Opaque objects. A register knows which are alive, so that a handle that was freed, is of another kind
//! or never was one is an error instead of a crash.
//!
//! An object is a box; its handle is the box's address. Looking one up costs a read lock and a search
//! among the handles of one of [`SHARDS`] parts, some ten nanoseconds.

use super::failure::{Failure, Result};
use super::status::{TREE_ERROR_HANDLE, TREE_ERROR_ORDER};
use std::collections::BTreeMap;
use std::sync::{PoisonError, RwLock};

/// Parts of the register: threads that work on different objects rarely wait for each other.
const SHARDS: usize = 16;

/// A type that callers hold by an opaque pointer.
pub(crate) trait Handle: Send + Sync + 'static {
    /// Its name in C.
    const NAME: &'static str;
}

/// What the register knows of an object.
#[derive(Clone, Copy)]
struct Entry {
    name: &'static str,
    owner: Owner,
}

/// Who frees an object.
#[derive(Clone, Copy, PartialEq)]
enum Owner {
    Caller,
    /// Nobody: callers may use it.
    Library,
    /// An object with this name, when it is freed itself.
    Object(&'static str),
}

/// Addresses are kept with all bits turned over: a leak checker that looks through memory for pointers
/// shall not take the register for an owner.
type Shard = RwLock<BTreeMap<usize, Entry>>;

static LIVE: [Shard; SHARDS] = [const { RwLock::new(BTreeMap::new()) }; SHARDS];

fn key<T>(pointer: *const T) -> usize {
    !pointer.addr()
}

fn shard(key: usize) -> &'static Shard {
    // Boxes lie at multiples of 16: the bits above tell them apart.
    &LIVE[(key >> 4) % SHARDS]
}

fn check<T: Handle>(pointer: *const T, argument: &str) -> Result<Entry> {
    if pointer.is_null() {
        return Err(Failure::null(argument));
    }
    let key = key(pointer);
    let live = shard(key).read().unwrap_or_else(PoisonError::into_inner);
    match live.get(&key) {
        Some(&entry) if entry.name == T::NAME => Ok(entry),
        Some(entry) => Err(wrong(argument, T::NAME, &format!("it is a {}", entry.name))),
        None => Err(wrong(argument, T::NAME, "it was freed, or never was a handle")),
    }
}

fn wrong(argument: &str, expected: &str, why: &str) -> Failure {
    Failure::new(TREE_ERROR_HANDLE, format!("{argument} is not a live {expected}: {why}"))
}

/// The object of a handle.
///
/// # Safety
/// No other thread frees it before the reference's last use: that is the caller's part of the contract.
pub(crate) unsafe fn get<'a, T: Handle>(pointer: *const T, argument: &str) -> Result<&'a T> {
    check(pointer, argument)?;
    // SAFETY: alive and of this type, by the register.
    Ok(unsafe { &*pointer })
}

/// As [`get`]; NULL is none.
///
/// # Safety
/// As [`get`].
pub(crate) unsafe fn get_opt<'a, T: Handle>(
    pointer: *const T,
    argument: &str,
) -> Result<Option<&'a T>> {
    if pointer.is_null() { Ok(None) } else { unsafe { get(pointer, argument) }.map(Some) }
}

/// Frees an object of the caller's. NULL is none.
///
/// # Safety
/// No other thread uses it.
pub(crate) unsafe fn free<T: Handle>(pointer: *mut T, argument: &str) -> Result<()> {
    if pointer.is_null() {
        return Ok(());
    }
    let owner = match check(pointer.cast_const(), argument)?.owner {
        Owner::Caller => return unsafe { remove(pointer, argument) },
        Owner::Library => "the library: it is not freed".to_owned(),
        Owner::Object(name) => format!("a {name}: it is freed with that"),
    };
    Err(Failure::new(TREE_ERROR_ORDER, format!("{argument} belongs to {owner}")))
}

/// Frees an object that another one owns, which calls this when it is dropped.
///
/// # Safety
/// No other thread uses it.
pub(crate) unsafe fn free_owned<T: Handle>(pointer: *mut T) {
    // The register had it, and callers cannot take it out: there is no error to report.
    let _ = unsafe { remove(pointer, T::NAME) };
}

/// Takes an object out of the register and drops it.
unsafe fn remove<T: Handle>(pointer: *mut T, argument: &str) -> Result<()> {
    let key = key(pointer.cast_const());
    let gone = {
        let mut live = shard(key).write().unwrap_or_else(PoisonError::into_inner);
        let gone = live.remove(&key);
        // An empty map keeps a node: a host that unloads the library wants all its memory back.
        if live.is_empty() {
            *live = BTreeMap::new();
        }
        gone
    };
    if gone.is_none() {
        return Err(wrong(argument, T::NAME, "another thread freed it in this moment"));
    }
    // SAFETY: it was alive and of this type, and only one caller takes it out of the register.
    drop(unsafe { Box::from_raw(pointer) });
    Ok(())
}

fn register<T: Handle>(object: T, owner: Owner) -> *mut T {
    let pointer = Box::into_raw(Box::new(object));
    let key = key(pointer.cast_const());
    let entry = Entry { name: T::NAME, owner };
    shard(key).write().unwrap_or_else(PoisonError::into_inner).insert(key, entry);
    pointer
}

/// A handle that is never freed, for constants. It does not count among those alive.
pub(crate) fn register_for_ever<T: Handle>(object: T) -> *const T {
    register(object, Owner::Library)
}

/// A handle that belongs to an object of type `By`, which frees it with [`free_owned`].
pub(crate) fn register_owned<T: Handle, By: Handle>(object: T) -> *mut T {
    register(object, Owner::Object(By::NAME))
}

/// Number of objects alive that callers have to free.
pub(crate) fn n_live() -> usize {
    let own = |shard: &Shard| {
        let live = shard.read().unwrap_or_else(PoisonError::into_inner);
        live.values().filter(|entry| entry.owner == Owner::Caller).count()
    };
    LIVE.iter().map(own).sum()
}

/// Where a new handle goes; NULL is there until it is [put](Out::put).
pub(crate) struct Out<T>(*mut *mut T);

/// Takes the place for a new handle and writes NULL there.
///
/// # Safety
/// `place` is NULL or may be written to until the returned value is gone.
pub(crate) unsafe fn out<T: Handle>(place: *mut *mut T, argument: &str) -> Result<Out<T>> {
    if place.is_null() {
        return Err(Failure::null(argument));
    }
    // SAFETY: not NULL, and writable by contract.
    unsafe { place.write(std::ptr::null_mut()) };
    Ok(Out(place))
}

/// As [`out`]; NULL where the object is not wanted.
///
/// # Safety
/// As [`out`].
pub(crate) unsafe fn out_opt<T: Handle>(
    place: *mut *mut T,
    argument: &str,
) -> Result<Option<Out<T>>> {
    if place.is_null() { Ok(None) } else { unsafe { out(place, argument) }.map(Some) }
}

/// As [`out`] for two places: both that are there are NULL before the first is an error.
///
/// # Safety
/// As [`out`].
pub(crate) unsafe fn out2<A: Handle, B: Handle>(
    a: (*mut *mut A, &str),
    b: (*mut *mut B, &str),
) -> Result<(Out<A>, Out<B>)> {
    let (a, b) = unsafe { (out(a.0, a.1), out(b.0, b.1)) };
    Ok((a?, b?))
}

impl<T: Handle> Out<T> {
    /// Hands the object out.
    pub(crate) fn put(self, object: T) {
        // SAFETY: checked by `out`.
        unsafe { self.0.write(register(object, Owner::Caller)) };
    }
}
