/work/wt/gears/target3/debug/deps/house-0da4cba1b28a9b29.d: crates/tidy/tests/house.rs

/work/wt/gears/target3/debug/deps/house-0da4cba1b28a9b29: crates/tidy/tests/house.rs

crates/tidy/tests/house.rs:

# env-dep:CARGO_MANIFEST_DIR=/work/wt/gears/crates/tidy
