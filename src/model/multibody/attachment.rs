//! A value that a facade keeps with a multibody.

#[cfg(feature = "upstream-signatures")]
use super::Multibody;

/// Nothing: the engine's own crates keep no such value.
#[cfg(not(feature = "upstream-signatures"))]
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct Attachment;

/// A value that depends on the state of the multibody. A copy has none.
#[cfg(feature = "upstream-signatures")]
#[derive(Default)]
pub struct Attachment(pub std::sync::OnceLock<Box<dyn core::any::Any + Send + Sync>>);

#[cfg(feature = "upstream-signatures")]
impl Clone for Attachment {
    fn clone(&self) -> Self {
        Self::default()
    }
}

#[cfg(feature = "upstream-signatures")]
impl core::fmt::Debug for Attachment {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("Attachment")
    }
}

/// The value follows from the state, which is compared by itself.
#[cfg(feature = "upstream-signatures")]
impl PartialEq for Attachment {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

#[cfg(feature = "upstream-signatures")]
impl Multibody {
    /// The value that a facade keeps with the multibody.
    pub fn attachment(&self) -> &std::sync::OnceLock<Box<dyn core::any::Any + Send + Sync>> {
        &self.attachment.0
    }

    /// Removes the value that a facade keeps with the multibody.
    pub fn remove_attachment(&mut self) {
        self.attachment = Attachment::default();
    }
}
