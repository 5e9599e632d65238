//! Data that is checked when it is loaded.
//!
//! Saved data may be damaged, or made up. A container whose parts refer to each other implements [`Loaded`],
//! and its `Deserialize` returns an error if a reference is wrong. So any value of the type can be used
//! without further checks.

use super::fault::Fault;

/// Data with an invariant that saved bytes may violate.
pub trait Loaded {
    /// Checks the invariant.
    ///
    /// # Errors
    /// If it does not hold.
    fn check_loaded(&self) -> Result<(), Fault>;

    /// Computes derived data that is not saved. Called after the check.
    #[cfg(feature = "serde-serialize")]
    fn complete_loaded(&mut self) {}
}

/// Implements serde's traits for a type that derives them with `#[serde(remote = "Self")]` and is [`Loaded`].
macro_rules! check_when_loaded {
    ($type:ty $(, $parameter:ident: $($bound:tt)+)?) => {
        #[cfg(feature = "serde-serialize")]
        impl$(<$parameter: $($bound)+ + serde::Serialize>)? serde::Serialize for $type {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                // The associated function that the attribute `remote` derives.
                Self::serialize(self, serializer)
            }
        }

        #[cfg(feature = "serde-serialize")]
        impl<'de $(, $parameter: $($bound)+ + serde::Deserialize<'de>)?> serde::Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let mut loaded = Self::deserialize(deserializer)?;
                $crate::base::loading::Loaded::check_loaded(&loaded)
                    .map_err(<D::Error as serde::de::Error>::custom)?;
                $crate::base::loading::Loaded::complete_loaded(&mut loaded);
                Ok(loaded)
            }
        }
    };
}
pub(crate) use check_when_loaded;
