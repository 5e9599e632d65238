//! The panels around the picture.

pub(crate) mod gallery;
pub(crate) mod help;
pub(crate) mod inspect;
pub(crate) mod parameters;
pub(crate) mod shown;
pub(crate) mod transport;
