//! Wrappers around types of the engine.

/// Defines a transparent wrapper of an engine type. It dereferences to that type.
macro_rules! wrapper {
    ($(#[$meta:meta])* $name:ident, $engine:ty) => {
        $(#[$meta])*
        #[derive(Clone, Debug, Default)]
        #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "serde-serialize", serde(transparent))]
        #[repr(transparent)]
        pub struct $name(pub(crate) $engine);

        impl $name {
            /// An empty value.
            pub fn new() -> Self {
                Self::default()
            }
        }

        $crate::wrapper::forward!($name, $engine);
    };
}

/// Dereferences a wrapper to the engine type in its field.
macro_rules! forward {
    ($name:ident, $engine:ty) => {
        $crate::wrapper::forward!($name, 0, $engine);
    };
    ($name:ident, $field:tt, $engine:ty) => {
        impl core::ops::Deref for $name {
            type Target = $engine;

            fn deref(&self) -> &$engine {
                &self.$field
            }
        }

        impl core::ops::DerefMut for $name {
            fn deref_mut(&mut self) -> &mut $engine {
                &mut self.$field
            }
        }
    };
}

pub(crate) use {forward, wrapper};
