//! The memory that both sides of the boundary read and write: the scratch block, lists of handles, buffers
//! for input, and texts.
//!
//! JavaScript calls the module on one thread. Workers run tasks of the engine alone, which do not use these
//! cells. No reference into the cells lives across a call to JavaScript or to another function of this file.

use crate::fault::{Fault, finite};
use crate::rapier::math::{AngVector, Pose, Real, Rotation, Vector};
use core::cell::UnsafeCell;

/// A static value of the thread that JavaScript calls.
pub struct Single<T>(UnsafeCell<T>);

// SAFETY: one thread uses the value, see the module's head.
unsafe impl<T> Sync for Single<T> {}

impl<T> Single<T> {
    /// A cell with its first value.
    pub const fn new(value: T) -> Self {
        Self(UnsafeCell::new(value))
    }

    /// The value.
    ///
    /// # Safety
    /// No other reference to the value is alive while this one is.
    #[allow(
        clippy::mut_from_ref,
        reason = "the caller promises that the reference is the only one"
    )]
    pub unsafe fn get(&self) -> &mut T {
        // SAFETY: the caller's promise.
        unsafe { &mut *self.0.get() }
    }

    /// The address of the value.
    pub fn address(&self) -> usize {
        self.0.get() as usize
    }
}

/// The numbers of a place of the scratch block: room for a vector or a rotation.
const PLACE: usize = 4;
/// The places of the scratch block.
const PLACES: usize = 24;

static SCRATCH: Single<[Real; PLACE * PLACES]> = Single::new([0.0; PLACE * PLACES]);
static LIST: Single<Vec<f64>> = Single::new(Vec::new());
static REALS: Single<Vec<Real>> = Single::new(Vec::new());
static INTEGERS: Single<Vec<u32>> = Single::new(Vec::new());
static BYTES: Single<Vec<u8>> = Single::new(Vec::new());
static TEXT: Single<Vec<u8>> = Single::new(Vec::new());
static WARNING: Single<String> = Single::new(String::new());

// ---- Scratch ----

/// A number of the scratch block.
pub fn number(place: usize, component: usize) -> Real {
    // SAFETY: the reference ends with the statement.
    unsafe { SCRATCH.get()[PLACE * place + component] }
}

/// Writes a number of the scratch block.
pub fn put_number(place: usize, component: usize, value: Real) {
    // SAFETY: the reference ends with the statement.
    unsafe { SCRATCH.get()[PLACE * place + component] = value };
}

/// A vector of the scratch block. The name is for the error.
pub fn vector(place: usize, name: &str) -> Result<Vector, Fault> {
    let vector = raw_vector(place);
    match vector.is_finite() {
        true => Ok(vector),
        false => Err(Fault::invalid(format_args!(
            "{name} is {vector}, but its components must be finite numbers"
        ))),
    }
}

/// A direction of the scratch block: a vector of a length that is not zero.
pub fn direction(place: usize, name: &str) -> Result<Vector, Fault> {
    let vector = vector(place, name)?;
    match vector.length() > 0.0 {
        true => Ok(vector),
        false => Err(Fault::invalid(format_args!(
            "{name} is {vector}, but must have a length greater than 0"
        ))),
    }
}

#[cfg(feature = "dim2")]
fn raw_vector(place: usize) -> Vector {
    Vector::new(number(place, 0), number(place, 1))
}

#[cfg(not(feature = "dim2"))]
fn raw_vector(place: usize) -> Vector {
    Vector::new(number(place, 0), number(place, 1), number(place, 2))
}

/// Writes a vector into the scratch block.
pub fn put_vector(place: usize, vector: Vector) {
    for (component, value) in vector.to_array().into_iter().enumerate() {
        put_number(place, component, value);
    }
}

/// A rotation of the scratch block: an angle in 2D, a quaternion in 3D.
#[cfg(feature = "dim2")]
pub fn rotation(place: usize, name: &str) -> Result<Rotation, Fault> {
    Ok(crate::rapier::math::rotation_from_angle(finite(name, number(place, 0))?))
}

/// A rotation of the scratch block: an angle in 2D, a quaternion in 3D.
#[cfg(not(feature = "dim2"))]
pub fn rotation(place: usize, name: &str) -> Result<Rotation, Fault> {
    let [x, y, z, w] = [0, 1, 2, 3].map(|component| number(place, component));
    for value in [x, y, z, w] {
        finite(name, value)?;
    }
    let quaternion = Rotation::from_xyzw(x, y, z, w);
    let length = quaternion.length();
    if (length - 1.0).abs() < 1.0e-6 {
        return Ok(quaternion);
    }
    match length > 1.0e-6 && length.is_finite() {
        true => Ok(quaternion.normalize()),
        false => Err(Fault::invalid(format_args!(
            "{name} is {quaternion}, but a rotation must be a quaternion of unit length"
        ))),
    }
}

