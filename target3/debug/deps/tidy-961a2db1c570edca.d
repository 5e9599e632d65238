/work/wt/gears/target3/debug/deps/tidy-961a2db1c570edca.d: crates/tidy/src/lib.rs crates/tidy/src/arrows.rs crates/tidy/src/danger.rs crates/tidy/src/limits.rs crates/tidy/src/papers.rs crates/tidy/src/prose.rs crates/tidy/src/source.rs crates/tidy/src/variants.rs

/work/wt/gears/target3/debug/deps/libtidy-961a2db1c570edca.rlib: crates/tidy/src/lib.rs crates/tidy/src/arrows.rs crates/tidy/src/danger.rs crates/tidy/src/limits.rs crates/tidy/src/papers.rs crates/tidy/src/prose.rs crates/tidy/src/source.rs crates/tidy/src/variants.rs

/work/wt/gears/target3/debug/deps/libtidy-961a2db1c570edca.rmeta: crates/tidy/src/lib.rs crates/tidy/src/arrows.rs crates/tidy/src/danger.rs crates/tidy/src/limits.rs crates/tidy/src/papers.rs crates/tidy/src/prose.rs crates/tidy/src/source.rs crates/tidy/src/variants.rs

crates/tidy/src/lib.rs:
crates/tidy/src/arrows.rs:
crates/tidy/src/danger.rs:
crates/tidy/src/limits.rs:
crates/tidy/src/papers.rs:
crates/tidy/src/prose.rs:
crates/tidy/src/source.rs:
crates/tidy/src/variants.rs:
