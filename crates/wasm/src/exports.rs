//! The macro that exports functions.

/// Exports functions to JavaScript under their names. `?` leaves a function with a [`Fault`](crate::fault::Fault), which JavaScript receives as an
/// exception.
macro_rules! exports {
    ($(
        $(#[$attribute:meta])*
        fn $name:ident($($argument:ident: $kind:ty),* $(,)?) $(-> $result:ty)? $body:block
    )*) => {$(
        $(#[$attribute])*
        // The linker refuses a second function of the same name.
        #[unsafe(no_mangle)]
        #[allow(clippy::too_many_arguments, reason = "numbers are passed one by one")]
        pub extern "C" fn $name($($argument: $kind),*) $(-> $result)? {
            #[inline]
            fn checked($($argument: $kind),*) -> Result<exports!(@ $($result)?), $crate::fault::Fault> {
                Ok($body)
            }
            $crate::fault::finish(checked($($argument),*))
        }
    )*};
    (@) => { () };
    (@ $result:ty) => { $result };
}
