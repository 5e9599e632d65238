//! Maps as lists of their entries, for formats whose keys must be strings.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Writes the entries of a map in the order of its iterator.
pub fn serialize_to_vec_tuple<'a, S, T, K, V>(target: T, serializer: S) -> Result<S::Ok, S::Error>
where
    S: Serializer,
    T: IntoIterator<Item = (&'a K, &'a V)>,
    K: Serialize + 'a,
    V: Serialize + 'a,
{
    serializer.collect_seq(target)
}

/// Writes the entries of a map in the order of a property of their keys.
pub fn serialize_sorted_to_vec_tuple<'a, S, T, K, V, O>(
    target: T,
    key: impl Fn(&K) -> O,
    serializer: S,
) -> Result<S::Ok, S::Error>
where
    S: Serializer,
    T: IntoIterator<Item = (&'a K, &'a V)>,
    K: Serialize + 'a,
    V: Serialize + 'a,
    O: Ord,
{
    let mut entries: Vec<_> = target.into_iter().collect();
    entries.sort_by_key(|(name, _)| key(name));
    serializer.collect_seq(entries)
}

/// Reads the entries of a map.
pub fn deserialize_from_vec_tuple<'de, D, T, K, V>(deserializer: D) -> Result<T, D::Error>
where
    D: Deserializer<'de>,
    T: FromIterator<(K, V)>,
    K: Deserialize<'de>,
    V: Deserialize<'de>,
{
    let entries: Vec<(K, V)> = Deserialize::deserialize(deserializer)?;
    Ok(entries.into_iter().collect())
}
