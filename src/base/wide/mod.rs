//! # Wide: SIMD lanes
//!
//! A kernel of the solver is written once, over a register type `W: Wide` that holds [`LANES`]
//! numbers, and compiled once per instruction set. [`Simd::detect`] selects the fastest of the machine, and
//! [`Simd::run`] runs a kernel on it:
//!
//! | register | where | for |
//! |---|---|---|
//! | `avx.rs`: one 32-byte register | x86-64 that turns out to have AVX2 | [`Simd::detect`] |
//! | `sse2.rs`: two 16-byte registers, a [`pair`] | every other x86-64 | [`Simd::baseline`] |
//! | `simd128.rs`: the same | WebAssembly that is compiled with `simd128` | [`Simd::baseline`] |
//! | `portable.rs`: an array and loops | every other target, and tests | [`Simd::baseline`] |
//!
//! **The same bits from all of them.** Only operations that IEEE 754 rounds correctly are offered. There is
//! no fused multiply-add, no approximate reciprocal and no sum across lanes. `min` and `max` are defined by
//! one comparison, which defines their results for NaN and for zeros of either sign. Only the bits of a NaN
//! that results from arithmetic are undefined.
//!
//! **In memory** the numbers are in a [`Lane`]; the solver's constraints are blocks of lanes. [`gather`]
//! reads records in random order (the states of bodies) and transposes one record per lane into one register
//! per component; [`scatter`] writes them back.

#[cfg(target_arch = "x86_64")]
mod avx;
mod dispatch;
#[cfg(any(target_arch = "x86_64", all(target_arch = "wasm32", target_feature = "simd128")))]
mod pair;
#[cfg(any(
    test,
    not(any(target_arch = "x86_64", all(target_arch = "wasm32", target_feature = "simd128")))
))]
mod portable;
mod prefetch;
mod record;
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod simd128;
#[cfg(target_arch = "x86_64")]
mod sse2;
#[cfg(test)]
mod tests;

// The registers of `Simd::baseline`.
#[cfg(not(any(
    target_arch = "x86_64",
    all(target_arch = "wasm32", target_feature = "simd128")
)))]
use portable as baseline;
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use simd128 as baseline;
#[cfg(target_arch = "x86_64")]
use sse2 as baseline;

use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Sub};
use parry::math::Real;

pub use dispatch::{Kernel, Simd};
pub use prefetch::{PREFETCH_DISTANCE, prefetch, prefetch_front};
pub(crate) use record::{record_of_lanes, vector_of_lanes};

/// The number of lanes of a register: 8 single-precision or 4 double-precision numbers.
pub const LANES: usize = 32 / size_of::<Real>();

/// [`LANES`] numbers in memory, one per lane. Constraint blocks consist of them.
#[derive(Copy, Clone, Debug, PartialEq)]
#[repr(C, align(32))]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize),
    serde(bound(
        serialize = "[S; N]: serde::Serialize",
        deserialize = "[S; N]: serde::Deserialize<'de>"
    ))
)]
pub struct Lane<S = Real, const N: usize = LANES>(pub [S; N]);

impl Default for Lane {
    fn default() -> Self {
        Self::ZERO
    }
}

impl Lane {
    /// Zero in every lane.
    pub const ZERO: Self = Self::splat(0.0);

    /// The same number in every lane.
    pub const fn splat(value: Real) -> Self {
        Self([value; LANES])
    }
}

/// A register of `N` numbers of type `S`. Kernels use `W: Wide`, with [`LANES`] numbers of type [`Real`].
///
/// All operations act on each lane independently. Every function is `#[inline(always)]`, for the reason in
/// [`Kernel`].
#[allow(dead_code, reason = "a whole set of operations; not every dimension needs each")]
pub trait Wide<S = Real, const N: usize = LANES>:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// A yes or no per lane.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask>;

    /// Reads a lane-wide number from memory.
    fn load(lane: &Lane<S, N>) -> Self;
    /// Writes a lane-wide number to memory.
    fn store(self, lane: &mut Lane<S, N>);
    /// The same number in every lane.
    fn splat(value: S) -> Self;
    /// Zero in every lane.
    fn zero() -> Self;

    /// The square root, correctly rounded; NaN of negative numbers.
    fn sqrt(self) -> Self;
    /// The number without its sign.
    fn abs(self) -> Self;
    /// `if self < other { self } else { other }`: `other` if one is NaN, or both are zero.
    fn min(self, other: Self) -> Self;
    /// `if self > other { self } else { other }`: `other` if one is NaN, or both are zero.
    fn max(self, other: Self) -> Self;

    /// `self < other`; no if one is NaN.
    fn lt(self, other: Self) -> Self::Mask;
    /// `self <= other`; no if one is NaN.
    fn le(self, other: Self) -> Self::Mask;
    /// `yes` in the lanes where the mask is set, `no` in the others.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// Returns whether the mask is set in any lane.
    fn any(mask: Self::Mask) -> bool;
    /// One bit per lane, set where the mask is set; the first lane is the lowest bit.
    fn bits(mask: Self::Mask) -> u32;

    /// Reads `N` numbers from each of `N` places; register `k` of the result holds the `k`-th number of each.
    /// [`gather`] is the safe form.
    ///
    /// # Safety
    /// Each pointer must be good for reading `N` numbers.
    unsafe fn load_transposed(rows: [*const S; N]) -> [Self; N];

    /// Writes `N` numbers to each of `N` places; register `k` holds the `k`-th number of each. [`scatter`] is
    /// the safe form. If places overlap, either number may remain.
    ///
    /// # Safety
    /// Each pointer must be good for writing `N` numbers.
    unsafe fn store_transposed(columns: [Self; N], rows: [*mut S; N]);
}

