//! The binary format of saved values: serde's data model in bytes, without names.
//!
//! * Integers of more than one byte are variable-length: seven bits per byte, the lowest first; the highest
//!   bit marks that another byte follows. Signed integers alternate (0, -1, 1, -2, …), so small ones are
//!   short.
//! * Floating-point numbers are their bits, lowest byte first.
//! * Lists, maps, texts and byte strings begin with their length; options with 0 or 1; enums with the number
//!   of the variant.
//! * Structs and tuples are their fields in order.
//!
//! Rejected formats: postcard is as compact but discards the message of an error, so a damaged world could
//! not be described. MessagePack adds a byte to every number, and bincode is no longer maintained.

mod read;
mod write;

pub use read::read;
pub use write::write;

use core::fmt;

/// Error of saving or loading a value.
#[derive(Debug)]
pub struct CodecError(pub String);

impl fmt::Display for CodecError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl core::error::Error for CodecError {}

impl serde::ser::Error for CodecError {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self(message.to_string())
    }
}

impl serde::de::Error for CodecError {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self(message.to_string())
    }
}

#[cfg(test)]
mod tests;
