//! Bytes to values. The bytes may be damaged or forged.
//!
//! A length is accepted only if the input has as many bytes: an element takes at least one. A list therefore
//! allocates at most as many elements as the input has bytes.

use super::CodecError;
use serde::de::value::U32Deserializer;
use serde::de::{
    self, DeserializeOwned, DeserializeSeed, EnumAccess, Error as _, IntoDeserializer, MapAccess,
    SeqAccess, VariantAccess, Visitor,
};

/// Reads a value from the front of `bytes`, and returns it with the rest.
///
/// # Errors
/// If the bytes end too early, or do not describe a valid value; with the position of the byte.
pub fn read<T: DeserializeOwned>(bytes: &[u8]) -> Result<(T, &[u8]), CodecError> {
    let mut reader = Reader { rest: bytes };
    let value = T::deserialize(&mut reader).map_err(|error| {
        let at = bytes.len() - reader.rest.len();
        CodecError::custom(format_args!("{error} (at byte {at})"))
    })?;
    Ok((value, reader.rest))
}

struct Reader<'a> {
    rest: &'a [u8],
}

impl Reader<'_> {
    fn take<const N: usize>(&mut self) -> Result<[u8; N], CodecError> {
        let (taken, rest) =
            self.rest.split_first_chunk().ok_or_else(|| CodecError::custom("the data ends"))?;
        self.rest = rest;
        Ok(*taken)
    }

    fn byte(&mut self) -> Result<u8, CodecError> {
        Ok(u8::from_le_bytes(self.take()?))
    }

    /// An integer of variable length that has one byte, as most have.
    fn single_byte(&mut self) -> Option<u8> {
        let (&byte, rest) = self.rest.split_first().filter(|(byte, _)| **byte < 0x80)?;
        self.rest = rest;
        Some(byte)
    }

    fn varint64(&mut self) -> Result<u64, CodecError> {
        if let Some(byte) = self.single_byte() {
            return Ok(u64::from(byte));
        }
        let mut value = 0;
        for shift in (0..u64::BITS).step_by(7) {
            let byte = self.byte()?;
            let bits = u64::from(byte & 0x7f);
            if bits << shift >> shift != bits {
                break;
            }
            value |= bits << shift;
            if byte < 0x80 {
                return Ok(value);
            }
        }
        Err(CodecError::custom("an integer has more than 64 bits"))
    }

    fn varint128(&mut self) -> Result<u128, CodecError> {
        if let Some(byte) = self.single_byte() {
            return Ok(u128::from(byte));
        }
        let mut value = 0;
        for shift in (0..u128::BITS).step_by(7) {
            let byte = self.byte()?;
            let bits = u128::from(byte & 0x7f);
            if bits << shift >> shift != bits {
                break;
            }
            value |= bits << shift;
            if byte < 0x80 {
                return Ok(value);
            }
        }
        Err(CodecError::custom("an integer has more than 128 bits"))
    }

    fn integer<T: TryFrom<u64>>(&mut self) -> Result<T, CodecError> {
        let value = self.varint64()?;
        T::try_from(value).map_err(|_| CodecError::custom(format_args!("{value} is too large")))
    }

    fn signed<T: TryFrom<i64>>(&mut self) -> Result<T, CodecError> {
        let value = self.varint64()?;
        let value = (value >> 1) as i64 ^ -((value & 1) as i64);
        T::try_from(value).map_err(|_| CodecError::custom(format_args!("{value} is out of range")))
    }

    /// The number of elements of a list.
    fn length(&mut self) -> Result<usize, CodecError> {
        let (length, bytes) = (self.varint64()?, self.rest.len());
        match usize::try_from(length) {
            Ok(length) if length <= bytes => Ok(length),
            _ => Err(CodecError::custom(format_args!("{length} elements in {bytes} bytes"))),
        }
    }

    fn text(&mut self) -> Result<&[u8], CodecError> {
        let length = self.length()?;
        let (taken, rest) = self.rest.split_at(length);
        self.rest = rest;
        Ok(taken)
    }
}

