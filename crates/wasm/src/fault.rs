//! Errors on their way to JavaScript.

use crate::host;
use crate::memory;
use core::fmt::Display;

/// The kinds of errors. `javascript/src/error.ts` lists the same numbers.
#[derive(Copy, Clone)]
pub enum Kind {
    /// The handle finds nothing: the object was removed, or belongs to another world.
    StaleHandle = 1,
    /// A value cannot be used.
    InvalidValue = 2,
    /// The world, queue or controller was freed.
    Freed = 3,
    /// The world cannot be changed now, because a step or a query is running.
    Busy = 4,
    /// The collider has another shape.
    WrongShape = 5,
    /// A snapshot cannot be read.
    InvalidSnapshot = 6,
    /// A defect of the engine.
    Internal = 7,
}

/// Reason why a function did nothing.
pub struct Fault {
    kind: Kind,
    text: String,
}

impl Fault {
    /// An error with a text that names the value.
    #[cold]
    pub fn new(kind: Kind, text: String) -> Self {
        Self { kind, text }
    }

    /// A value that cannot be used.
    #[cold]
    pub fn invalid(text: impl Display) -> Self {
        Self::new(Kind::InvalidValue, text.to_string())
    }

    /// A number that cannot be used, with the rule that it breaks.
    #[cold]
    pub fn number(name: &str, value: f64, expected: &str) -> Self {
        Self::new(Kind::InvalidValue, format!("{name} is {value}, but must be {expected}"))
    }

    /// A handle that finds nothing.
    #[cold]
    pub fn stale(what: &str, handle: f64) -> Self {
        let bits = handle.to_bits();
        let (slot, generation) = (bits as u32, (bits >> 32) as u32);
        let text = format!(
            "the {what} {slot} of generation {generation} is not in this world: it was removed, or belongs to another world"
        );
        Self::new(Kind::StaleHandle, text)
    }

    /// A registered object that no longer exists.
    #[cold]
    pub fn freed(what: &str) -> Self {
        Self::new(Kind::Freed, format!("the {what} was freed"))
    }

    /// Throws the error in JavaScript. The frames of this module end without destructors, so nothing that
    /// owns memory may be alive but the text itself.
    #[cold]
    fn throw(self) -> ! {
        let Self { kind, text } = self;
        let (address, length) = memory::put_text(&text);
        drop(text);
        host::fail(kind as u32, address, length)
    }
}

/// Returns the result of an exported function, or throws. A warning that the engine logged meanwhile is an
/// error too: it names a value that was refused.
#[inline]
pub fn finish<T>(result: Result<T, Fault>) -> T {
    match result {
        Ok(value) if !memory::has_warning() => value,
        Ok(_) => Fault::new(Kind::InvalidValue, memory::take_warning()).throw(),
        Err(fault) => {
            memory::take_warning();
            fault.throw()
        }
    }
}

/// The number, if it is finite.
#[inline]
pub fn finite<N: Into<f64> + Copy>(name: &str, value: N) -> Result<N, Fault> {
    match value.into().is_finite() {
        true => Ok(value),
        false => Err(Fault::number(name, value.into(), "finite")),
    }
}

/// The number, if it is finite and not negative.
#[inline]
pub fn non_negative<N: Into<f64> + Copy>(name: &str, value: N) -> Result<N, Fault> {
    match value.into() {
        number if number.is_finite() && number >= 0.0 => Ok(value),
        number => Err(Fault::number(name, number, "finite and not negative")),
    }
}
