//! Instruction set of kernels, selected once at run time.

use super::Wide;
use parry::math::Real;

/// A piece of work that is compiled once per instruction set.
///
/// ```ignore
/// struct Scale<'a> { factor: Real, numbers: &'a mut [Lane] }
///
/// impl Kernel for Scale<'_> {
///     type Output = ();
///     #[inline(always)] // not optional, see below
///     fn run<W: Wide>(self) {
///         let factor = W::splat(self.factor);
///         for number in self.numbers {
///             (W::load(number) * factor).store(number);
///         }
///     }
/// }
///
/// simd.run(Scale { factor: 2.0, numbers: &mut numbers });
/// ```
///
/// # Why everything is `#[inline(always)]`
/// The compiler may use AVX instructions only inside a function with `#[target_feature(enable = "avx2")]`,
/// and such a function cannot be inlined into one without it. There is exactly one such function, in this
/// file. `run` and all callees with register arguments are plain `#[inline(always)]` functions. Their code
/// ends up *inside* that function, and there the intrinsics become single instructions. A function that is
/// not inlined has no AVX, and each `+` in it is a call that passes registers through memory. It is correct,
/// but ten times slower. Hence:
///
/// * `#[inline(always)]` on `run` and on every function that takes, makes or returns a `W`;
/// * no closure that touches a `W`, and so no `map` or `fold` over registers: closures cannot be
///   marked. Closures that touch only memory or indices are fine, and so are loops.
///
/// WebAssembly selects its instructions at compile time, and its modules are downloaded. Large functions that
/// kernels call from several places are `#[cfg_attr(not(target_arch = "wasm32"), inline(always))]`: there the
/// compiler decides, and keeps one copy.
pub trait Kernel {
    /// Result of the kernel.
    type Output;
    /// Does the work in registers of type `W`. Must be `#[inline(always)]`.
    fn run<W: Wide>(self) -> Self::Output;
}

/// The instruction set that kernels run on. The choice changes the speed and no bit of the results.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Simd(Level);

#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum Level {
    /// Proof token: this value exists only if the machine has AVX2.
    #[cfg(target_arch = "x86_64")]
    Avx2,
    Baseline,
}

impl Default for Simd {
    fn default() -> Self {
        Self::detect()
    }
}

impl Simd {
    /// The fastest instruction set that this machine has.
    pub fn detect() -> Self {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            return Self(Level::Avx2);
        }
        Self::baseline()
    }

    /// The baseline of this architecture.
    pub const fn baseline() -> Self {
        Self(Level::Baseline)
    }

    /// Runs a kernel on this instruction set.
    #[inline]
    pub fn run<K: Kernel>(self, kernel: K) -> K::Output {
        match self.0 {
            #[cfg(target_arch = "x86_64")]
            // SAFETY: `Level::Avx2` is made by `detect` alone, after `is_x86_feature_detected`.
            Level::Avx2 => unsafe { run_avx2(kernel) },
            Level::Baseline => run_baseline(kernel),
        }
    }
}

/// The one place where kernels are compiled for AVX2.
///
/// # Safety
/// The machine must have AVX2.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
unsafe fn run_avx2<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<<Real as Registers>::Avx>()
}

/// A function of its own, so that profiles show which of the two ran.
#[inline(never)]
fn run_baseline<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<<Real as Registers>::Baseline>()
}

/// The registers that hold numbers of this type.
trait Registers {
    #[cfg(target_arch = "x86_64")]
    type Avx;
    type Baseline;
}

impl Registers for f32 {
    #[cfg(target_arch = "x86_64")]
    type Avx = super::avx::F32x8;
    type Baseline = super::baseline::F32x8;
}

impl Registers for f64 {
    #[cfg(target_arch = "x86_64")]
    type Avx = super::avx::F64x4;
    type Baseline = super::baseline::F64x4;
}
