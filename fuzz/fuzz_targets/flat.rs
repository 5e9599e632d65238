//! Does to a 2D world what the bytes say.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    fuzzer::flat::run(bytes);
});
