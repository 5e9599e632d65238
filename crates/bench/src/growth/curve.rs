//! The curves: what grows in each, and what stays as it is.

use super::{CALM, World};
use crate::args::Options;

/// Bodies that move among those that do not.
const FEW: usize = 100;
/// Bodies of a curve over contacts.
const PILED: usize = 2_000;
/// Bodies of a curve over threads.
const LARGE: usize = 20_000;
/// More than so many bodies that are awake take minutes.
const AWAKE_MAX: usize = 100_000;

/// What grows.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Curve {
    /// Bodies that are awake and touch others.
    Awake,
    /// Bodies that are fixed.
    Static,
    /// Bodies that sleep.
    Sleeping,
    /// Contact points of as many bodies.
    Contacts,
    /// Threads.
    Threads,
}

/// One world of a curve, and the threads that run it.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Setting {
    /// The world.
    pub world: World,
    /// Number of threads.
    pub threads: usize,
    /// What grows, if it is known before; contact points are not.
    pub grows: Option<usize>,
}

impl World {
    /// The bodies that the curve is about.
    pub fn bodies(self) -> usize {
        match self {
            World::Heaps { bodies, .. }
            | World::Static { bodies, .. }
            | World::Sleeping { bodies, .. } => bodies,
        }
    }
}

impl Curve {
    /// All, in the order of the page.
    pub const ALL: [Curve; 5] =
        [Curve::Awake, Curve::Static, Curve::Sleeping, Curve::Contacts, Curve::Threads];

    /// What the command line and the names of files call it.
    pub fn name(self) -> &'static str {
        match self {
            Curve::Awake => "awake",
            Curve::Static => "static",
            Curve::Sleeping => "sleeping",
            Curve::Contacts => "contacts",
            Curve::Threads => "threads",
        }
    }

    /// The heading of its part of the page.
    pub fn heading(self) -> &'static str {
        match self {
            Curve::Awake => "Bodies that are awake",
            Curve::Static => "Fixed bodies",
            Curve::Sleeping => "Sleeping bodies",
            Curve::Contacts => "Contacts per body",
            Curve::Threads => "Threads",
        }
    }

    /// What is in its worlds.
    pub fn says(self) -> String {
        match self {
            Curve::Awake => "Boxes in heaps of ten, all awake.".to_owned(),
            Curve::Static => format!(
                "Fixed blocks, and {FEW} boxes that are awake, spread evenly among them, each on a block."
            ),
            Curve::Sleeping => format!(
                "Boxes that lie on the floor and have fallen asleep, and {FEW} among them, spread evenly, that may not. Here bodies sleep \
                 in all engines, after {CALM} s of calm; what is measured begins when they do."
            ),
            Curve::Contacts => format!(
                "{PILED} boxes: each by itself on the floor; in heaps of 10, of 100, of all, apart from their neighbours in the \
                 layer; in one heap in which neighbours touch, too. Contact points by each engine's own account."
            ),
            Curve::Threads => format!(
                "{LARGE} boxes in heaps of 100, all awake. Time on the wall, with one thread, too."
            ),
        }
    }

    /// What the x axis means.
    pub fn below(self) -> &'static str {
        match self {
            Curve::Awake => "bodies",
            Curve::Static => "fixed bodies",
            Curve::Sleeping => "sleeping bodies",
            Curve::Contacts => "contact points",
            Curve::Threads => "threads",
        }
    }

    /// Its worlds, from the smallest to the largest that the user allows.
    pub fn settings(self, options: &Options) -> Vec<Setting> {
        let first = options.threads[0];
        let sizes = |max: usize| {
            let max = max.min(options.bodies_max);
            (2..=6).map(|power| 10_usize.pow(power)).filter(move |&size| size <= max)
        };
        let of = |world: World| Setting { world, threads: first, grows: Some(world.bodies()) };
        match self {
            Curve::Awake => sizes(AWAKE_MAX)
                .map(|bodies| of(World::Heaps { bodies, each: 10, dense: false }))
                .collect(),
            Curve::Static => {
                sizes(usize::MAX).map(|bodies| of(World::Static { bodies, awake: FEW })).collect()
            }
            Curve::Sleeping => {
                sizes(usize::MAX).map(|bodies| of(World::Sleeping { bodies, awake: FEW })).collect()
            }
            Curve::Contacts => {
                let bodies = PILED.min(options.bodies_max);
                let heaps =
                    [(1, false), (10, false), (100, false), (bodies, false), (bodies, true)];
                let world = |(each, dense)| World::Heaps { bodies, each, dense };
                heaps.map(|heap| Setting { grows: None, ..of(world(heap)) }).to_vec()
            }
            Curve::Threads => {
                let world =
                    World::Heaps { bodies: LARGE.min(options.bodies_max), each: 100, dense: false };
                let setting = |threads| Setting { world, threads, grows: Some(threads) };
                threads(options).into_iter().map(setting).collect()
            }
        }
    }
}

/// Those that the user lists, or as many as there can be if it is one number only.
fn threads(options: &Options) -> Vec<usize> {
    match options.threads.as_slice() {
        [_] => (1..=std::thread::available_parallelism().map_or(1, usize::from)).collect(),
        several => several.to_vec(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::args::{Request, parse};

    fn settings(curve: Curve, words: &str) -> Vec<Setting> {
        let words: Vec<String> = words.split_whitespace().map(str::to_owned).collect();
        match parse(&words, &crate::catalog::scenes()) {
            Ok(Request::Run(options)) => curve.settings(&options),
            _ => panic!("`{words:?}` should be understood"),
        }
    }

    #[test]
    fn worlds_grow_as_far_as_they_may() {
        let sizes = |curve, words| -> Vec<usize> {
            settings(curve, words).iter().filter_map(|setting| setting.grows).collect()
        };
        assert_eq!(sizes(Curve::Awake, ""), [100, 1_000, 10_000, 100_000]);
        assert_eq!(sizes(Curve::Static, "").last(), Some(&1_000_000));
        assert_eq!(sizes(Curve::Sleeping, "--bodies-max 5000"), [100, 1_000]);
        assert_eq!(sizes(Curve::Threads, "--threads 1,2,8"), [1, 2, 8]);
        assert_eq!(settings(Curve::Contacts, "").len(), 5);
    }
}
