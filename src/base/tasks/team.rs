//! The worker team of a step.
//!
//! A step consists of some hundred loops with serial code in between. Many of them take at most ten
//! microseconds, the time that a sleeping thread needs to wake. Workers therefore stay awake between loops.
//! They join at the first loop that is large enough, and spin until the next one. They leave after a while
//! without work ([`POLLS_MAX`]), because the pool belongs to the user. The next loop recruits them again.
//!
//! Each thread has a *range* of a loop's pieces and takes them from its front. These are always the same
//! blocks and bodies, which are in its cache from the last loop. A thread without pieces takes from the back
//! of the others. The thread that opened the loop needs no worker: in a pool whose threads are all busy it
//! processes everything itself. A late worker finds that the team is over; the team has shared ownership.
//!
//! The rejected alternative is a fork and join for each loop (`rayon::join`). It costs 5 to 20 µs per loop on
//! two cores, and pieces move from thread to thread. Box2D v3 (Catto, "SIMD Matters", box2d.org, 2024) uses
//! the same method, workers synchronised by atomic counters, with a table of stages made in advance.
//!
//! ## No access to a finished loop
//! A range is one word, the first and the last of its pieces. A piece is taken by exchanging the word for a
//! shorter one. The loop counts pieces that are *done*, and its owner waits until all are. If an exchange
//! succeeds, the piece was not done, the loop is open, and its borrows are alive. An exchange with an equal
//! word of the last loop is equally valid: everything else is read after it.

use core::any::Any;
use core::cell::{Cell, UnsafeCell};
use core::mem::{forget, transmute};
use core::ops::Range;
use core::panic::AssertUnwindSafe;
use core::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::panic::{catch_unwind, resume_unwind};
use std::sync::{Mutex, PoisonError};

/// No more threads than this work on one step: as many as a word has bits.
pub const THREADS_MAX: usize = 64;
/// Number of polls before a waiting thread yields.
const SPINS_MAX: u32 = 256;
/// Number of polls without work after which a worker leaves. In all they take some hundred microseconds, more
/// than any serial stretch of a step with thousands of bodies. WebAssembly cannot yield: its polls are short
/// spins, and the same time takes more of them.
const POLLS_MAX: u32 = if cfg!(target_family = "wasm") { 1 << 16 } else { 2048 };

type Work<'a> = dyn Fn(Range<usize>) + Sync + 'a;

/// The threads of one step, its own one first.
pub struct WorkerTeam {
    threads: usize,
    work_ranges: [WorkRange; THREADS_MAX],
    current: UnsafeCell<Loop>,
    done: AtomicUsize,
    /// By bit: the workers that were recruited and have not left.
    recruited: AtomicU64,
    is_over: AtomicBool,
    panic: Mutex<Option<Box<dyn Any + Send>>>,
}

/// The work of a loop and its indices.
struct Loop {
    work: *const Work<'static>,
    count: usize,
    /// Indices in a piece.
    piece: usize,
}

// SAFETY: the owner of the team alone writes `current`, and threads with a piece of the open loop read it;
// see the module's head. The work is `Sync`, and all else is made for sharing.
unsafe impl Sync for WorkerTeam {}
// SAFETY: as above; the last worker to leave drops the team. It drops only the address of the work.
unsafe impl Send for WorkerTeam {}

// A thread that works for one step does not join another one, whose work may depend on the first.
thread_local! {
    static IS_AT_WORK: Cell<bool> = const { Cell::new(false) };
}

impl WorkerTeam {
    /// A team of up to this many threads, without workers yet.
    pub fn new(threads: usize) -> Self {
        Self {
            threads: threads.clamp(1, THREADS_MAX),
            work_ranges: [const { WorkRange::empty() }; THREADS_MAX],
            current: UnsafeCell::new(Loop { work: &(|_| ()), count: 0, piece: 1 }),
            done: AtomicUsize::new(0),
            recruited: AtomicU64::new(1),
            is_over: AtomicBool::new(false),
            panic: Mutex::new(None),
        }
    }

    /// The largest number of concurrent threads.
    pub fn threads(&self) -> usize {
        self.threads
    }

