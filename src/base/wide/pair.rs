//! Registers of 32 bytes as two halves of 16: for instruction sets whose registers are half as wide as a
//! [`Lane`].
//!
//! An instruction set implements [`Half`]; [`Pair`] is the register that kernels compute with.

use super::{Lane, Wide};
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Sub};

/// Two halves: the first holds the lower lanes.
#[derive(Copy, Clone)]
pub struct Pair<H>([H; 2]);

/// A register of 16 bytes. [`Wide`] documents the operations of the same names.
///
/// A mask is a half, too: all bits of a number are set for yes, none for no. Every function is
/// `#[inline(always)]`.
pub trait Half: Copy {
    /// The type of the numbers.
    type Scalar;
    /// As many halves as each of them has numbers.
    type Square;

    /// Reads the numbers at an address that is aligned to 16 bytes.
    ///
    /// # Safety
    /// 16 bytes must be good for reading there.
    unsafe fn load(from: *const Self::Scalar) -> Self;
    /// Writes the numbers to an address that is aligned to 16 bytes.
    ///
    /// # Safety
    /// 16 bytes must be good for writing there.
    unsafe fn store(self, to: *mut Self::Scalar);
    /// As [`Half::load`], from any address.
    ///
    /// # Safety
    /// 16 bytes must be good for reading there.
    unsafe fn load_unaligned(from: *const Self::Scalar) -> Self;
    /// As [`Half::store`], to any address.
    ///
    /// # Safety
    /// 16 bytes must be good for writing there.
    unsafe fn store_unaligned(self, to: *mut Self::Scalar);
    /// The same number everywhere.
    fn splat(value: Self::Scalar) -> Self;

    fn add(self, other: Self) -> Self;
    fn sub(self, other: Self) -> Self;
    fn mul(self, other: Self) -> Self;
    fn div(self, other: Self) -> Self;
    fn neg(self) -> Self;
    fn sqrt(self) -> Self;
    fn abs(self) -> Self;
    fn min(self, other: Self) -> Self;
    fn max(self, other: Self) -> Self;

    fn lt(self, other: Self) -> Self;
    fn le(self, other: Self) -> Self;
    fn and(self, other: Self) -> Self;
    fn or(self, other: Self) -> Self;
    fn select(mask: Self, yes: Self, no: Self) -> Self;
    fn any(mask: Self) -> bool;
    fn bits(mask: Self) -> u32;

    /// Half `k` of the result holds the `k`-th number of each.
    fn transpose(rows: Self::Square) -> Self::Square;
}

/// Functions of registers that return one.
///
/// A test build for x86-64 calls them. It solves with AVX2, and needs this module for single bodies and
/// boxes and for comparisons: inlined, they take a fifth of the engine's compile time.
macro_rules! arithmetic {
    ($(fn $name:ident($($argument:tt)*) -> Self $body:block)*) => {$(
        #[cfg_attr(all(debug_assertions, target_arch = "x86_64"), inline(never))]
        #[cfg_attr(not(all(debug_assertions, target_arch = "x86_64")), inline(always))]
        fn $name($($argument)*) -> Self $body
    )*};
}

/// Operators of two registers.
macro_rules! operators {
    ($($trait:ident $operator:ident $method:ident,)*) => {$(
        impl<H: Half> $trait for Pair<H> {
            type Output = Self;
            arithmetic! {
                fn $operator(self, other: Self) -> Self {
                    let ([a0, a1], [b0, b1]) = (self.0, other.0);
                    Self([a0.$method(b0), a1.$method(b1)])
                }
            }
        }
    )*};
}

operators!(Add add add, Sub sub sub, Mul mul mul, Div div div, BitAnd bitand and, BitOr bitor or,);

impl<H: Half> Neg for Pair<H> {
    type Output = Self;
    arithmetic! {
        fn neg(self) -> Self {
            let [low, high] = self.0;
            Self([low.neg(), high.neg()])
        }
    }
}

/// Functions of one register.
macro_rules! unary {
    ($($name:ident)*) => {
        arithmetic! {$(
            fn $name(self) -> Self {
                let [low, high] = self.0;
                Self([low.$name(), high.$name()])
            }
        )*}
    };
}

