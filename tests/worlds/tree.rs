//! Saved data as a tree of values, with access to each value.
//!
//! The format is specific to the tests, because common formats either lack NaN and infinity (JSON) or
//! structure (bytes).

use serde::de::value::{MapDeserializer, SeqDeserializer, StrDeserializer};
use serde::de::{DeserializeOwned, EnumAccess, IntoDeserializer, VariantAccess, Visitor};
use serde::{Deserializer, Serialize, ser};
use std::fmt;

/// A value, or a tree of values.
#[derive(Clone, Debug, PartialEq)]
pub enum Tree {
    Unit,
    Bool(bool),
    Unsigned(u128),
    Signed(i128),
    Float(f64),
    Text(String),
    Some(Box<Tree>),
    List(Vec<Tree>),
    Map(Vec<(Tree, Tree)>),
    /// Variant of an enum with its content.
    Variant(&'static str, Box<Tree>),
}

/// Reason why a value cannot be saved or loaded.
#[derive(Debug)]
pub struct Refusal(pub String);

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Refusal {}

impl ser::Error for Refusal {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self(message.to_string())
    }
}

impl serde::de::Error for Refusal {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self(message.to_string())
    }
}

/// Saves a value.
pub fn save(value: &impl Serialize) -> Tree {
    value.serialize(Saver).expect("all types of the engine can be saved")
}

/// Loads a value.
pub fn load<T: DeserializeOwned>(tree: &Tree) -> Result<T, Refusal> {
    T::deserialize(Loader(tree))
}

struct Saver;

/// A list, map or struct in the process of saving.
struct Parts {
    variant: Option<&'static str>,
    keys: Vec<Tree>,
    values: Vec<Tree>,
}

impl Parts {
    fn new(variant: Option<&'static str>) -> Self {
        Self { variant, keys: Vec::new(), values: Vec::new() }
    }

    fn finish(self, is_map: bool) -> Tree {
        let tree = match is_map {
            true => Tree::Map(self.keys.into_iter().zip(self.values).collect()),
            false => Tree::List(self.values),
        };
        match self.variant {
            Some(name) => Tree::Variant(name, Box::new(tree)),
            None => tree,
        }
    }
}

macro_rules! numbers {
    ($($method:ident $type:ty => $variant:ident as $wide:ty;)*) => {
        $(fn $method(self, value: $type) -> Result<Tree, Refusal> {
            Ok(Tree::$variant(<$wide>::from(value)))
        })*
    };
}

impl ser::Serializer for Saver {
    type Ok = Tree;
    type Error = Refusal;
    type SerializeSeq = Parts;
    type SerializeTuple = Parts;
    type SerializeTupleStruct = Parts;
    type SerializeTupleVariant = Parts;
    type SerializeMap = Parts;
    type SerializeStruct = Parts;
    type SerializeStructVariant = Parts;

    numbers! {
        serialize_bool bool => Bool as bool;
        serialize_u8 u8 => Unsigned as u128;
        serialize_u16 u16 => Unsigned as u128;
        serialize_u32 u32 => Unsigned as u128;
        serialize_u64 u64 => Unsigned as u128;
        serialize_u128 u128 => Unsigned as u128;
        serialize_i8 i8 => Signed as i128;
        serialize_i16 i16 => Signed as i128;
        serialize_i32 i32 => Signed as i128;
        serialize_i64 i64 => Signed as i128;
        serialize_i128 i128 => Signed as i128;
        serialize_f32 f32 => Float as f64;
        serialize_f64 f64 => Float as f64;
        serialize_char char => Text as String;
        serialize_str &str => Text as String;
    }

    fn serialize_bytes(self, bytes: &[u8]) -> Result<Tree, Refusal> {
        Ok(Tree::List(bytes.iter().map(|byte| Tree::Unsigned(u128::from(*byte))).collect()))
    }

    fn serialize_none(self) -> Result<Tree, Refusal> {
        Ok(Tree::Unit)
    }

    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Result<Tree, Refusal> {
        Ok(Tree::Some(Box::new(value.serialize(Saver)?)))
    }

    fn serialize_unit(self) -> Result<Tree, Refusal> {
        Ok(Tree::Unit)
    }

    fn serialize_unit_struct(self, _: &'static str) -> Result<Tree, Refusal> {
        Ok(Tree::Unit)
    }

