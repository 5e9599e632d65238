//! Handles as numbers of JavaScript.
//!
//! The 64 bits of slot (low) and generation (high) are read as a double, as the published packages do. The
//! conversion is free in WebAssembly.

use crate::rapier::dynamics::{ImpulseJointHandle, MultibodyJointHandle, RigidBodyHandle};
use crate::rapier::geometry::ColliderHandle;

/// The number of a slot and a generation.
fn number((slot, generation): (u32, u32)) -> f64 {
    f64::from_bits(u64::from(slot) | (u64::from(generation) << 32))
}

/// Slot and generation of a number.
fn parts(number: f64) -> (u32, u32) {
    let bits = number.to_bits();
    (bits as u32, (bits >> 32) as u32)
}

/// A handle that crosses the boundary as a number.
pub trait Handle: Sized {
    /// The number of the handle.
    fn to_number(self) -> f64;
    /// The handle of a number. Any number is a handle, although possibly a stale one.
    fn of_number(number: f64) -> Self;
}

macro_rules! handle {
    ($($kind:ident),*) => {$(
        impl Handle for $kind {
            #[inline]
            fn to_number(self) -> f64 {
                number(self.into_raw_parts())
            }

            #[inline]
            fn of_number(number: f64) -> Self {
                let (slot, generation) = parts(number);
                Self::from_raw_parts(slot, generation)
            }
        }
    )*};
}

handle!(RigidBodyHandle, ColliderHandle, ImpulseJointHandle, MultibodyJointHandle);

/// The number of a handle, or NaN for an absent one.
pub fn optional(handle: Option<impl Handle>) -> f64 {
    handle.map_or(f64::NAN, Handle::to_number)
}
