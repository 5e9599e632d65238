//! Values to bytes.

use super::CodecError;
use serde::Serialize;
use serde::ser::{self, Error as _};

/// Appends a value to `bytes`.
///
/// # Errors
/// If the value refuses to be saved.
pub fn write(value: &impl Serialize, bytes: &mut Vec<u8>) -> Result<(), CodecError> {
    value.serialize(&mut Writer { bytes })
}

struct Writer<'a> {
    bytes: &'a mut Vec<u8>,
}

type Written = Result<(), CodecError>;

impl Writer<'_> {
    fn varint(&mut self, mut value: u128) -> Written {
        while value >= 0x80 {
            self.bytes.push(value as u8 | 0x80);
            value >>= 7;
        }
        self.bytes.push(value as u8);
        Ok(())
    }

    /// The common case of [`Self::varint`]: 128-bit shifts take twice the time.
    fn varint64(&mut self, mut value: u64) -> Written {
        while value >= 0x80 {
            self.bytes.push(value as u8 | 0x80);
            value >>= 7;
        }
        self.bytes.push(value as u8);
        Ok(())
    }

    fn length(&mut self, length: Option<usize>) -> Written {
        let length = length.ok_or_else(|| CodecError::custom("a list of unknown length"))?;
        self.varint64(length as u64)
    }

    fn all(&mut self, bytes: &[u8]) -> Written {
        self.bytes.extend_from_slice(bytes);
        Ok(())
    }
}

/// Maps signed integers to unsigned ones so that small magnitudes stay small.
fn alternate(value: i64) -> u64 {
    (value << 1 ^ value >> 63) as u64
}

impl<'a> ser::Serializer for &mut Writer<'a> {
    type Ok = ();
    type Error = CodecError;
    type SerializeSeq = Self;
    type SerializeTuple = Self;
    type SerializeTupleStruct = Self;
    type SerializeTupleVariant = Self;
    type SerializeMap = Self;
    type SerializeStruct = Self;
    type SerializeStructVariant = Self;

    fn is_human_readable(&self) -> bool {
        false
    }

    fn serialize_bool(self, value: bool) -> Written {
        self.all(&[u8::from(value)])
    }

    fn serialize_u8(self, value: u8) -> Written {
        self.all(&[value])
    }

    fn serialize_i8(self, value: i8) -> Written {
        self.all(&value.to_le_bytes())
    }

    fn serialize_u16(self, value: u16) -> Written {
        self.varint64(u64::from(value))
    }

    fn serialize_u32(self, value: u32) -> Written {
        self.varint64(u64::from(value))
    }

    fn serialize_u64(self, value: u64) -> Written {
        self.varint64(value)
    }

    fn serialize_u128(self, value: u128) -> Written {
        self.varint(value)
    }

    fn serialize_i16(self, value: i16) -> Written {
        self.varint64(alternate(i64::from(value)))
    }

    fn serialize_i32(self, value: i32) -> Written {
        self.varint64(alternate(i64::from(value)))
    }

    fn serialize_i64(self, value: i64) -> Written {
        self.varint64(alternate(value))
    }

    fn serialize_i128(self, value: i128) -> Written {
        self.varint((value << 1 ^ value >> 127) as u128)
    }

    fn serialize_f32(self, value: f32) -> Written {
        self.all(&value.to_le_bytes())
    }

    fn serialize_f64(self, value: f64) -> Written {
        self.all(&value.to_le_bytes())
    }

    fn serialize_char(self, value: char) -> Written {
        self.varint64(u64::from(u32::from(value)))
    }

    fn serialize_str(self, value: &str) -> Written {
        self.serialize_bytes(value.as_bytes())
    }

    fn serialize_bytes(self, value: &[u8]) -> Written {
        self.length(Some(value.len()))?;
        self.all(value)
    }

    fn serialize_none(self) -> Written {
        self.all(&[0])
    }

    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Written {
        self.all(&[1])?;
        value.serialize(self)
    }

    fn serialize_unit(self) -> Written {
        Ok(())
    }

    fn serialize_unit_struct(self, _: &'static str) -> Written {
        Ok(())
    }

    fn serialize_unit_variant(self, _: &'static str, variant: u32, _: &'static str) -> Written {
        self.varint64(u64::from(variant))
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        value: &T,
    ) -> Written {
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        variant: u32,
        _: &'static str,
        value: &T,
    ) -> Written {
        self.varint64(u64::from(variant))?;
        value.serialize(self)
    }

    fn serialize_seq(self, length: Option<usize>) -> Result<Self, CodecError> {
        self.length(length)?;
        Ok(self)
    }

    fn serialize_tuple(self, _: usize) -> Result<Self, CodecError> {
        Ok(self)
    }

    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<Self, CodecError> {
        Ok(self)
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        variant: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Self, CodecError> {
        self.varint64(u64::from(variant))?;
        Ok(self)
    }

    fn serialize_map(self, length: Option<usize>) -> Result<Self, CodecError> {
        self.length(length)?;
        Ok(self)
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Self, CodecError> {
        Ok(self)
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        variant: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Self, CodecError> {
        self.varint64(u64::from(variant))?;
        Ok(self)
    }
}

/// Implements one of serde's traits for lists of values without names.
macro_rules! elements {
    ($($trait:ident $method:ident;)*) => {
        $(impl ser::$trait for &mut Writer<'_> {
            type Ok = ();
            type Error = CodecError;

            fn $method<T: Serialize + ?Sized>(&mut self, value: &T) -> Written {
                value.serialize(&mut **self)
            }

            fn end(self) -> Written {
                Ok(())
            }
        })*
    };
}

elements! {
    SerializeSeq serialize_element;
    SerializeTuple serialize_element;
    SerializeTupleStruct serialize_field;
    SerializeTupleVariant serialize_field;
}

/// The same for values with names, which are not written.
macro_rules! fields {
    ($($trait:ident)*) => {
        $(impl ser::$trait for &mut Writer<'_> {
            type Ok = ();
            type Error = CodecError;

            fn serialize_field<T: Serialize + ?Sized>(
                &mut self,
                _: &'static str,
                value: &T,
            ) -> Written {
                value.serialize(&mut **self)
            }

            fn end(self) -> Written {
                Ok(())
            }
        })*
    };
}

fields!(SerializeStruct SerializeStructVariant);

impl ser::SerializeMap for &mut Writer<'_> {
    type Ok = ();
    type Error = CodecError;

    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Written {
        key.serialize(&mut **self)
    }

    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Written {
        value.serialize(&mut **self)
    }

    fn end(self) -> Written {
        Ok(())
    }
}
