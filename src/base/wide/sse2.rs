//! Registers of 32 bytes: two SSE2 registers each, which every x86-64 machine has.

use super::{Lane, Wide};
use core::arch::x86_64 as x86;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Sub};

/// Eight single-precision numbers.
#[derive(Copy, Clone)]
pub struct F32x8([x86::__m128; 2]);

/// Four double-precision numbers.
#[derive(Copy, Clone)]
pub struct F64x4([x86::__m128d; 2]);

/// One binary operator as one instruction per half.
macro_rules! operator {
    ($register:ident, $trait:ident, $method:ident, $intrinsic:ident) => {
        impl $trait for $register {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: SSE2 is part of x86-64.
                unsafe {
                    Self([
                        x86::$intrinsic(self.0[0], other.0[0]),
                        x86::$intrinsic(self.0[1], other.0[1]),
                    ])
                }
            }
        }
    };
}

/// What the two registers have in common: the same instructions under two endings.
macro_rules! register {
    ($register:ident, $scalar:ty, $lanes:literal,
     $load:ident $store:ident $set1:ident $setzero:ident $sqrt:ident $min:ident $max:ident
     $cmplt:ident $cmple:ident $and:ident $andnot:ident $or:ident $xor:ident $movemask:ident) => {
        operator!($register, BitAnd, bitand, $and);
        operator!($register, BitOr, bitor, $or);

        impl Neg for $register {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                let [low, high] = self.0;
                // SAFETY: SSE2 is part of x86-64.
                unsafe {
                    let sign = x86::$set1(-0.0);
                    Self([x86::$xor(low, sign), x86::$xor(high, sign)])
                }
            }
        }

        impl Wide<$scalar, $lanes> for $register {
            // All bits of a lane set for yes, none for no.
            type Mask = Self;

            #[inline(always)]
            fn load(lane: &Lane<$scalar, $lanes>) -> Self {
                let start = lane.0.as_ptr();
                // SAFETY: a lane is 32 bytes, aligned to 32, and so are its halves to 16.
                unsafe { Self([x86::$load(start), x86::$load(start.add($lanes / 2))]) }
            }
            #[inline(always)]
            fn store(self, lane: &mut Lane<$scalar, $lanes>) {
                let start = lane.0.as_mut_ptr();
                // SAFETY: a lane is 32 bytes, aligned to 32, and so are its halves to 16.
                unsafe {
                    x86::$store(start, self.0[0]);
                    x86::$store(start.add($lanes / 2), self.0[1]);
                }
            }
            #[inline(always)]
            fn splat(value: $scalar) -> Self {
                // SAFETY: SSE2 is part of x86-64.
                Self([unsafe { x86::$set1(value) }; 2])
            }
            #[inline(always)]
            fn zero() -> Self {
                // SAFETY: SSE2 is part of x86-64.
                Self([unsafe { x86::$setzero() }; 2])
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                // SAFETY: SSE2 is part of x86-64.
                unsafe { Self([x86::$sqrt(self.0[0]), x86::$sqrt(self.0[1])]) }
            }
            #[inline(always)]
            fn abs(self) -> Self {
                let [low, high] = self.0;
                // SAFETY: SSE2 is part of x86-64.
                unsafe {
                    let sign = x86::$set1(-0.0);
                    Self([x86::$andnot(sign, low), x86::$andnot(sign, high)])
                }
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                let ([a0, a1], [b0, b1]) = (self.0, other.0);
                // SAFETY: SSE2 is part of x86-64.
                unsafe { Self([x86::$min(a0, b0), x86::$min(a1, b1)]) }
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                let ([a0, a1], [b0, b1]) = (self.0, other.0);
                // SAFETY: SSE2 is part of x86-64.
                unsafe { Self([x86::$max(a0, b0), x86::$max(a1, b1)]) }
            }
            #[inline(always)]
            fn lt(self, other: Self) -> Self::Mask {
                let ([a0, a1], [b0, b1]) = (self.0, other.0);
                // SAFETY: SSE2 is part of x86-64.
                unsafe { Self([x86::$cmplt(a0, b0), x86::$cmplt(a1, b1)]) }
            }
            #[inline(always)]
            fn le(self, other: Self) -> Self::Mask {
                let ([a0, a1], [b0, b1]) = (self.0, other.0);
                // SAFETY: SSE2 is part of x86-64.
                unsafe { Self([x86::$cmple(a0, b0), x86::$cmple(a1, b1)]) }
            }
            #[inline(always)]
            fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
                let ([m0, m1], [n0, n1]) = (mask.0, no.0);
                // SAFETY: SSE2 is part of x86-64.
                (mask & yes) | unsafe { Self([x86::$andnot(m0, n0), x86::$andnot(m1, n1)]) }
            }
            #[inline(always)]
            fn any(mask: Self::Mask) -> bool {
                // SAFETY: SSE2 is part of x86-64.
                unsafe { x86::$movemask(x86::$or(mask.0[0], mask.0[1])) != 0 }
            }
            #[inline(always)]
            fn bits(mask: Self::Mask) -> u32 {
                // SAFETY: SSE2 is part of x86-64.
                let [low, high] = mask.0.map(|half| unsafe { x86::$movemask(half) as u32 });
                low | high << ($lanes / 2)
            }
            #[inline(always)]
            unsafe fn load_transposed(rows: [*const $scalar; $lanes]) -> [Self; $lanes] {
                // SAFETY: the caller promises that the rows are good for reading.
                unsafe { Self::load_columns(rows) }
            }
            #[inline(always)]
            unsafe fn store_transposed(columns: [Self; $lanes], rows: [*mut $scalar; $lanes]) {
                // SAFETY: the caller promises that the rows are good for writing.
                unsafe { Self::store_columns(columns, rows) }
            }
        }
    };
}

