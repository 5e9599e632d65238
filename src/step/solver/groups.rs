//! Which bodies are solved with how many substeps.
//!
//! What light bodies carry reaches the ground in sweeps over the contacts, and each sweep passes on what the
//! lighter of two bodies can: under a thing `r` times as heavy, a contact is pressed by `r` times the
//! weight for which it is stiff, and sinks in by `r σ g h² / β` ([`Softness`](crate::model::params::Softness)).
//! More visits per substep do not help (the error that is left after one is nearly all of it, 1 - 1/r), a
//! harder contact flies apart; but the sag falls with the square of the substep `h`, as everything in a
//! soft step does. So islands in which light bodies carry heavy ones get more substeps, and the others do
//! not pay for it: groups of islands are solved one after the other, each with its own `h`.
//!
//! Four cubes under one of 1000 times the mass sink in by 0.8 m with 4 substeps, 34 mm with 16, 10 mm
//! with 32. The alternatives were a direct solution of the contacts that press (they come and go within a
//! substep), and bodies that count as heavier while something rests on them, which do not fall as they should.

use crate::dim::math::Real;
use crate::model::body::{RigidBody, RigidBodyHandle, RigidBodySet};
use crate::model::contact::NarrowPhase;
use crate::model::island::{IslandManager, NONE};
use crate::model::params::IntegrationParameters;
use core::ops::Range;

/// Up to this ratio of masses the usual substeps do: four cubes under one of 30 times the mass sink in by 15 mm.
const EVEN: Real = 32.0;
/// No island gets more than this many times the usual substeps.
const MAX_FACTOR: usize = 16;
/// Nor so many that they are more than this times its number of bodies: what lies on a large heap rests on many.
const MAX_WORK: usize = 1024;

/// Bodies that are solved together.
#[derive(Clone, Debug)]
pub(super) struct Group {
    /// Where they stand in [`Groups::order`].
    pub members: Range<usize>,
    pub substeps: usize,
}

/// What an island needs.
#[derive(Copy, Clone, Debug)]
struct Need {
    /// Masses of the lightest and the heaviest of the bodies that touch another.
    masses: [Real; 2],
    /// Substeps that its bodies ask for.
    extra: usize,
}

impl Need {
    const NOTHING: Self = Self { masses: [Real::INFINITY, 0.0], extra: 0 };

    fn include(&mut self, mass: Real) {
        let [lightest, heaviest] = &mut self.masses;
        (*lightest, *heaviest) = (lightest.min(mass), heaviest.max(mass));
    }

    fn is_even(&self) -> bool {
        let [lightest, heaviest] = self.masses;
        heaviest <= EVEN * lightest
    }

    /// How many times the usual substeps an island of so many bodies gets: a power of two, that few groups do.
    fn factor(&self, bodies: usize) -> usize {
        let [lightest, heaviest] = self.masses;
        let mut factor = 1;
        while factor < MAX_FACTOR
            && 2 * factor * bodies <= MAX_WORK
            && heaviest > EVEN * lightest * (factor * factor) as Real
        {
            factor *= 2;
        }
        factor
    }
}

/// All awake bodies, in groups.
#[derive(Default)]
pub(super) struct Groups {
    /// First come bodies that belong to no island, if there are several groups: any constraint may read
    /// them. Then the members of each group.
    order: Vec<RigidBodyHandle>,
    groups: Vec<Group>,
    /// By island.
    needs: Vec<Need>,
    /// Substeps of each island, then those that occur.
    substeps: Vec<usize>,
    counts: Vec<usize>,
}

impl Groups {
    /// The bodies in the order in which the solver has them.
    pub fn order(&self) -> &[RigidBodyHandle] {
        &self.order
    }

    pub fn iter(&self) -> impl Iterator<Item = &Group> {
        self.groups.iter()
    }

    /// How many bodies stand before the groups.
    pub fn spectators(&self) -> usize {
        self.groups.first().map_or(0, |group| group.members.start)
    }

    /// Divides the awake bodies.
    pub fn divide(
        &mut self,
        islands: &IslandManager,
        bodies: &RigidBodySet,
        narrow_phase: &NarrowPhase,
        params: &IntegrationParameters,
    ) {
        self.order.clear();
        self.groups.clear();
        if all_alike(islands, bodies) {
            self.order.extend_from_slice(&islands.awake);
            let members = 0..self.order.len();
            return self.groups.push(Group { members, substeps: params.num_solver_iterations });
        }
        self.find_needs(islands, bodies, narrow_phase);
        self.find_substeps(islands, params);
        let island_of =
            |handle: &RigidBodyHandle| bodies.get(*handle).map_or(NONE, |body| body.link.island);
        let of_none = islands.awake.iter().filter(|handle| island_of(handle) == NONE);
        self.order.extend(of_none);
        for &substeps in &self.counts {
            let start = self.order.len();
            self.order.extend(
                islands.awake.iter().filter(|handle| {
                    self.substeps.get(island_of(handle) as usize) == Some(&substeps)
                }),
            );
            self.groups.push(Group { members: start..self.order.len(), substeps });
        }
    }

    /// Finds what each island needs from the bodies that touch each other.
    fn find_needs(
        &mut self,
        islands: &IslandManager,
        bodies: &RigidBodySet,
        narrow_phase: &NarrowPhase,
    ) {
        self.needs.clear();
        self.needs.resize(islands.island_bound() as usize, Need::NOTHING);
        for handle in &islands.awake {
            let Some(body) = bodies.get(*handle) else { continue };
            if let Some(need) = self.needs.get_mut(body.link.island as usize) {
                need.extra = need.extra.max(body.additional_solver_iterations);
            }
        }
        let at = |slot: u32| {
            bodies.at_slot(slot).map(|(_, body)| body).filter(|body| body.link.island != NONE)
        };
        for (_, manifolds) in islands.graph.in_solving_order() {
            for manifold in manifolds {
                let [Some(body1), Some(body2)] =
                    narrow_phase.contacts.bodies(manifold.pair).map(at)
                else {
                    continue;
                };
                let need = &mut self.needs[body1.link.island as usize];
                [body1, body2].into_iter().filter_map(mass).for_each(|mass| need.include(mass));
            }
        }
    }

    /// Finds the substeps of each island with an awake body.
    fn find_substeps(&mut self, islands: &IslandManager, params: &IntegrationParameters) {
        self.substeps.clear();
        self.counts.clear();
        for (id, need) in self.needs.iter().enumerate() {
            let island = islands.island(id as u32);
            let usual = params.num_solver_iterations + need.extra;
            self.substeps.push(usual * need.factor(island.bodies.len()));
            if !island.bodies.is_empty() && !island.sleeping {
                self.counts.extend(self.substeps.last());
            }
        }
        self.counts.sort_unstable();
        self.counts.dedup();
    }
}

/// Does no body ask for more substeps, and is none much heavier than another?
fn all_alike(islands: &IslandManager, bodies: &RigidBodySet) -> bool {
    let mut need = Need::NOTHING;
    for handle in &islands.awake {
        let Some(body) = bodies.get(*handle) else { continue };
        if body.link.island != NONE {
            need.extra = need.extra.max(body.additional_solver_iterations);
            mass(body).into_iter().for_each(|mass| need.include(mass));
        }
    }
    need.extra == 0 && need.is_even()
}

/// The mass of a body; `None` if it has none, or moves along no axis.
fn mass(body: &RigidBody) -> Option<Real> {
    let inverse = body.mprops.inv_mass.max_element();
    (inverse > 0.0).then(|| 1.0 / inverse)
}
