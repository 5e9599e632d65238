//! Does to a 3D world what the bytes say.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    fuzzer::solid::run(bytes);
});
