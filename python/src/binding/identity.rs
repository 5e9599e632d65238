//! Equality and hashes of objects of a world.

/// Compares objects of a class by their world and a field with a handle.
macro_rules! identify {
    ($class:ident by $handle:ident) => {
        impl PartialEq for $class {
            fn eq(&self, other: &Self) -> bool {
                self.world.is(&other.world) && self.$handle == other.$handle
            }
        }

        impl Eq for $class {}

        impl std::hash::Hash for $class {
            fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
                self.$handle.hash(state);
            }
        }
    };
}

pub(super) use identify;
