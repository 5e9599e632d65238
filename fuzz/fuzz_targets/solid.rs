//! Runs the operations of the bytes on a 3D world.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    fuzzer::solid::run(bytes);
});
