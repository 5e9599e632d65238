//! Values survive, and bytes that describe none are refused.

use super::{read, write};
use core::fmt::Debug;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
enum Kind {
    Unit,
    Newtype(i64),
    Tuple(u8, Option<char>),
    Struct { text: String, flags: Vec<bool> },
}

fn bytes_of(value: &impl Serialize) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(value, &mut bytes).expect("the value has no part that refuses");
    bytes
}

/// Writes and reads a value; every shorter input is refused.
fn check<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: &T) -> usize {
    let mut bytes = bytes_of(value);
    for length in 0..bytes.len() {
        assert!(read::<T>(&bytes[..length]).is_err(), "{length} bytes of {value:?}");
    }
    let length = bytes.len();
    bytes.extend([1, 2, 3]);
    let (loaded, rest) = read::<T>(&bytes).expect("it was written");
    assert_eq!((&loaded, rest), (value, &[1, 2, 3][..]));
    length
}

#[test]
fn values_survive() {
    check(&vec![Kind::Unit, Kind::Newtype(-7), Kind::Tuple(200, Some('ß'))]);
    check(&Kind::Struct { text: "slot".into(), flags: vec![true, false] });
    check(&BTreeMap::from([(1_u32, vec![0.5_f32, f32::INFINITY]), (7, vec![])]));
    check(&(u8::MAX, u16::MAX, u32::MAX, u64::MAX, u128::MAX, f64::MIN_POSITIVE));
    check(&(i8::MIN, i16::MIN, i32::MIN, i64::MIN, i128::MIN, -0.0_f32));
    check(&(i8::MAX, i16::MAX, i32::MAX, i64::MAX, i128::MAX, usize::MAX));
}

#[test]
fn small_integers_take_one_byte() {
    assert_eq!(check(&[0_u64, 1, 127]), 3);
    assert_eq!(check(&[0_i64, -1, 63, -64]), 4);
    assert_eq!(check(&[128_u64]), 2);
}

#[test]
fn lengths_beyond_the_bytes_are_refused() {
    let mut bytes = bytes_of(&u64::MAX);
    bytes.extend([0; 20]);
    let refused = read::<Vec<u8>>(&bytes).expect_err("there are 20 bytes").to_string();
    assert!(refused.contains("18446744073709551615 elements in 20 bytes"), "{refused}");
    assert!(read::<String>(&bytes).is_err());
    assert!(read::<BTreeMap<u8, u8>>(&bytes).is_err());
}

#[test]
fn values_out_of_range_are_refused() {
    fn refused<T: DeserializeOwned + Debug>(bytes: &[u8]) -> String {
        read::<T>(bytes).expect_err("out of range").0
    }
    let long = [0xff; 30];
    assert_eq!(refused::<u64>(&long), "an integer has more than 64 bits (at byte 10)");
    assert_eq!(refused::<u128>(&long), "an integer has more than 128 bits (at byte 19)");
    assert_eq!(refused::<bool>(&long), "255 is neither true nor false (at byte 1)");
    assert_eq!(refused::<Option<u8>>(&long), "255 marks neither a value nor none (at byte 1)");
    assert_eq!(refused::<u16>(&bytes_of(&70_000_u32)), "70000 is too large (at byte 3)");
    assert_eq!(refused::<i8>(&[]), "the data ends (at byte 0)");
    refused::<char>(&bytes_of(&0xd800_u32));
    // There are four variants.
    refused::<Kind>(&[4]);
}
