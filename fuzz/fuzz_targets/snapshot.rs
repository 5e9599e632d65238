//! Loads the bytes as the parts of a snapshot of a 3D world.
#![no_main]

libfuzzer_sys::fuzz_target!(|parts: &[u8]| {
    fuzzer::solid::forged::load(parts);
});
