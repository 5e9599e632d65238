//! Halves of registers in SSE2, which every x86-64 machine has.

use super::pair::{Half, Pair};
use core::arch::x86_64 as x86;

/// Eight single-precision numbers.
pub type F32x8 = Pair<x86::__m128>;

/// Four double-precision numbers.
pub type F64x4 = Pair<x86::__m128d>;

/// Functions that are one instruction each.
macro_rules! instructions {
    ($($method:ident $intrinsic:ident ($($argument:ident)*))*) => {$(
        #[inline(always)]
        fn $method($($argument: Self),*) -> Self {
            // SAFETY: SSE2 is part of x86-64.
            unsafe { x86::$intrinsic($($argument),*) }
        }
    )*};
}

/// The common part of halves of both precisions: the same instructions under two endings.
macro_rules! half {
    ($half:ident, $scalar:ident, $numbers:literal, $transpose:ident,
     $load:ident $store:ident $loadu:ident $storeu:ident $set1:ident
     $add:ident $sub:ident $mul:ident $div:ident $sqrt:ident $min:ident $max:ident
     $cmplt:ident $cmple:ident $and:ident $andnot:ident $or:ident $xor:ident $movemask:ident) => {
        impl Half for x86::$half {
            type Scalar = $scalar;
            type Square = [Self; $numbers];

            instructions! {
                add $add(self other) sub $sub(self other) mul $mul(self other) div $div(self other)
                sqrt $sqrt(self) min $min(self other) max $max(self other)
                lt $cmplt(self other) le $cmple(self other) and $and(self other) or $or(self other)
            }

            #[inline(always)]
            unsafe fn load(from: *const $scalar) -> Self {
                // SAFETY: the caller promises that the address is aligned and good for reading.
                unsafe { x86::$load(from) }
            }
            #[inline(always)]
            unsafe fn store(self, to: *mut $scalar) {
                // SAFETY: the caller promises that the address is aligned and good for writing.
                unsafe { x86::$store(to, self) }
            }
            #[inline(always)]
            unsafe fn load_unaligned(from: *const $scalar) -> Self {
                // SAFETY: the caller promises that the address is good for reading.
                unsafe { x86::$loadu(from) }
            }
            #[inline(always)]
            unsafe fn store_unaligned(self, to: *mut $scalar) {
                // SAFETY: the caller promises that the address is good for writing.
                unsafe { x86::$storeu(to, self) }
            }
            #[inline(always)]
            fn splat(value: $scalar) -> Self {
                // SAFETY: SSE2 is part of x86-64.
                unsafe { x86::$set1(value) }
            }
            #[inline(always)]
            fn neg(self) -> Self {
                // SAFETY: SSE2 is part of x86-64.
                unsafe { x86::$xor(self, x86::$set1(-0.0)) }
            }
            #[inline(always)]
            fn abs(self) -> Self {
                // SAFETY: SSE2 is part of x86-64.
                unsafe { x86::$andnot(x86::$set1(-0.0), self) }
            }
            #[inline(always)]
            fn select(mask: Self, yes: Self, no: Self) -> Self {
                // SAFETY: SSE2 is part of x86-64.
                unsafe { x86::$or(x86::$and(mask, yes), x86::$andnot(mask, no)) }
            }
            #[inline(always)]
            fn any(mask: Self) -> bool {
                Self::bits(mask) != 0
            }
            #[inline(always)]
            fn bits(mask: Self) -> u32 {
                // SAFETY: SSE2 is part of x86-64.
                unsafe { x86::$movemask(mask) as u32 }
            }
            #[inline(always)]
            fn transpose(rows: [Self; $numbers]) -> [Self; $numbers] {
                $transpose(rows)
            }
        }
    };
}

half!(__m128, f32, 4, transpose_singles,
    _mm_load_ps _mm_store_ps _mm_loadu_ps _mm_storeu_ps _mm_set1_ps
    _mm_add_ps _mm_sub_ps _mm_mul_ps _mm_div_ps _mm_sqrt_ps _mm_min_ps _mm_max_ps
    _mm_cmplt_ps _mm_cmple_ps _mm_and_ps _mm_andnot_ps _mm_or_ps _mm_xor_ps _mm_movemask_ps);

half!(__m128d, f64, 2, transpose_doubles,
    _mm_load_pd _mm_store_pd _mm_loadu_pd _mm_storeu_pd _mm_set1_pd
    _mm_add_pd _mm_sub_pd _mm_mul_pd _mm_div_pd _mm_sqrt_pd _mm_min_pd _mm_max_pd
    _mm_cmplt_pd _mm_cmple_pd _mm_and_pd _mm_andnot_pd _mm_or_pd _mm_xor_pd _mm_movemask_pd);

#[inline(always)]
fn transpose_singles([r0, r1, r2, r3]: [x86::__m128; 4]) -> [x86::__m128; 4] {
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

#[inline(always)]
fn transpose_doubles([even, odd]: [x86::__m128d; 2]) -> [x86::__m128d; 2] {
    // SAFETY: SSE2 is part of x86-64.
    unsafe { [x86::_mm_unpacklo_pd(even, odd), x86::_mm_unpackhi_pd(even, odd)] }
}
