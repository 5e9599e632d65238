//! Kernels that visit one block after the other.

/// Declares a kernel over a range of blocks, with its fields and its work on the block `index`. The work
/// uses the fields by name, and registers of type `W`.
///
/// The work may access the exclusive data of one block:
/// * the block itself and its data under the same index;
/// * the states of its dynamic bodies, if the kernel runs [colour by colour](super::for_each_color).
///
/// It may read data that no block writes.
macro_rules! block_kernel {
    (
        $(#[$doc:meta])*
        $visibility:vis struct $name:ident<$lifetime:lifetime $(, const $parameter:ident: bool)?> {
            $($(#[$field_doc:meta])* $field:ident: $type:ty,)*
        }
        |$index:ident| $work:expr
    ) => {
        $(#[$doc])*
        $visibility struct $name<$lifetime $(, const $parameter: bool)?> {
            $visibility range: core::ops::Range<usize>,
            $($(#[$field_doc])* $visibility $field: $type,)*
        }

        impl<$lifetime $(, const $parameter: bool)?> $crate::base::wide::Kernel
            for $name<$lifetime $(, $parameter)?>
        {
            type Output = ();

            #[inline(always)]
            fn run<W: $crate::base::wide::Wide>(self) {
                let Self { range, $($field),* } = self;
                for $index in range {
                    // SAFETY: each block belongs to one task, constraints of one colour have no common
                    // dynamic body, and the colours run in sequence.
                    unsafe { $work };
                }
            }
        }
    };
}

pub(in crate::step::solver) use block_kernel;
