//! Curves of the growth measurement: each varies one quantity and keeps the others.

use super::world::{SLEEP_DELAY, World};

/// Number of moving bodies among bodies at rest.
const MOVING_BODIES: usize = 100;
/// Number of bodies of a curve over contacts.
const CONTACT_CURVE_BODIES: usize = 2_000;
/// Number of bodies of a curve over threads.
const THREAD_CURVE_BODIES: usize = 20_000;
/// Largest number of awake bodies. More take minutes.
const AWAKE_MAX: usize = 100_000;

/// Quantity that a curve varies.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Curve {
    /// Bodies that are awake and touch others.
    Awake,
    /// Bodies that are fixed.
    Static,
    /// Bodies that sleep.
    Sleeping,
    /// Contact points of a fixed number of bodies.
    Contacts,
    /// Threads.
    Threads,
}

/// World of a curve, with its number of threads.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Setting {
    /// The world.
    pub world: World,
    /// Number of threads.
    pub threads: usize,
    /// Value of the varied quantity, if it is known in advance. Numbers of contact points are not.
    pub grows: Option<usize>,
}

impl Curve {
    /// All curves, in the order of the page.
    pub const ALL: [Curve; 5] =
        [Curve::Awake, Curve::Static, Curve::Sleeping, Curve::Contacts, Curve::Threads];

    /// Returns the name on the command line and in the names of files.
    pub fn name(self) -> &'static str {
        match self {
            Curve::Awake => "awake",
            Curve::Static => "static",
            Curve::Sleeping => "sleeping",
            Curve::Contacts => "contacts",
            Curve::Threads => "threads",
        }
    }

    /// Returns the heading on the page.
    pub fn heading(self) -> &'static str {
        match self {
            Curve::Awake => "Bodies that are awake",
            Curve::Static => "Fixed bodies",
            Curve::Sleeping => "Sleeping bodies",
            Curve::Contacts => "Contacts per body",
            Curve::Threads => "Threads",
        }
    }

    /// Returns the description of the curve's worlds.
    pub fn description(self) -> String {
        match self {
            Curve::Awake => "Boxes in heaps of ten, all awake.".to_owned(),
            Curve::Static => format!(
                "Fixed blocks, and {MOVING_BODIES} awake boxes, spread evenly among them, each on a block."
            ),
            Curve::Sleeping => format!(
                "Sleeping boxes on the floor, and {MOVING_BODIES} boxes that may not sleep, spread evenly among them. Bodies sleep here in all \
                 engines, after {SLEEP_DELAY} s of calm. The measurement begins then."
            ),
            Curve::Contacts => format!(
                "{CONTACT_CURVE_BODIES} boxes in five worlds. The first has single boxes on the floor. The next three have heaps of 10, of 100 and \
                 of all boxes, with gaps between the neighbours of a layer. The last has one heap in which these touch. Each engine counts its \
                 own contact points."
            ),
            Curve::Threads => format!(
                "{THREAD_CURVE_BODIES} boxes in heaps of 100, all awake. All times are wall times, also with one thread."
            ),
        }
    }

    /// Returns the meaning of the x axis.
    pub fn x_axis(self) -> &'static str {
        match self {
            Curve::Awake => "bodies",
            Curve::Static => "fixed bodies",
            Curve::Sleeping => "sleeping bodies",
            Curve::Contacts => "contact points",
            Curve::Threads => "threads",
        }
    }

    /// Returns the worlds with at most `bodies_max` bodies, from the smallest to the largest. All curves
    /// except that over threads use the first number of threads.
    pub fn settings(self, threads: &[usize], bodies_max: usize) -> Vec<Setting> {
        let first = threads[0];
        let sizes = |max: usize| {
            let max = max.min(bodies_max);
            (2..=6).map(|power| 10_usize.pow(power)).filter(move |&size| size <= max)
        };
        let of = |world: World| Setting { world, threads: first, grows: Some(world.bodies()) };
        match self {
            Curve::Awake => sizes(AWAKE_MAX)
                .map(|bodies| of(World::Heaps { bodies, each: 10, dense: false }))
                .collect(),
            Curve::Static => sizes(usize::MAX)
                .map(|bodies| of(World::Static { bodies, awake: MOVING_BODIES }))
                .collect(),
            Curve::Sleeping => sizes(usize::MAX)
                .map(|bodies| of(World::Sleeping { bodies, awake: MOVING_BODIES }))
                .collect(),
            Curve::Contacts => {
                let bodies = CONTACT_CURVE_BODIES.min(bodies_max);
                let heaps =
                    [(1, false), (10, false), (100, false), (bodies, false), (bodies, true)];
                let world = |(each, dense)| World::Heaps { bodies, each, dense };
                heaps.map(|heap| Setting { grows: None, ..of(world(heap)) }).to_vec()
            }
            Curve::Threads => {
                let world = World::Heaps {
                    bodies: THREAD_CURVE_BODIES.min(bodies_max),
                    each: 100,
                    dense: false,
                };
                let setting = |threads| Setting { world, threads, grows: Some(threads) };
                thread_counts(threads).into_iter().map(setting).collect()
            }
        }
    }
}

/// Returns the listed numbers of threads. A single number selects all numbers up to the machine's
/// parallelism.
fn thread_counts(threads: &[usize]) -> Vec<usize> {
    match threads {
        [_] => (1..=std::thread::available_parallelism().map_or(1, usize::from)).collect(),
        several => several.to_vec(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn worlds_grow_up_to_the_limit() {
        let sizes = |curve: Curve, threads: &[usize], bodies_max| -> Vec<usize> {
            let settings = curve.settings(threads, bodies_max);
            settings.iter().filter_map(|setting| setting.grows).collect()
        };
        assert_eq!(sizes(Curve::Awake, &[1], 1_000_000), [100, 1_000, 10_000, 100_000]);
        assert_eq!(sizes(Curve::Static, &[1], 1_000_000).last(), Some(&1_000_000));
        assert_eq!(sizes(Curve::Sleeping, &[1], 5_000), [100, 1_000]);
        assert_eq!(sizes(Curve::Threads, &[1, 2, 8], 1_000_000), [1, 2, 8]);
        assert_eq!(Curve::Contacts.settings(&[1], 1_000_000).len(), 5);
    }
}