/// Functions of two registers; masks are registers.
macro_rules! binary {
    ($($name:ident)*) => {
        arithmetic! {$(
            fn $name(self, other: Self) -> Self {
                let ([a0, a1], [b0, b1]) = (self.0, other.0);
                Self([a0.$name(b0), a1.$name(b1)])
            }
        )*}
    };
}

/// The common part of registers of both precisions. A square of the full width is four squares of half the
/// width: one per half of the registers (records `half`, `half + 1`, …) and half of the records (numbers
/// `first`, `first + 1`, …).
macro_rules! register {
    ($scalar:ident, $lanes:literal) => {
        impl<H: Half<Scalar = $scalar, Square = [H; $lanes / 2]>> Wide<$scalar, $lanes>
            for Pair<H>
        {
            type Mask = Self;

            unary!(sqrt abs);
            binary!(min max lt le);

            #[inline(always)]
            fn load(lane: &Lane<$scalar, $lanes>) -> Self {
                let start = lane.0.as_ptr();
                // SAFETY: a lane is 32 bytes, aligned to 32, and so are its halves to 16.
                unsafe { Self([H::load(start), H::load(start.add($lanes / 2))]) }
            }
            #[inline(always)]
            fn store(self, lane: &mut Lane<$scalar, $lanes>) {
                let (start, [low, high]) = (lane.0.as_mut_ptr(), self.0);
                // SAFETY: a lane is 32 bytes, aligned to 32, and so are its halves to 16.
                unsafe {
                    low.store(start);
                    high.store(start.add($lanes / 2));
                }
            }
            #[inline(always)]
            fn splat(value: $scalar) -> Self {
                Self([H::splat(value); 2])
            }
            #[inline(always)]
            fn zero() -> Self {
                Self::splat(0.0)
            }
            arithmetic! {
                fn select(mask: Self, yes: Self, no: Self) -> Self {
                    let ([m0, m1], [y0, y1], [n0, n1]) = (mask.0, yes.0, no.0);
                    Self([H::select(m0, y0, n0), H::select(m1, y1, n1)])
                }
            }
            #[inline(always)]
            fn any(mask: Self) -> bool {
                let [low, high] = mask.0;
                H::any(low.or(high))
            }
            #[inline(always)]
            fn bits(mask: Self) -> u32 {
                let [low, high] = mask.0;
                H::bits(low) | H::bits(high) << ($lanes / 2)
            }
            #[inline(always)]
            unsafe fn load_transposed(rows: [*const $scalar; $lanes]) -> [Self; $lanes] {
                let mut columns = [Self::zero(); $lanes];
                for half in [0, 1] {
                    for first in [0, $lanes / 2] {
                        let mut square = [H::splat(0.0); $lanes / 2];
                        for k in 0..$lanes / 2 {
                            let row = rows[$lanes / 2 * half + k];
                            // SAFETY: rows have as many numbers as there are lanes, and half of them begin at
                            // `first`.
                            square[k] = unsafe { H::load_unaligned(row.add(first)) };
                        }
                        square = H::transpose(square);
                        for k in 0..$lanes / 2 {
                            columns[first + k].0[half] = square[k];
                        }
                    }
                }
                columns
            }
            #[inline(always)]
            unsafe fn store_transposed(columns: [Self; $lanes], rows: [*mut $scalar; $lanes]) {
                for half in [0, 1] {
                    for first in [0, $lanes / 2] {
                        let mut square = [H::splat(0.0); $lanes / 2];
                        for k in 0..$lanes / 2 {
                            square[k] = columns[first + k].0[half];
                        }
                        square = H::transpose(square);
                        for k in 0..$lanes / 2 {
                            let row = rows[$lanes / 2 * half + k];
                            // SAFETY: rows contain as many numbers as there are lanes, and half of them begin
                            // at `first`.
                            unsafe { square[k].store_unaligned(row.add(first)) };
                        }
                    }
                }
            }
        }
    };
}

register!(f32, 8);
register!(f64, 4);
