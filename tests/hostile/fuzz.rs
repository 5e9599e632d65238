//! A user without sense: random operations on random objects with random values, some of them
//! impossible, with a step after every few of them.

mod bodies;
mod colliders;

use super::random::Dice;
use super::witness::Witness;
use super::world::check;
use crate::dim::vec;
use rapier::prelude::*;

/// Operations in each crate; spread over several worlds.
const OPERATIONS: usize = 24_000;
const WORLDS: usize = 8;
/// A world is kept from growing beyond this.
const BODIES_MAX: usize = 40;

/// A world, and every handle that was ever given out in it.
pub struct Victim {
    pub world: PhysicsWorld,
    pub dice: Dice,
    pub bodies: Vec<RigidBodyHandle>,
    pub colliders: Vec<ColliderHandle>,
    /// What was taken out, to be put in again.
    pub morgue: Vec<RigidBody>,
}

impl Victim {
    fn new(seed: u64) -> Self {
        let mut world = PhysicsWorld::new();
        let ground = ColliderBuilder::halfspace(Vector::Y).active_events(ActiveEvents::all());
        let ground = world.insert_collider(ground, None);
        let dice = Dice::new(seed);
        let (bodies, colliders) = (vec![RigidBodyHandle::invalid()], vec![ground]);
        Self { world, dice, bodies, colliders, morgue: Vec::new() }
    }

    /// Any body handle: most often of a body that exists, sometimes a stale or foreign one.
    pub fn body(&mut self) -> RigidBodyHandle {
        if self.dice.once_in(20) {
            let (slot, generation) = (self.dice.below(70) as u32, self.dice.below(4) as u32);
            return RigidBodyHandle::from_raw_parts(slot, generation);
        }
        let recent = self.bodies.len().saturating_sub(60);
        self.bodies[recent + self.dice.below(self.bodies.len() - recent)]
    }

    /// Any collider handle.
    pub fn collider(&mut self) -> ColliderHandle {
        if self.dice.once_in(20) {
            let (slot, generation) = (self.dice.below(70) as u32, self.dice.below(4) as u32);
            return ColliderHandle::from_raw_parts(slot, generation);
        }
        let recent = self.colliders.len().saturating_sub(90);
        self.colliders[recent + self.dice.below(self.colliders.len() - recent)]
    }

    fn act(&mut self) {
        match self.dice.below(10) {
            0 | 1 if self.world.bodies.len() < BODIES_MAX => bodies::insert(self),
            0 | 1 => bodies::remove(self),
            2..=4 => bodies::edit(self),
            5 => colliders::insert_or_remove(self),
            6..=8 => colliders::edit(self),
            _ => self.meddle(),
        }
    }

    /// Changes the world as a whole.
    fn meddle(&mut self) {
        let dice = &mut self.dice;
        match dice.below(8) {
            0 => self.world.gravity = super::values::some_vector(dice, 20.0),
            1 => self.world.integration_parameters.dt = dice.pick(&[1.0 / 60.0, 0.0, 1.0e-9, 0.5]),
            2 => self.world.integration_parameters.dt = super::values::some_real(dice),
            3 => self.world.wake_up_all(dice.coin()),
            4 => {
                let model = dice.pick(&[FrictionModel::Standard, FrictionModel::Coulomb]);
                self.world.integration_parameters.friction_model = model;
            }
            5 => self.world.integration_parameters.length_unit = super::values::some_real(dice),
            6 => {
                let handle = self.body();
                self.world.wake_up(handle, true);
            }
            _ => self.calm_down(),
        }
    }

    /// Back to parameters with which something happens.
    fn calm_down(&mut self) {
        self.world.integration_parameters = IntegrationParameters::default();
        self.world.gravity = vec(0.0, -9.81);
    }
}

/// Will a step take place? It is refused as a whole if its parameters are impossible.
fn is_possible(world: &PhysicsWorld) -> bool {
    let gravity: Real = world.gravity.abs().to_array().into_iter().sum();
    world.integration_parameters.validate().is_ok() && (0.0..=1.0e15).contains(&gravity)
}

fn run(seed: u64) {
    let mut victim = Victim::new(seed);
    let witness = Witness::default();
    let mut done = 0;
    while done < OPERATIONS / WORLDS {
        for _ in 0..victim.dice.below(6) {
            victim.act();
            done += 1;
        }
        if victim.dice.once_in(20) {
            victim.calm_down();
        }
        if !is_possible(&victim.world) {
            victim.world.step_with_events(&(), &witness);
            victim.calm_down();
        }
        match victim.dice.below(20) {
            0 => victim.world.detect_collisions(&(), &witness),
            1 => (0..60).for_each(|_| victim.world.step_with_events(&(), &witness)),
            _ => victim.world.step_with_events(&(), &witness),
        }
        check(&victim.world);
        witness.check();
    }
}

#[test]
fn random_operations_leave_the_world_in_order() {
    for seed in 0..WORLDS as u64 {
        run(seed);
    }
}