/// Methods that read a value and hand it to the visitor.
macro_rules! numbers {
    ($($method:ident => $visit:ident $read:expr;)*) => {
        $(fn $method<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, CodecError> {
            let read: fn(&mut Reader<'de>) -> Result<_, CodecError> = $read;
            visitor.$visit(read(self)?)
        })*
    };
}

impl<'de> de::Deserializer<'de> for &mut Reader<'de> {
    type Error = CodecError;

    fn is_human_readable(&self) -> bool {
        false
    }

    numbers! {
        deserialize_bool => visit_bool |it| match it.byte()? {
            byte @ 0..=1 => Ok(byte == 1),
            byte => Err(CodecError::custom(format_args!("{byte} is neither true nor false"))),
        };
        deserialize_u8 => visit_u8 |it| it.byte();
        deserialize_i8 => visit_i8 |it| Ok(i8::from_le_bytes(it.take()?));
        deserialize_u16 => visit_u16 |it| it.integer();
        deserialize_u32 => visit_u32 |it| it.integer();
        deserialize_u64 => visit_u64 |it| it.varint64();
        deserialize_u128 => visit_u128 |it| it.varint128();
        deserialize_i16 => visit_i16 |it| it.signed();
        deserialize_i32 => visit_i32 |it| it.signed();
        deserialize_i64 => visit_i64 |it| it.signed();
        deserialize_i128 => visit_i128 |it| {
            it.varint128().map(|value| (value >> 1) as i128 ^ -((value & 1) as i128))
        };
        deserialize_f32 => visit_f32 |it| Ok(f32::from_le_bytes(it.take()?));
        deserialize_f64 => visit_f64 |it| Ok(f64::from_le_bytes(it.take()?));
        deserialize_char => visit_char |it| {
            let code = it.integer()?;
            char::from_u32(code).ok_or_else(|| CodecError::custom(format_args!("{code} is no character")))
        };
        deserialize_byte_buf => visit_byte_buf |it| Ok(it.text()?.to_vec());
    }

    fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, CodecError> {
        Err(CodecError::custom("the format does not describe its types"))
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, CodecError> {
        self.deserialize_any(visitor)
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, CodecError> {
        let text = self.text()?;
        visitor.visit_str(core::str::from_utf8(text).map_err(CodecError::custom)?)
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, CodecError> {
        self.deserialize_str(visitor)
    }

    fn deserialize_identifier<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, CodecError> {
        self.deserialize_str(visitor)
    }

    fn deserialize_bytes<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, CodecError> {
        visitor.visit_bytes(self.text()?)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, CodecError> {
        match self.byte()? {
            0 => visitor.visit_none(),
            1 => visitor.visit_some(self),
            byte => Err(CodecError::custom(format_args!("{byte} marks neither a value nor none"))),
        }
    }

    fn deserialize_unit<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, CodecError> {
        visitor.visit_unit()
    }

    fn deserialize_unit_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, CodecError> {
        visitor.visit_unit()
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, CodecError> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, CodecError> {
        let left = self.length()?;
        visitor.visit_seq(Elements { reader: self, left })
    }

    fn deserialize_tuple<V: Visitor<'de>>(
        self,
        left: usize,
        visitor: V,
    ) -> Result<V::Value, CodecError> {
        visitor.visit_seq(Elements { reader: self, left })
    }

    fn deserialize_tuple_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        left: usize,
        visitor: V,
    ) -> Result<V::Value, CodecError> {
        self.deserialize_tuple(left, visitor)
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, CodecError> {
        let left = self.length()?;
        visitor.visit_map(Elements { reader: self, left })
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, CodecError> {
        self.deserialize_tuple(fields.len(), visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, CodecError> {
        visitor.visit_enum(self)
    }
}

/// The elements of a list that are left to read.
struct Elements<'r, 'de> {
    reader: &'r mut Reader<'de>,
    left: usize,
}

impl Elements<'_, '_> {
    /// Returns whether there is another element, and counts it.
    fn count_next(&mut self) -> bool {
        let left = self.left.checked_sub(1);
        self.left = left.unwrap_or(0);
        left.is_some()
    }
}

impl<'de> SeqAccess<'de> for Elements<'_, 'de> {
    type Error = CodecError;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, CodecError> {
        self.count_next().then(|| seed.deserialize(&mut *self.reader)).transpose()
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.left)
    }
}

impl<'de> MapAccess<'de> for Elements<'_, 'de> {
    type Error = CodecError;

    fn next_key_seed<K: DeserializeSeed<'de>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, CodecError> {
        self.count_next().then(|| seed.deserialize(&mut *self.reader)).transpose()
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(
        &mut self,
        seed: V,
    ) -> Result<V::Value, CodecError> {
        seed.deserialize(&mut *self.reader)
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.left)
    }
}

impl<'de> EnumAccess<'de> for &mut Reader<'de> {
    type Error = CodecError;
    type Variant = Self;

    fn variant_seed<V: DeserializeSeed<'de>>(
        self,
        seed: V,
    ) -> Result<(V::Value, Self), CodecError> {
        let variant: u32 = self.integer()?;
        let variant: U32Deserializer<CodecError> = variant.into_deserializer();
        Ok((seed.deserialize(variant)?, self))
    }
}

impl<'de> VariantAccess<'de> for &mut Reader<'de> {
    type Error = CodecError;

    fn unit_variant(self) -> Result<(), CodecError> {
        Ok(())
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(
        self,
        seed: T,
    ) -> Result<T::Value, CodecError> {
        seed.deserialize(self)
    }

    fn tuple_variant<V: Visitor<'de>>(
        self,
        left: usize,
        visitor: V,
    ) -> Result<V::Value, CodecError> {
        visitor.visit_seq(Elements { reader: self, left })
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, CodecError> {
        self.tuple_variant(fields.len(), visitor)
    }
}