operator!(F32x8, Add, add, _mm_add_ps);
operator!(F32x8, Sub, sub, _mm_sub_ps);
operator!(F32x8, Mul, mul, _mm_mul_ps);
operator!(F32x8, Div, div, _mm_div_ps);
register!(F32x8, f32, 8,
    _mm_load_ps _mm_store_ps _mm_set1_ps _mm_setzero_ps _mm_sqrt_ps _mm_min_ps _mm_max_ps
    _mm_cmplt_ps _mm_cmple_ps _mm_and_ps _mm_andnot_ps _mm_or_ps _mm_xor_ps _mm_movemask_ps);

operator!(F64x4, Add, add, _mm_add_pd);
operator!(F64x4, Sub, sub, _mm_sub_pd);
operator!(F64x4, Mul, mul, _mm_mul_pd);
operator!(F64x4, Div, div, _mm_div_pd);
register!(F64x4, f64, 4,
    _mm_load_pd _mm_store_pd _mm_set1_pd _mm_setzero_pd _mm_sqrt_pd _mm_min_pd _mm_max_pd
    _mm_cmplt_pd _mm_cmple_pd _mm_and_pd _mm_andnot_pd _mm_or_pd _mm_xor_pd _mm_movemask_pd);

// A square of the full width is four squares of half the width: one per half of the registers (the
// records `half`, `half + 1`, …) and half of the records (their numbers `first`, `first + 1`, …).

impl F32x8 {
    #[inline(always)]
    fn transpose_square([r0, r1, r2, r3]: [x86::__m128; 4]) -> [x86::__m128; 4] {
        // SAFETY: SSE2 is part of x86-64.
        unsafe {
            let (low01, high01) = (x86::_mm_unpacklo_ps(r0, r1), x86::_mm_unpackhi_ps(r0, r1));
            let (low23, high23) = (x86::_mm_unpacklo_ps(r2, r3), x86::_mm_unpackhi_ps(r2, r3));
            [
                x86::_mm_movelh_ps(low01, low23),
                x86::_mm_movehl_ps(low23, low01),
                x86::_mm_movelh_ps(high01, high23),
                x86::_mm_movehl_ps(high23, high01),
            ]
        }
    }

    /// # Safety
    /// Each row must be good for reading 8 numbers.
    #[inline(always)]
    unsafe fn load_columns(rows: [*const f32; 8]) -> [Self; 8] {
        let mut columns = [Self::zero(); 8];
        for half in [0, 1] {
            for first in [0, 4] {
                // SAFETY: the rows are good for 8 numbers, and `first + 4` is at most 8.
                let square = Self::transpose_square(unsafe {
                    [
                        x86::_mm_loadu_ps(rows[4 * half].add(first)),
                        x86::_mm_loadu_ps(rows[4 * half + 1].add(first)),
                        x86::_mm_loadu_ps(rows[4 * half + 2].add(first)),
                        x86::_mm_loadu_ps(rows[4 * half + 3].add(first)),
                    ]
                });
                for k in 0..4 {
                    columns[first + k].0[half] = square[k];
                }
            }
        }
        columns
    }

    /// # Safety
    /// Each row must be good for writing 8 numbers.
    #[inline(always)]
    unsafe fn store_columns(columns: [Self; 8], rows: [*mut f32; 8]) {
        for half in [0, 1] {
            for first in [0, 4] {
                let square = Self::transpose_square([
                    columns[first].0[half],
                    columns[first + 1].0[half],
                    columns[first + 2].0[half],
                    columns[first + 3].0[half],
                ]);
                for k in 0..4 {
                    // SAFETY: the rows are good for 8 numbers, and `first + 4` is at most 8.
                    unsafe { x86::_mm_storeu_ps(rows[4 * half + k].add(first), square[k]) };
                }
            }
        }
    }
}

impl F64x4 {
    /// # Safety
    /// Each row must be good for reading 4 numbers.
    #[inline(always)]
    unsafe fn load_columns(rows: [*const f64; 4]) -> [Self; 4] {
        let mut columns = [Self::zero(); 4];
        for half in [0, 1] {
            for first in [0, 2] {
                // SAFETY: the rows are good for 4 numbers, and `first + 2` is at most 4.
                unsafe {
                    let even = x86::_mm_loadu_pd(rows[2 * half].add(first));
                    let odd = x86::_mm_loadu_pd(rows[2 * half + 1].add(first));
                    columns[first].0[half] = x86::_mm_unpacklo_pd(even, odd);
                    columns[first + 1].0[half] = x86::_mm_unpackhi_pd(even, odd);
                }
            }
        }
        columns
    }

    /// # Safety
    /// Each row must be good for writing 4 numbers.
    #[inline(always)]
    unsafe fn store_columns(columns: [Self; 4], rows: [*mut f64; 4]) {
        for half in [0, 1] {
            for first in [0, 2] {
                let (a, b) = (columns[first].0[half], columns[first + 1].0[half]);
                // SAFETY: the rows are good for 4 numbers, and `first + 2` is at most 4.
                unsafe {
                    x86::_mm_storeu_pd(rows[2 * half].add(first), x86::_mm_unpacklo_pd(a, b));
                    x86::_mm_storeu_pd(rows[2 * half + 1].add(first), x86::_mm_unpackhi_pd(a, b));
                }
            }
        }
    }
}
