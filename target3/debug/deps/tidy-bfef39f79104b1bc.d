/work/wt/gears/target3/debug/deps/tidy-bfef39f79104b1bc.d: crates/tidy/src/lib.rs crates/tidy/src/arrows.rs crates/tidy/src/danger.rs crates/tidy/src/limits.rs crates/tidy/src/papers.rs crates/tidy/src/prose.rs crates/tidy/src/source.rs crates/tidy/src/variants.rs

/work/wt/gears/target3/debug/deps/tidy-bfef39f79104b1bc: crates/tidy/src/lib.rs crates/tidy/src/arrows.rs crates/tidy/src/danger.rs crates/tidy/src/limits.rs crates/tidy/src/papers.rs crates/tidy/src/prose.rs crates/tidy/src/source.rs crates/tidy/src/variants.rs

crates/tidy/src/lib.rs:
crates/tidy/src/arrows.rs:
crates/tidy/src/danger.rs:
crates/tidy/src/limits.rs:
crates/tidy/src/papers.rs:
crates/tidy/src/prose.rs:
crates/tidy/src/source.rs:
crates/tidy/src/variants.rs:

# env-dep:CARGO_MANIFEST_DIR=/work/wt/gears/crates/tidy