    fn serialize_unit_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
    ) -> Result<Tree, Refusal> {
        Ok(Tree::Text(variant.to_string()))
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        value: &T,
    ) -> Result<Tree, Refusal> {
        value.serialize(Saver)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        value: &T,
    ) -> Result<Tree, Refusal> {
        Ok(Tree::Variant(variant, Box::new(value.serialize(Saver)?)))
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Parts, Refusal> {
        Ok(Parts::new(None))
    }

    fn serialize_tuple(self, _: usize) -> Result<Parts, Refusal> {
        Ok(Parts::new(None))
    }

    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<Parts, Refusal> {
        Ok(Parts::new(None))
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        _: usize,
    ) -> Result<Parts, Refusal> {
        Ok(Parts::new(Some(variant)))
    }

    fn serialize_map(self, _: Option<usize>) -> Result<Parts, Refusal> {
        Ok(Parts::new(None))
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Parts, Refusal> {
        Ok(Parts::new(None))
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        _: usize,
    ) -> Result<Parts, Refusal> {
        Ok(Parts::new(Some(variant)))
    }

    fn is_human_readable(&self) -> bool {
        false
    }
}

macro_rules! lists {
    ($($kind:ident $method:ident;)*) => {
        $(impl ser::$kind for Parts {
            type Ok = Tree;
            type Error = Refusal;

            fn $method<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Refusal> {
                self.values.push(value.serialize(Saver)?);
                Ok(())
            }

            fn end(self) -> Result<Tree, Refusal> {
                Ok(self.finish(false))
            }
        })*
    };
}

lists! {
    SerializeSeq serialize_element;
    SerializeTuple serialize_element;
    SerializeTupleStruct serialize_field;
    SerializeTupleVariant serialize_field;
}

macro_rules! structs {
    ($($kind:ident)*) => {
        $(impl ser::$kind for Parts {
            type Ok = Tree;
            type Error = Refusal;

            fn serialize_field<T: Serialize + ?Sized>(
                &mut self,
                key: &'static str,
                value: &T,
            ) -> Result<(), Refusal> {
                self.keys.push(Tree::Text(key.to_string()));
                self.values.push(value.serialize(Saver)?);
                Ok(())
            }

            fn end(self) -> Result<Tree, Refusal> {
                Ok(self.finish(true))
            }
        })*
    };
}

structs! { SerializeStruct SerializeStructVariant }

impl ser::SerializeMap for Parts {
    type Ok = Tree;
    type Error = Refusal;

    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Result<(), Refusal> {
        self.keys.push(key.serialize(Saver)?);
        Ok(())
    }

    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Refusal> {
        self.values.push(value.serialize(Saver)?);
        Ok(())
    }

    fn end(self) -> Result<Tree, Refusal> {
        Ok(self.finish(true))
    }
}

#[derive(Copy, Clone)]
struct Loader<'a>(&'a Tree);

impl<'de> IntoDeserializer<'de, Refusal> for Loader<'de> {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

impl<'de> Deserializer<'de> for Loader<'de> {
    type Error = Refusal;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refusal> {
        match self.0 {
            Tree::Unit => visitor.visit_unit(),
            Tree::Bool(value) => visitor.visit_bool(*value),
            Tree::Unsigned(value) => match u64::try_from(*value) {
                Ok(value) => visitor.visit_u64(value),
                Err(_) => visitor.visit_u128(*value),
            },
            Tree::Signed(value) => match i64::try_from(*value) {
                Ok(value) => visitor.visit_i64(value),
                Err(_) => visitor.visit_i128(*value),
            },
            Tree::Float(value) => visitor.visit_f64(*value),
            Tree::Text(text) => visitor.visit_str(text),
            Tree::Some(value) => visitor.visit_some(Loader(value)),
            Tree::List(values) => {
                visitor.visit_seq(SeqDeserializer::new(values.iter().map(Loader)))
            }
            Tree::Map(entries) => {
                let entries = entries.iter().map(|(key, value)| (Loader(key), Loader(value)));
                visitor.visit_map(MapDeserializer::new(entries))
            }
            Tree::Variant(..) => visitor.visit_enum(self),
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refusal> {
        match self.0 {
            Tree::Unit => visitor.visit_none(),
            Tree::Some(value) => visitor.visit_some(Loader(value)),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Refusal> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Refusal> {
        visitor.visit_enum(self)
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit
        unit_struct seq tuple tuple_struct map struct identifier ignored_any
    }

    fn is_human_readable(&self) -> bool {
        false
    }
}

impl<'de> EnumAccess<'de> for Loader<'de> {
    type Error = Refusal;
    type Variant = Self;

    fn variant_seed<S: serde::de::DeserializeSeed<'de>>(
        self,
        seed: S,
    ) -> Result<(S::Value, Self), Refusal> {
        let (name, inner): (&str, _) = match self.0 {
            Tree::Text(name) => (name, &Tree::Unit),
            Tree::Variant(name, inner) => (name, &**inner),
            other => return Err(Refusal(format!("{other:?} is no variant"))),
        };
        let name: StrDeserializer<'_, Refusal> = name.into_deserializer();
        Ok((seed.deserialize(name)?, Loader(inner)))
    }
}

impl<'de> VariantAccess<'de> for Loader<'de> {
    type Error = Refusal;

    fn unit_variant(self) -> Result<(), Refusal> {
        match self.0 {
            Tree::Unit => Ok(()),
            other => Err(Refusal(format!("{other:?} is in an empty variant"))),
        }
    }

    fn newtype_variant_seed<S: serde::de::DeserializeSeed<'de>>(
        self,
        seed: S,
    ) -> Result<S::Value, Refusal> {
        seed.deserialize(self)
    }

    fn tuple_variant<V: Visitor<'de>>(self, _: usize, visitor: V) -> Result<V::Value, Refusal> {
        self.deserialize_any(visitor)
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Refusal> {
        self.deserialize_any(visitor)
    }
}