    /// Marks the calling thread as the owner of this team until the guard is dropped.
    pub fn own(&self) -> Owner<'_> {
        Owner { team: self, was_at_work: IS_AT_WORK.replace(true) }
    }

    /// Calls `work` with all pieces of `0..count`, on this thread and on recruited workers. `recruit` starts
    /// the worker with a number.
    ///
    /// # Panics
    /// If the work does: when all pieces that were begun are done.
    ///
    /// # Safety
    /// Only the owner may call this, and not from within the work.
    pub unsafe fn run(&self, count: usize, piece: usize, work: &Work<'_>, recruit: &dyn Fn(usize)) {
        let pieces = count.div_ceil(piece);
        // SAFETY: the pointer is used before this function returns.
        let work = unsafe { transmute::<*const Work<'_>, *const Work<'static>>(work) };
        // SAFETY: no loop is open, so there are no readers.
        unsafe { *self.current.get() = Loop { work, count, piece } };
        self.done.store(0, Ordering::Relaxed);
        for (k, own) in self.work_ranges[..self.threads].iter().enumerate() {
            own.give(k * pieces / self.threads..(k + 1) * pieces / self.threads);
        }
        self.fill_vacancies(recruit);
        self.work_off(0);
        let mut pause = Pause::default();
        while self.done.load(Ordering::Acquire) < pieces {
            pause.wait();
        }
        let panic = self.panic.lock().unwrap_or_else(PoisonError::into_inner).take();
        if let Some(panic) = panic {
            resume_unwind(panic);
        }
    }

    fn fill_vacancies(&self, recruit: &dyn Fn(usize)) {
        let all = u64::MAX >> (THREADS_MAX - self.threads);
        if self.recruited.load(Ordering::Relaxed) == all {
            return;
        }
        let vacancies = all & !self.recruited.fetch_or(all, Ordering::Relaxed);
        (1..self.threads).filter(|k| vacancies & (1 << k) != 0).for_each(recruit);
    }

    /// Processes pieces until the team ends, or until no work has arrived for a while. `number` is the
    /// argument of `recruit`.
    pub fn help(&self, number: usize) {
        if !IS_AT_WORK.replace(true) {
            let mut pause = Pause::default();
            while !self.is_over.load(Ordering::Relaxed) && pause.length() < POLLS_MAX {
                if self.work_off(number) {
                    pause = Pause::default();
                } else {
                    pause.wait();
                }
            }
            IS_AT_WORK.set(false);
        }
        self.recruited.fetch_and(!(1 << number), Ordering::Relaxed);
    }

    /// Works until no piece is left. Returns whether there was one.
    fn work_off(&self, own: usize) -> bool {
        let mut found = false;
        while let Some(piece) = self.claim(own) {
            found = true;
            self.perform(piece);
        }
        found
    }

    /// A piece of the thread's own range, or one of another's.
    fn claim(&self, own: usize) -> Option<usize> {
        let others = (1..self.threads).map(|k| (own + k) % self.threads);
        let steal = |k: usize| self.work_ranges[k].take_last();
        self.work_ranges[own].take_first().or_else(|| others.into_iter().find_map(steal))
    }

    fn perform(&self, piece: usize) {
        // SAFETY: the piece is not done, so the loop is open: `current` is constant, and the work is alive.
        let (work, count, size) = unsafe {
            let Loop { work, count, piece } = &*self.current.get();
            (&**work, *count, *piece)
        };
        let range = piece * size..((piece + 1) * size).min(count);
        if let Err(panic) = catch_unwind(AssertUnwindSafe(|| work(range))) {
            let mut first = self.panic.lock().unwrap_or_else(PoisonError::into_inner);
            match &*first {
                None => *first = Some(panic),
                // To drop it might panic again, and the piece would never be done.
                Some(_) => forget(panic),
            }
        }
        self.done.fetch_add(1, Ordering::Release);
    }
}

/// Ends the team.
pub struct Owner<'a> {
    team: &'a WorkerTeam,
    was_at_work: bool,
}

impl Drop for Owner<'_> {
    fn drop(&mut self) {
        self.team.is_over.store(true, Ordering::Relaxed);
        IS_AT_WORK.set(self.was_at_work);
    }
}

/// The pieces that a thread has before it, in a cache line of their own.
#[repr(align(64))]
struct WorkRange(AtomicU64);

impl WorkRange {
    const fn empty() -> Self {
        Self(AtomicU64::new(0))
    }

    fn pack(pieces: Range<usize>) -> u64 {
        (pieces.start as u64) << 32 | pieces.end as u64
    }

    fn unpack(word: u64) -> Range<usize> {
        (word >> 32) as usize..(word & u64::from(u32::MAX)) as usize
    }

    /// A thread that takes a piece reads the owner's writes.
    fn give(&self, pieces: Range<usize>) {
        self.0.store(Self::pack(pieces), Ordering::Release);
    }

    fn take_first(&self) -> Option<usize> {
        self.take(|pieces| (pieces.start, pieces.start + 1..pieces.end))
    }

    fn take_last(&self) -> Option<usize> {
        self.take(|pieces| (pieces.end - 1, pieces.start..pieces.end - 1))
    }

    /// `cut` makes a piece and the rest of some pieces.
    fn take(&self, cut: impl Fn(Range<usize>) -> (usize, Range<usize>)) -> Option<usize> {
        let mut word = self.0.load(Ordering::Relaxed);
        loop {
            let pieces = Self::unpack(word);
            if pieces.is_empty() {
                return None;
            }
            let (piece, rest) = cut(pieces);
            let (new, order) = (Self::pack(rest), Ordering::Acquire);
            match self.0.compare_exchange_weak(word, new, order, Ordering::Relaxed) {
                Ok(_) => return Some(piece),
                Err(now) => word = now,
            }
        }
    }
}

/// Waiting strategy of a thread: it spins first, and yields later.
#[derive(Default)]
struct Pause(u32);

impl Pause {
    fn length(&self) -> u32 {
        self.0
    }

    fn wait(&mut self) {
        self.0 = self.0.saturating_add(1);
        if self.0 < SPINS_MAX {
            core::hint::spin_loop();
        } else {
            std::thread::yield_now();
        }
    }
}
