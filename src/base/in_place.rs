//! Copies that reuse the memory of an earlier copy.
//!
//! The derived `clone_from` makes a new value and drops the old one, with all its lists. Rollback copies a
//! world in every step, so the containers of a world copy field by field instead.

/// Implements `Clone` for a struct whose fields are all listed. `clone_from` calls that of every field.
///
/// Fields after `unless_equal` are compared first: a copied map allocates memory even if the copy is equal.
macro_rules! clone_in_place {
    ($type:ident $(<$parameter:ident>)? { $($field:ident),* $(,)? } $(unless_equal { $($map:ident),* })?) => {
        impl$(<$parameter: Clone>)? Clone for $type$(<$parameter>)? {
            fn clone(&self) -> Self {
                Self { $($field: self.$field.clone(),)* $($($map: self.$map.clone()),*)? }
            }

            fn clone_from(&mut self, source: &Self) {
                let Self { $($field,)* $($($map),*)? } = source;
                $(self.$field.clone_from($field);)*
                $($(if self.$map != *$map {
                    self.$map.clone_from($map);
                })*)?
            }
        }
    };
}
pub(crate) use clone_in_place;
