//! Registers of 32 bytes: one AVX register each.
//!
//! Only [`super::dispatch`] uses these types, on machines with AVX2. The intrinsics below are therefore sound
//! to call; each `SAFETY` comment refers to this rule.

use super::{Lane, Wide};
use core::arch::x86_64 as x86;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Sub};

/// Eight single-precision numbers.
#[derive(Copy, Clone)]
pub struct F32x8(x86::__m256);

/// Four double-precision numbers.
#[derive(Copy, Clone)]
pub struct F64x4(x86::__m256d);

/// One binary operator as one instruction.
macro_rules! operator {
    ($register:ident, $trait:ident, $method:ident, $intrinsic:ident) => {
        impl $trait for $register {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: values of this type exist only where the machine has AVX2.
                Self(unsafe { x86::$intrinsic(self.0, other.0) })
            }
        }
    };
}

/// The common part of the two registers: the same instructions under two endings.
macro_rules! register {
    ($register:ident, $scalar:ty, $lanes:literal,
     $load:ident $store:ident $set1:ident $setzero:ident $sqrt:ident $min:ident $max:ident
     $cmp:ident $blendv:ident $movemask:ident $xor:ident $andnot:ident) => {
        impl Neg for $register {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                // SAFETY: values of this type exist only where the machine has AVX2.
                Self(unsafe { x86::$xor(self.0, x86::$set1(-0.0)) })
            }
        }

        impl Wide<$scalar, $lanes> for $register {
            // All bits of a lane set for yes, none for no.
            type Mask = Self;

            #[inline(always)]
            fn load(lane: &Lane<$scalar, $lanes>) -> Self {
                // SAFETY: a lane is 32 bytes, aligned to 32; the kernel runs only where there is AVX2.
                Self(unsafe { x86::$load(lane.0.as_ptr()) })
            }
            #[inline(always)]
            fn store(self, lane: &mut Lane<$scalar, $lanes>) {
                // SAFETY: a lane is 32 bytes, aligned to 32; the kernel runs only where there is AVX2.
                unsafe { x86::$store(lane.0.as_mut_ptr(), self.0) }
            }
            #[inline(always)]
            fn splat(value: $scalar) -> Self {
                // SAFETY: the kernel runs only where the machine has AVX2.
                Self(unsafe { x86::$set1(value) })
            }
            #[inline(always)]
            fn zero() -> Self {
                // SAFETY: the kernel runs only where the machine has AVX2.
                Self(unsafe { x86::$setzero() })
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                // SAFETY: values of this type exist only where the machine has AVX2.
                Self(unsafe { x86::$sqrt(self.0) })
            }
            #[inline(always)]
            fn abs(self) -> Self {
                // SAFETY: values of this type exist only where the machine has AVX2.
                Self(unsafe { x86::$andnot(x86::$set1(-0.0), self.0) })
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                // SAFETY: values of this type exist only where the machine has AVX2.
                Self(unsafe { x86::$min(self.0, other.0) })
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                // SAFETY: values of this type exist only where the machine has AVX2.
                Self(unsafe { x86::$max(self.0, other.0) })
            }
            #[inline(always)]
            fn lt(self, other: Self) -> Self::Mask {
                // SAFETY: values of this type exist only where the machine has AVX2.
                Self(unsafe { x86::$cmp::<{ x86::_CMP_LT_OQ }>(self.0, other.0) })
            }
            #[inline(always)]
            fn le(self, other: Self) -> Self::Mask {
                // SAFETY: values of this type exist only where the machine has AVX2.
                Self(unsafe { x86::$cmp::<{ x86::_CMP_LE_OQ }>(self.0, other.0) })
            }
            #[inline(always)]
            fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
                // SAFETY: values of this type exist only where the machine has AVX2.
                Self(unsafe { x86::$blendv(no.0, yes.0, mask.0) })
            }
            #[inline(always)]
            fn any(mask: Self::Mask) -> bool {
                // SAFETY: values of this type exist only where the machine has AVX2.
                unsafe { x86::$movemask(mask.0) != 0 }
            }
            #[inline(always)]
            fn bits(mask: Self::Mask) -> u32 {
                // SAFETY: values of this type exist only where the machine has AVX2.
                unsafe { x86::$movemask(mask.0) as u32 }
            }
            #[inline(always)]
            unsafe fn load_transposed(rows: [*const $scalar; $lanes]) -> [Self; $lanes] {
                // SAFETY: the caller promises that the rows are good for reading, and the kernel runs
                // only where the machine has AVX2.
                unsafe { Self::load_columns(rows) }
            }
            #[inline(always)]
            unsafe fn store_transposed(columns: [Self; $lanes], rows: [*mut $scalar; $lanes]) {
                // SAFETY: the caller promises that the rows are good for writing, and the kernel runs
                // only where the machine has AVX2.
                unsafe { Self::store_columns(columns, rows) }
            }
        }
    };
}

operator!(F32x8, Add, add, _mm256_add_ps);
operator!(F32x8, Sub, sub, _mm256_sub_ps);
operator!(F32x8, Mul, mul, _mm256_mul_ps);
operator!(F32x8, Div, div, _mm256_div_ps);
operator!(F32x8, BitAnd, bitand, _mm256_and_ps);
operator!(F32x8, BitOr, bitor, _mm256_or_ps);
register!(F32x8, f32, 8,
    _mm256_load_ps _mm256_store_ps _mm256_set1_ps _mm256_setzero_ps _mm256_sqrt_ps _mm256_min_ps _mm256_max_ps
    _mm256_cmp_ps _mm256_blendv_ps _mm256_movemask_ps _mm256_xor_ps _mm256_andnot_ps);

