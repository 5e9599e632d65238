//! A stage with two piles: a misused one, and a distant one that must be unaffected.

use super::world::check;
use crate::dim::{about_z, cuboid, hostile::pose_bits, vec};
use rapier::prelude::*;

/// Numbers of undisturbed steps before, and of observed steps afterwards.
const BEFORE: usize = 20;
const AFTER: usize = 20;

/// Two piles on one ground.
pub struct Scene {
    pub world: PhysicsWorld,
    pub ground: ColliderHandle,
    /// The misused body, between two others of the first pile.
    pub body: RigidBodyHandle,
    pub collider: ColliderHandle,
    /// The two neighbours.
    pub neighbours: [RigidBodyHandle; 2],
    /// The second pile, which still falls and tumbles.
    distant: Vec<RigidBodyHandle>,
}

/// All bits of the state of some bodies.
pub type Bits = Vec<String>;

impl Scene {
    /// Creates the piles and runs a few steps: the first pile stands, the second one falls.
    pub fn new() -> Self {
        let mut world = PhysicsWorld::new();
        let ground = world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
        let block = |world: &mut PhysicsWorld, place, angle| {
            let body = RigidBodyBuilder::dynamic().translation(place).rotation(about_z(angle));
            world.insert(body, cuboid(0.5, 0.5))
        };
        let distant = (0..4_u8).map(|i| {
            let i = Real::from(i);
            block(&mut world, vec(1000.0 + 0.3 * i, 0.6 + 1.1 * i), 0.3 * i).0
        });
        let distant = distant.collect();
        let (below, _) = block(&mut world, vec(0.0, 0.5), 0.0);
        let (body, collider) = block(&mut world, vec(0.0, 1.5), 0.0);
        let (above, _) = block(&mut world, vec(0.0, 2.5), 0.0);
        let mut scene = Self { world, ground, body, collider, neighbours: [below, above], distant };
        scene.steps(BEFORE);
        scene
    }

    /// Creates the same scene with another type of the misused body.
    pub fn with_body_type(body_type: RigidBodyType) -> Self {
        let mut scene = Self::new();
        scene.world.bodies[scene.body].set_body_type(body_type, true);
        scene.steps(2);
        scene
    }

    pub fn body(&mut self) -> &mut RigidBody {
        &mut self.world.bodies[self.body]
    }

    pub fn collider(&mut self) -> &mut Collider {
        &mut self.world.colliders[self.collider]
    }

    /// Runs some steps, and checks the invariants after each.
    pub fn steps(&mut self, count: usize) {
        for _ in 0..count {
            self.world.step();
            check(&self.world);
        }
    }

    fn bits_of(&self, handles: &[RigidBodyHandle]) -> Bits {
        let of = |handle: &RigidBodyHandle| {
            let body = &self.world.bodies[*handle];
            let velocity = (body.linvel(), body.angvel());
            format!("{:?} {velocity:?} {:?}", pose_bits(body.position()), body.activation())
        };
        handles.iter().map(of).collect()
    }

    /// Runs the remaining steps and returns the bits of the second pile.
    pub fn distant_in_the_end(&mut self) -> Bits {
        self.steps(AFTER);
        self.bits_of(&self.distant)
    }

    /// Runs the remaining steps and returns the bits of all bodies.
    pub fn all_in_the_end(&mut self) -> Bits {
        self.steps(AFTER);
        let handles: Vec<_> = self.world.bodies.iter().map(|(handle, _)| handle).collect();
        self.bits_of(&handles)
    }
}