/// Writes a rotation into the scratch block.
#[cfg(feature = "dim2")]
pub fn put_rotation(place: usize, rotation: Rotation) {
    put_number(place, 0, rotation.angle());
}

/// Writes a rotation into the scratch block.
#[cfg(not(feature = "dim2"))]
pub fn put_rotation(place: usize, rotation: Rotation) {
    for (component, value) in rotation.to_array().into_iter().enumerate() {
        put_number(place, component, value);
    }
}

/// An angular velocity, torque or moment of inertia of the scratch block: a number in 2D, a vector in 3D.
#[cfg(feature = "dim2")]
pub fn angular(place: usize, name: &str) -> Result<AngVector, Fault> {
    finite(name, number(place, 0))
}

/// An angular velocity, torque or moment of inertia of the scratch block: a number in 2D, a vector in 3D.
#[cfg(not(feature = "dim2"))]
pub fn angular(place: usize, name: &str) -> Result<AngVector, Fault> {
    vector(place, name)
}

/// Writes an angular quantity into the scratch block.
#[cfg(feature = "dim2")]
pub fn put_angular(place: usize, value: AngVector) {
    put_number(place, 0, value);
}

/// Writes an angular quantity into the scratch block.
#[cfg(not(feature = "dim2"))]
pub fn put_angular(place: usize, value: AngVector) {
    put_vector(place, value);
}

/// A pose of two places of the scratch block: the translation, then the rotation.
pub fn pose(place: usize) -> Result<Pose, Fault> {
    Ok(Pose::from_parts(vector(place, "the translation")?, rotation(place + 1, "the rotation")?))
}

// ---- Lists ----

/// Replaces the list that JavaScript reads after the call.
pub fn put_list(numbers: impl IntoIterator<Item = f64>) -> u32 {
    // SAFETY: the iterators of this crate do not use the list.
    let list = unsafe { LIST.get() };
    list.clear();
    list.extend(numbers);
    list.len() as u32
}

/// Replaces the real numbers that JavaScript reads after the call.
pub fn put_reals(numbers: impl IntoIterator<Item = Real>) -> u32 {
    // SAFETY: the iterators of this crate do not use the list.
    let list = unsafe { REALS.get() };
    list.clear();
    list.extend(numbers);
    list.len() as u32
}

/// Replaces the integers that JavaScript reads after the call.
pub fn put_integers(numbers: impl IntoIterator<Item = u32>) -> u32 {
    // SAFETY: the iterators of this crate do not use the list.
    let list = unsafe { INTEGERS.get() };
    list.clear();
    list.extend(numbers);
    list.len() as u32
}

/// Replaces the bytes that JavaScript reads after the call.
pub fn put_bytes(bytes: Vec<u8>) -> u32 {
    // SAFETY: the reference ends with the function.
    let list = unsafe { BYTES.get() };
    *list = bytes;
    list.len() as u32
}

/// The list that JavaScript wrote.
pub fn list() -> Vec<f64> {
    // SAFETY: the reference ends with the statement.
    core::mem::take(unsafe { LIST.get() })
}

/// The real numbers that JavaScript wrote.
pub fn reals() -> Vec<Real> {
    // SAFETY: the reference ends with the statement.
    core::mem::take(unsafe { REALS.get() })
}

/// The integers that JavaScript wrote.
pub fn integers() -> Vec<u32> {
    // SAFETY: the reference ends with the statement.
    core::mem::take(unsafe { INTEGERS.get() })
}

/// The bytes that JavaScript wrote.
pub fn bytes() -> Vec<u8> {
    // SAFETY: the reference ends with the statement.
    core::mem::take(unsafe { BYTES.get() })
}

/// The real numbers that JavaScript wrote, as vectors.
pub fn vectors(name: &str) -> Result<Vec<Vector>, Fault> {
    let numbers = reals();
    let dimension = crate::rapier::math::DIM;
    if !numbers.len().is_multiple_of(dimension) {
        let text = format_args!(
            "{name} holds {} numbers, which is not a multiple of {dimension}",
            numbers.len()
        );
        return Err(Fault::invalid(text));
    }
    Ok(numbers.chunks_exact(dimension).map(Vector::from_slice).collect())
}

