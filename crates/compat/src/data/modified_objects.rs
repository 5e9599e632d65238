//! A list of changed objects.

use core::marker::PhantomData;
use core::ops::Deref;

/// An object with a flag that marks it as changed.
pub trait HasModifiedFlag {
    /// Returns whether the object is marked.
    fn has_modified_flag(&self) -> bool;
    /// Marks the object.
    fn set_modified_flag(&mut self);
}

/// Handles of changed objects. The flag of an object prevents a second entry.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct ModifiedObjects<Handle, Object>(Vec<Handle>, PhantomData<Object>);

impl<Handle, Object> Default for ModifiedObjects<Handle, Object> {
    fn default() -> Self {
        Self(Vec::new(), PhantomData)
    }
}

impl<Handle, Object> Deref for ModifiedObjects<Handle, Object> {
    type Target = Vec<Handle>;

    fn deref(&self) -> &Vec<Handle> {
        &self.0
    }
}

impl<Handle, Object: HasModifiedFlag> ModifiedObjects<Handle, Object> {
    /// An empty list with space for `capacity` handles.
    pub fn with_capacity(capacity: usize) -> Self {
        Self(Vec::with_capacity(capacity), PhantomData)
    }

    /// Removes all handles. The flags of the objects remain.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Adds an object, unless it is marked already.
    pub fn push_once(&mut self, handle: Handle, object: &mut Object) {
        if !object.has_modified_flag() {
            self.push_unchecked(handle, object);
        }
    }

    /// Adds an object.
    pub fn push_unchecked(&mut self, handle: Handle, object: &mut Object) {
        object.set_modified_flag();
        self.0.push(handle);
    }
}