/// `1 / value` where the value is positive, zero elsewhere.
#[inline(always)]
pub fn invert<W: Wide>(value: W) -> W {
    let positive = W::zero().lt(value);
    let one = W::splat(1.0);
    W::select(positive, one / W::select(positive, value, one), W::zero())
}

/// Does a piece of work for each group of [`LANES`] components of a record. The lines are unrolled by hand.
/// Compilers unroll a loop around so much work late or not at all, and meanwhile keep all registers of the
/// record in memory.
macro_rules! for_each_group {
    ($first:ident < $length:ident, $work:block) => {
        for_each_group!($first < $length, $work, 0 1 2 3 4 5 6 7);
        const { assert!($length.is_multiple_of(LANES) && $length <= 8 * LANES) };
    };
    ($first:ident < $length:ident, $work:block, $($group:literal)*) => {$(
        if $group * LANES < $length {
            let $first = $group * LANES;
            $work
        }
    )*};
}

/// Reads one record per lane: register `k` of the result holds component `k` of each record.
///
/// The length `N` of the records must be a multiple of [`LANES`].
#[inline(always)]
pub fn gather<W: Wide, const N: usize>(records: [&[Real; N]; LANES]) -> [W; N] {
    let mut components = [W::zero(); N];
    for_each_group!(first < N, {
        let mut rows = [core::ptr::null(); LANES];
        for (row, record) in rows.iter_mut().zip(records) {
            *row = record[first..].as_ptr();
        }
        // SAFETY: `N` is a multiple of `LANES`, so each record has `LANES` numbers from `first` on.
        let group = unsafe { W::load_transposed(rows) };
        components[first..first + LANES].copy_from_slice(&group);
    });
    components
}

/// Writes one record per lane from the registers of its components: undoes [`gather`]. Lanes whose
/// record is `None` are not written.
///
/// The length `N` of the records must be a multiple of [`LANES`].
#[inline(always)]
pub fn scatter<W: Wide, const N: usize>(
    components: [W; N],
    mut records: [Option<&mut [Real; N]>; LANES],
) {
    // Lanes without a record write here: cheaper than a mispredicted branch per lane.
    let mut sink = [0.0; LANES];
    for_each_group!(first < N, {
        let mut rows = [sink.as_mut_ptr(); LANES];
        for (row, record) in rows.iter_mut().zip(&mut records) {
            if let Some(record) = record {
                *row = record[first..].as_mut_ptr();
            }
        }
        let mut group = [W::zero(); LANES];
        group.copy_from_slice(&components[first..first + LANES]);
        // SAFETY: `N` is a multiple of `LANES`, so each record contains `LANES` numbers from `first` on, and
        // so does the sink.
        unsafe { W::store_transposed(group, rows) };
    });
}

/// As [`gather`], of the numbers of up to [`LANES`] adjacent records; the other lanes get
/// zeros.
#[inline(always)]
pub fn gather_adjacent<W: Wide, R, const N: usize>(
    records: &[R],
    numbers: impl Fn(&R) -> &[Real; N],
) -> [W; N] {
    // If all are present, their places follow from that of the first.
    if let Ok(all) = <&[R; LANES]>::try_from(records) {
        return gather(all.each_ref().map(numbers));
    }
    let mut rows = [const { &[0.0; N] }; LANES];
    for (row, record) in rows.iter_mut().zip(records) {
        *row = numbers(record);
    }
    gather(rows)
}

/// As [`scatter`], to the numbers of up to [`LANES`] adjacent records.
#[inline(always)]
pub fn scatter_adjacent<W: Wide, R, const N: usize>(
    components: [W; N],
    records: &mut [R],
    numbers: impl Fn(&mut R) -> &mut [Real; N],
) {
    if let Ok(all) = <&mut [R; LANES]>::try_from(&mut *records) {
        return scatter(components, all.each_mut().map(|record| Some(numbers(record))));
    }
    let mut rows = [const { None }; LANES];
    for (row, record) in rows.iter_mut().zip(records) {
        *row = Some(numbers(record));
    }
    scatter(components, rows);
}
