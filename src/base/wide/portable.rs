//! Registers of 32 bytes as arrays and loops: for targets that have no file of their own here, such as
//! WebAssembly without SIMD.
//!
//! The compiler vectorises the loops at optimisation level 3 only. On x86-64 this file is compiled for tests
//! only, as the reference of the other files.

use super::{Lane, Wide};
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Sub};

/// A number or a boolean per lane.
#[derive(Copy, Clone)]
#[repr(C, align(32))]
pub struct Array<T, const N: usize>([T; N]);

impl<T: Copy, const N: usize> Array<T, N> {
    #[inline(always)]
    fn map<U>(self, f: impl Fn(T) -> U) -> Array<U, N> {
        Array(core::array::from_fn(|lane| f(self.0[lane])))
    }

    #[inline(always)]
    fn zip<U: Copy, V>(self, other: Array<U, N>, f: impl Fn(T, U) -> V) -> Array<V, N> {
        Array(core::array::from_fn(|lane| f(self.0[lane], other.0[lane])))
    }
}

/// One binary operator, lane by lane.
macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl<T: Copy + $trait<Output = T>, const N: usize> $trait for Array<T, N> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, T::$method)
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);
operator!(BitAnd, bitand);
operator!(BitOr, bitor);

impl<T: Copy + Neg<Output = T>, const N: usize> Neg for Array<T, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(T::neg)
    }
}

/// The common part of the two registers.
macro_rules! register {
    ($register:ident, $scalar:ident, $lanes:literal) => {
        impl Wide<$scalar, $lanes> for $register {
            type Mask = Array<bool, $lanes>;

            #[inline(always)]
            fn load(lane: &Lane<$scalar, $lanes>) -> Self {
                Self(lane.0)
            }
            #[inline(always)]
            fn store(self, lane: &mut Lane<$scalar, $lanes>) {
                lane.0 = self.0;
            }
            #[inline(always)]
            fn splat(value: $scalar) -> Self {
                Self([value; $lanes])
            }
            #[inline(always)]
            fn zero() -> Self {
                Self::splat(0.0)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                self.map($scalar::sqrt)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                self.map($scalar::abs)
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                // Not the standard library's `min`, which avoids NaN and leaves the zero's sign open.
                self.zip(other, |a, b| if a < b { a } else { b })
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                self.zip(other, |a, b| if a > b { a } else { b })
            }
            #[inline(always)]
            fn lt(self, other: Self) -> Self::Mask {
                self.zip(other, |a, b| a < b)
            }
            #[inline(always)]
            fn le(self, other: Self) -> Self::Mask {
                self.zip(other, |a, b| a <= b)
            }
            #[inline(always)]
            fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
                mask.zip(
                    yes.zip(no, |yes, no| (yes, no)),
                    |mask, (yes, no)| {
                        if mask { yes } else { no }
                    },
                )
            }
            #[inline(always)]
            fn any(mask: Self::Mask) -> bool {
                mask.0.contains(&true)
            }
            #[inline(always)]
            fn bits(mask: Self::Mask) -> u32 {
                mask.0.iter().rev().fold(0, |bits, &yes| bits << 1 | u32::from(yes))
            }
            #[inline(always)]
            unsafe fn load_transposed(rows: [*const $scalar; $lanes]) -> [Self; $lanes] {
                let mut columns = [Self::zero(); $lanes];
                for (lane, row) in rows.into_iter().enumerate() {
                    for (k, column) in columns.iter_mut().enumerate() {
                        // SAFETY: the caller promises that each row has as many numbers as there are lanes.
                        column.0[lane] = unsafe { *row.add(k) };
                    }
                }
                columns
            }
            #[inline(always)]
            unsafe fn store_transposed(columns: [Self; $lanes], rows: [*mut $scalar; $lanes]) {
                for (lane, row) in rows.into_iter().enumerate() {
                    for (k, column) in columns.iter().enumerate() {
                        // SAFETY: the caller guarantees that each row contains as many numbers as there are
                        // lanes.
                        unsafe { *row.add(k) = column.0[lane] };
                    }
                }
            }
        }
    };
}

/// Eight single-precision numbers.
pub type F32x8 = Array<f32, 8>;
register!(F32x8, f32, 8);

/// Four double-precision numbers.
pub type F64x4 = Array<f64, 4>;
register!(F64x4, f64, 4);
