//! Runs the programs of the documents, so that none of them is out of date.
//!
//! Every Rust block of the pages below is a documentation test of this crate: `cargo test -p handbook`.

macro_rules! pages {
    ($($name:ident: $path:literal,)*) => {
        $(
            #[cfg(doctest)]
            #[doc = include_str!($path)]
            mod $name {}
        )*
    };
}

pages! {
    readme: "../../../README.md",
    readme_of_rapier2d: "../../rapier2d/README.md",
    readme_of_rapier3d: "../../rapier3d/README.md",
    readme_of_rapier2d_f64: "../../rapier2d-f64/README.md",
    readme_of_rapier3d_f64: "../../rapier3d-f64/README.md",
    getting_started: "../../../docs/guide/getting-started.md",
    coming_from: "../../../docs/guide/coming-from.md",
    bodies: "../../../docs/guide/bodies.md",
    fast_bodies: "../../../docs/guide/fast-bodies.md",
    colliders: "../../../docs/guide/colliders.md",
    contacts_and_events: "../../../docs/guide/contacts-and-events.md",
    smooth_ground: "../../../docs/guide/smooth-ground.md",
    hooks: "../../../docs/guide/hooks.md",
    queries: "../../../docs/guide/queries.md",
    characters: "../../../docs/guide/characters.md",
    vehicles: "../../../docs/guide/vehicles.md",
    joints: "../../../docs/guide/joints.md",
    multibodies: "../../../docs/guide/multibodies.md",
    sleeping: "../../../docs/guide/sleeping.md",
    parameters: "../../../docs/guide/parameters.md",
    determinism: "../../../docs/guide/determinism.md",
    saving: "../../../docs/guide/saving.md",
    seeing: "../../../docs/guide/seeing.md",
}

// The page describes an optional feature.
#[cfg(feature = "parallel")]
pages! {
    threads: "../../../docs/guide/threads.md",
}
