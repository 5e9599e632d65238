//! Halves of registers in WebAssembly's `simd128`, for programs that are compiled with it.
//!
//! A program either has these instructions or is not loaded at all, so the register is chosen when the
//! program is compiled. The instructions of relaxed SIMD stay unused: their results differ between
//! processors.

use super::pair::{Half, Pair};
use core::arch::wasm32 as wasm;

/// Eight single-precision numbers.
pub type F32x8 = Pair<F32x4>;

/// Four double-precision numbers.
pub type F64x4 = Pair<F64x2>;

/// Four single-precision numbers.
#[derive(Copy, Clone)]
pub struct F32x4(wasm::v128);

/// Two double-precision numbers.
#[derive(Copy, Clone)]
pub struct F64x2(wasm::v128);

/// Functions that are one instruction each, with its arguments in this order.
macro_rules! instructions {
    ($($method:ident $intrinsic:ident ($self:ident $($other:ident)?) ($($argument:ident)*))*) => {$(
        #[inline(always)]
        fn $method($self $(, $other: Self)?) -> Self {
            Self(wasm::$intrinsic($($argument.0),*))
        }
    )*};
}

/// The common part of halves of both precisions: the same instructions under two names.
macro_rules! half {
    ($half:ident, $scalar:ident, $numbers:literal, $splat:ident
     $add:ident $sub:ident $mul:ident $div:ident $neg:ident $sqrt:ident $abs:ident $pmin:ident $pmax:ident
     $lt:ident $le:ident $bitmask:ident) => {
        impl Half for $half {
            type Scalar = $scalar;
            type Square = [Self; $numbers];

            instructions! {
                add $add(self other)(self other) sub $sub(self other)(self other)
                mul $mul(self other)(self other) div $div(self other)(self other)
                neg $neg(self)(self) sqrt $sqrt(self)(self) abs $abs(self)(self)
                // `pmin` of `a` and `b` is `if b < a { b } else { a }`, so the arguments change places.
                min $pmin(self other)(other self) max $pmax(self other)(other self)
                lt $lt(self other)(self other) le $le(self other)(self other)
                and v128_and(self other)(self other) or v128_or(self other)(self other)
            }

            #[inline(always)]
            unsafe fn load(from: *const $scalar) -> Self {
                // SAFETY: the caller promises that the address is good for reading.
                unsafe { Self::load_unaligned(from) }
            }
            #[inline(always)]
            unsafe fn store(self, to: *mut $scalar) {
                // SAFETY: the caller promises that the address is good for writing.
                unsafe { self.store_unaligned(to) }
            }
            #[inline(always)]
            unsafe fn load_unaligned(from: *const $scalar) -> Self {
                // SAFETY: the caller promises that the address is good for reading.
                Self(unsafe { wasm::v128_load(from.cast()) })
            }
            #[inline(always)]
            unsafe fn store_unaligned(self, to: *mut $scalar) {
                // SAFETY: the caller promises that the address is good for writing.
                unsafe { wasm::v128_store(to.cast(), self.0) }
            }
            #[inline(always)]
            fn splat(value: $scalar) -> Self {
                Self(wasm::$splat(value))
            }
            #[inline(always)]
            fn select(mask: Self, yes: Self, no: Self) -> Self {
                Self(wasm::v128_bitselect(yes.0, no.0, mask.0))
            }
            #[inline(always)]
            fn any(mask: Self) -> bool {
                wasm::v128_any_true(mask.0)
            }
            #[inline(always)]
            fn bits(mask: Self) -> u32 {
                u32::from(wasm::$bitmask(mask.0))
            }
            #[inline(always)]
            fn transpose(rows: [Self; $numbers]) -> [Self; $numbers] {
                Self::transpose_square(rows)
            }
        }
    };
}

half!(F32x4, f32, 4, f32x4_splat
    f32x4_add f32x4_sub f32x4_mul f32x4_div f32x4_neg f32x4_sqrt f32x4_abs f32x4_pmin f32x4_pmax
    f32x4_lt f32x4_le i32x4_bitmask);

half!(F64x2, f64, 2, f64x2_splat
    f64x2_add f64x2_sub f64x2_mul f64x2_div f64x2_neg f64x2_sqrt f64x2_abs f64x2_pmin f64x2_pmax
    f64x2_lt f64x2_le i64x2_bitmask);

impl F32x4 {
    #[inline(always)]
    fn transpose_square([r0, r1, r2, r3]: [Self; 4]) -> [Self; 4] {
        let low01 = wasm::i32x4_shuffle::<0, 4, 1, 5>(r0.0, r1.0);
        let high01 = wasm::i32x4_shuffle::<2, 6, 3, 7>(r0.0, r1.0);
        let low23 = wasm::i32x4_shuffle::<0, 4, 1, 5>(r2.0, r3.0);
        let high23 = wasm::i32x4_shuffle::<2, 6, 3, 7>(r2.0, r3.0);
        [
            Self(wasm::i64x2_shuffle::<0, 2>(low01, low23)),
            Self(wasm::i64x2_shuffle::<1, 3>(low01, low23)),
            Self(wasm::i64x2_shuffle::<0, 2>(high01, high23)),
            Self(wasm::i64x2_shuffle::<1, 3>(high01, high23)),
        ]
    }
}

impl F64x2 {
    #[inline(always)]
    fn transpose_square([even, odd]: [Self; 2]) -> [Self; 2] {
        [
            Self(wasm::i64x2_shuffle::<0, 2>(even.0, odd.0)),
            Self(wasm::i64x2_shuffle::<1, 3>(even.0, odd.0)),
        ]
    }
}
