//! Runs the operations of the bytes on a 2D world.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    fuzzer::flat::run(bytes);
});