operator!(F64x4, Add, add, _mm256_add_pd);
operator!(F64x4, Sub, sub, _mm256_sub_pd);
operator!(F64x4, Mul, mul, _mm256_mul_pd);
operator!(F64x4, Div, div, _mm256_div_pd);
operator!(F64x4, BitAnd, bitand, _mm256_and_pd);
operator!(F64x4, BitOr, bitor, _mm256_or_pd);
register!(F64x4, f64, 4,
    _mm256_load_pd _mm256_store_pd _mm256_set1_pd _mm256_setzero_pd _mm256_sqrt_pd _mm256_min_pd _mm256_max_pd
    _mm256_cmp_pd _mm256_blendv_pd _mm256_movemask_pd _mm256_xor_pd _mm256_andnot_pd);

// Transposing a square that is as wide as the register would need instructions that cross its middle. Instead
// each half of a register is loaded from its own record, so that halves never mix. The loads and stores
// exchange halves, and half-wide squares are left to transpose.

impl F32x8 {
    /// Transposes the 4×4 square in each half.
    ///
    /// # Safety
    /// The machine must have AVX2.
    #[inline(always)]
    unsafe fn transpose_halves([r0, r1, r2, r3]: [x86::__m256; 4]) -> [x86::__m256; 4] {
        // SAFETY: the caller promises AVX2.
        unsafe {
            let (low01, high01) =
                (x86::_mm256_unpacklo_ps(r0, r1), x86::_mm256_unpackhi_ps(r0, r1));
            let (low23, high23) =
                (x86::_mm256_unpacklo_ps(r2, r3), x86::_mm256_unpackhi_ps(r2, r3));
            [
                x86::_mm256_shuffle_ps::<0x44>(low01, low23),
                x86::_mm256_shuffle_ps::<0xee>(low01, low23),
                x86::_mm256_shuffle_ps::<0x44>(high01, high23),
                x86::_mm256_shuffle_ps::<0xee>(high01, high23),
            ]
        }
    }

    /// # Safety
    /// The machine must have AVX2, and each row must be good for reading 8 numbers.
    #[inline(always)]
    unsafe fn load_columns(rows: [*const f32; 8]) -> [Self; 8] {
        let mut columns = [Self::zero(); 8];
        for first in [0, 4] {
            // SAFETY: the rows are good for 8 numbers, and `first + 4` is at most 8.
            let square = unsafe {
                Self::transpose_halves([
                    x86::_mm256_loadu2_m128(rows[4].add(first), rows[0].add(first)),
                    x86::_mm256_loadu2_m128(rows[5].add(first), rows[1].add(first)),
                    x86::_mm256_loadu2_m128(rows[6].add(first), rows[2].add(first)),
                    x86::_mm256_loadu2_m128(rows[7].add(first), rows[3].add(first)),
                ])
            };
            for (k, column) in square.into_iter().enumerate() {
                columns[first + k] = Self(column);
            }
        }
        columns
    }

    /// # Safety
    /// The machine must have AVX2, and each row must be good for writing 8 numbers.
    #[inline(always)]
    unsafe fn store_columns(columns: [Self; 8], rows: [*mut f32; 8]) {
        let [c0, c1, c2, c3, c4, c5, c6, c7] = columns;
        // SAFETY: the caller promises AVX2.
        let (low, high) = unsafe {
            (
                Self::transpose_halves([c0.0, c1.0, c2.0, c3.0]),
                Self::transpose_halves([c4.0, c5.0, c6.0, c7.0]),
            )
        };
        for k in 0..4 {
            // SAFETY: the rows are good for 8 numbers.
            unsafe {
                x86::_mm256_storeu2_m128(rows[k + 4], rows[k], low[k]);
                x86::_mm256_storeu2_m128(rows[k + 4].add(4), rows[k].add(4), high[k]);
            }
        }
    }
}

impl F64x4 {
    /// # Safety
    /// The machine must have AVX2, and each row must be good for reading 4 numbers.
    #[inline(always)]
    unsafe fn load_columns(rows: [*const f64; 4]) -> [Self; 4] {
        let mut columns = [Self::zero(); 4];
        for first in [0, 2] {
            // SAFETY: the rows are good for 4 numbers, and `first + 2` is at most 4.
            unsafe {
                let even = x86::_mm256_loadu2_m128d(rows[2].add(first), rows[0].add(first));
                let odd = x86::_mm256_loadu2_m128d(rows[3].add(first), rows[1].add(first));
                columns[first] = Self(x86::_mm256_unpacklo_pd(even, odd));
                columns[first + 1] = Self(x86::_mm256_unpackhi_pd(even, odd));
            }
        }
        columns
    }

    /// # Safety
    /// The machine must have AVX2, and each row must be good for writing 4 numbers.
    #[inline(always)]
    unsafe fn store_columns(columns: [Self; 4], rows: [*mut f64; 4]) {
        for first in [0, 2] {
            let (a, b) = (columns[first].0, columns[first + 1].0);
            // SAFETY: the rows are good for 4 numbers, and `first + 2` is at most 4.
            unsafe {
                let (even, odd) = (x86::_mm256_unpacklo_pd(a, b), x86::_mm256_unpackhi_pd(a, b));
                x86::_mm256_storeu2_m128d(rows[2].add(first), rows[0].add(first), even);
                x86::_mm256_storeu2_m128d(rows[3].add(first), rows[1].add(first), odd);
            }
        }
    }
}
