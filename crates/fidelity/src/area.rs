//! The areas of tests, one document each.

/// Tests of one subject.
pub struct Area {
    /// The folder below `tests/`.
    pub folder: &'static str,
    /// Paths of tests, as filters of the test program.
    pub filters: &'static [&'static str],
    /// The document below `docs/fidelity/`.
    pub page: &'static str,
    /// The document's heading.
    pub title: &'static str,
}

impl Area {
    /// Returns whether a test with this path, with dots between its parts, belongs to the area.
    pub fn contains(&self, path: &str) -> bool {
        self.filters.iter().any(|filter| path.starts_with(&filter.replace("::", ".")))
    }
}

/// All areas, in the order of the documents.
pub const AREAS: [Area; 6] = [
    Area {
        folder: "physics",
        filters: &[
            "suite::physics",
            "dim::beams",
            "dim::hulls",
            "dim::rods",
            "dim::tumbling",
            "dim::turntable",
        ],
        page: "mechanics.md",
        title: "Motion, contacts and friction",
    },
    Area {
        folder: "joints",
        filters: &["suite::joints", "dim::boards", "dim::joints"],
        page: "joints.md",
        title: "Joints",
    },
    Area {
        folder: "multibody",
        filters: &["suite::multibody", "dim::whips"],
        page: "multibodies.md",
        title: "Multibodies",
    },
    Area { folder: "ccd", filters: &["suite::ccd"], page: "fast-bodies.md", title: "Fast bodies" },
    Area {
        folder: "ghosts",
        filters: &["suite::ghosts"],
        page: "smooth-ground.md",
        title: "Smooth ground",
    },
    Area { folder: "vehicle", filters: &["dim::vehicle"], page: "vehicles.md", title: "Vehicles" },
];