/// The integers that JavaScript wrote, in groups.
pub fn groups<const N: usize>(name: &str) -> Result<Vec<[u32; N]>, Fault> {
    let numbers = integers();
    if !numbers.len().is_multiple_of(N) {
        let text =
            format_args!("{name} holds {} numbers, which is not a multiple of {N}", numbers.len());
        return Err(Fault::invalid(text));
    }
    Ok(numbers.chunks_exact(N).map(|chunk| core::array::from_fn(|at| chunk[at])).collect())
}

// ---- Texts ----

/// Stores a text for JavaScript. Returns its address and length.
pub fn put_text(text: &str) -> (usize, usize) {
    // SAFETY: the reference ends with the function.
    let stored = unsafe { TEXT.get() };
    stored.clear();
    stored.extend_from_slice(text.as_bytes());
    (stored.as_ptr() as usize, stored.len())
}

/// Stores a warning of the engine. The first one of a call stays.
pub fn put_warning(text: String) {
    // SAFETY: the reference ends with the function.
    let stored = unsafe { WARNING.get() };
    if stored.is_empty() {
        *stored = text;
    }
}

/// Returns whether the engine logged a warning.
#[inline]
pub fn has_warning() -> bool {
    // SAFETY: the reference ends with the statement.
    unsafe { !WARNING.get().is_empty() }
}

/// Returns the warning and clears it.
pub fn take_warning() -> String {
    // SAFETY: the reference ends with the statement.
    core::mem::take(unsafe { WARNING.get() })
}

/// Reports a warning of a step to JavaScript: it is not the caller's error.
pub fn pass_warning_on() {
    if has_warning() {
        let (address, length) = put_text(&take_warning());
        crate::host::warn(address, length);
    }
}

exports! {
    /// The address of the scratch block.
    fn scratch_address() -> usize {
        SCRATCH.address()
    }

    /// The address of the list.
    fn list_address() -> usize {
        // SAFETY: the reference ends with the statement.
        unsafe { LIST.get().as_ptr() as usize }
    }

    /// The address of the real numbers.
    fn reals_address() -> usize {
        // SAFETY: the reference ends with the statement.
        unsafe { REALS.get().as_ptr() as usize }
    }

    /// The number of real numbers.
    fn reals_len() -> usize {
        // SAFETY: the reference ends with the statement.
        unsafe { REALS.get().len() }
    }

    /// The number of integers.
    fn integers_len() -> usize {
        // SAFETY: the reference ends with the statement.
        unsafe { INTEGERS.get().len() }
    }

    /// The address of the integers.
    fn integers_address() -> usize {
        // SAFETY: the reference ends with the statement.
        unsafe { INTEGERS.get().as_ptr() as usize }
    }

    /// The address of the bytes.
    fn bytes_address() -> usize {
        // SAFETY: the reference ends with the statement.
        unsafe { BYTES.get().as_ptr() as usize }
    }

    /// Makes room for a list that JavaScript writes next. Returns the address.
    fn list_reserve(count: usize) -> usize {
        // SAFETY: the reference ends with the block.
        let list = unsafe { LIST.get() };
        *list = vec![0.0; count];
        list.as_ptr() as usize
    }

    /// Makes room for real numbers that JavaScript writes next. Returns the address.
    fn reals_reserve(count: usize) -> usize {
        // SAFETY: the reference ends with the block.
        let reals = unsafe { REALS.get() };
        *reals = vec![0.0; count];
        reals.as_ptr() as usize
    }

    /// Makes room for integers that JavaScript writes next. Returns the address.
    fn integers_reserve(count: usize) -> usize {
        // SAFETY: the reference ends with the block.
        let integers = unsafe { INTEGERS.get() };
        *integers = vec![0; count];
        integers.as_ptr() as usize
    }

    /// Makes room for bytes that JavaScript writes next. Returns the address.
    fn bytes_reserve(count: usize) -> usize {
        // SAFETY: the reference ends with the block.
        let bytes = unsafe { BYTES.get() };
        *bytes = vec![0; count];
        bytes.as_ptr() as usize
    }

    /// Releases the memory of lists and input buffers.
    fn buffers_release() {
        put_bytes(Vec::new());
        reals();
        integers();
    }

    /// Grows the memory once, so that later allocations of this many bytes do not.
    fn memory_reserve(bytes: usize) {
        let mut reserved = Vec::<u8>::new();
        if reserved.try_reserve_exact(bytes).is_err() {
            return Err(Fault::number("extraBytesCount", bytes as f64, "small enough for the memory"));
        }
    }
}
