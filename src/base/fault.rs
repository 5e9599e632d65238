//! Inconsistencies in data: found in debug builds after each stage, and in data that was loaded.

use core::fmt;

/// The inconsistency, in words, with the values.
#[derive(Debug)]
pub struct Fault(Box<str>);

impl Fault {
    /// A fault with this description.
    #[cold]
    pub fn new(what: fmt::Arguments<'_>) -> Self {
        Self(what.to_string().into())
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Returns a [`Fault`] from the function unless a condition holds.
macro_rules! ensure {
    ($condition:expr, $($what:tt)+) => {
        // A comparison with NaN is false.
        match $condition {
            true => {}
            false => return Err($crate::base::fault::Fault::new(format_args!($($what)+))),
        }
    };
}
pub(crate) use ensure;
