//! A character in a world, moved as in a game.

use crate::dim::{about_z, cuboid, vec};
use rapier::control::*;
use rapier::prelude::*;

/// Length of a step (s).
pub const DT: Real = 1.0 / 60.0;
/// Half the length of the capsule's straight part, and its radius.
pub const CAPSULE: (Real, Real) = (0.6, 0.3);
/// Distance from the capsule's middle to its lowest point.
pub const FOOT: Real = CAPSULE.0 + CAPSULE.1;
/// Gap of the character: a hundredth of its height.
pub const OFFSET: Real = 0.02 * FOOT;
/// Largest difference between a gap and the offset: the controller's tolerance, plus the error of casts.
pub const GAP_TOLERANCE: Real = 5.0e-4;

/// Walking character.
pub struct Walker {
    pub world: PhysicsWorld,
    pub controller: KinematicCharacterController,
    pub body: RigidBodyHandle,
    pub collider: ColliderHandle,
    /// Collisions of the last step.
    pub collisions: Vec<CharacterCollision>,
    /// Vertical velocity of the fall (length/s).
    pub fall: Real,
    /// Whether the character rides on its ground.
    pub rides: bool,
    pub grounded: bool,
}

impl Walker {
    /// Creates a capsule with its middle at a place.
    pub fn new(world: PhysicsWorld, place: Vector) -> Self {
        Self::of(world, ColliderBuilder::capsule_y(CAPSULE.0, CAPSULE.1), place)
    }

    pub fn of(mut world: PhysicsWorld, shape: ColliderBuilder, place: Vector) -> Self {
        world.integration_parameters.dt = DT;
        let body = RigidBodyBuilder::kinematic_position_based().translation(place);
        let (body, collider) = world.insert(body, shape);
        world.step();
        let controller = KinematicCharacterController::default();
        let (collisions, fall, rides, grounded) = (Vec::new(), 0.0, false, false);
        Self { world, controller, body, collider, collisions, fall, rides, grounded }
    }

    pub fn place(&self) -> Vector {
        self.world.bodies[self.body].translation()
    }

    /// Returns the height of the capsule's lowest point.
    pub fn feet(&self) -> Real {
        self.place().y - FOOT
    }

    /// Returns the controller's result without applying it.
    pub fn compute(&mut self, desired: Vector) -> EffectiveCharacterMovement {
        self.collisions.clear();
        let filter = QueryFilter::default().exclude_rigid_body(self.body);
        let collider = &self.world.colliders[self.collider];
        let collisions = &mut self.collisions;
        self.controller.move_shape(
            DT,
            &self.world.query_pipeline_with_filter(filter),
            collider.shape(),
            collider.position(),
            desired,
            |collision| collisions.push(collision),
        )
    }

    /// Moves by a desired velocity for a step, with gravity. Returns the effective movement.
    pub fn step(&mut self, velocity: Vector) -> EffectiveCharacterMovement {
        self.fall = if self.grounded { 0.0 } else { self.fall } - 9.81 * DT;
        let movement = self.compute((velocity + Vector::Y * self.fall) * DT);
        self.grounded = movement.grounded;
        let (bodies, colliders) = (&self.world.bodies, &self.world.colliders);
        let ride = match movement.ground {
            Some(ground) if self.rides => ground.displacement(bodies, colliders, DT),
            _ => Vector::ZERO,
        };
        let next = self.place() + movement.translation + ride;
        self.world.bodies[self.body].set_next_kinematic_translation(next);
        self.world.step();
        movement
    }

    /// Runs several steps.
    pub fn steps(&mut self, count: usize, velocity: Vector) {
        for _ in 0..count {
            self.step(velocity);
        }
    }

    /// Runs until the character is at rest.
    pub fn settled(mut self) -> Self {
        self.steps(60, Vector::ZERO);
        assert!(self.grounded, "it should have landed, but is at {}", self.place());
        self
    }
}

/// Returns a world with level ground at height 0.
pub fn level() -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    world.insert_collider(cuboid(100.0, 1.0).translation(vec(0.0, -1.0)), None);
    world
}

/// Returns a world with a plane through the origin that rises to the right.
pub fn slope(degrees: Real) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let angle = degrees.to_radians();
    let place = vec(angle.sin(), -angle.cos());
    let plane = cuboid(200.0, 1.0).translation(place).rotation(about_z(angle));
    world.insert_collider(plane, None);
    world
}

/// Returns the position of a standing capsule's middle, at the offset, on a slope through the origin.
pub fn on_slope(degrees: Real, x: Real) -> Vector {
    let angle = degrees.to_radians();
    // The lower ball touches the slope at its normal.
    let ball = (CAPSULE.1 + OFFSET) / angle.cos();
    vec(x, x * angle.tan() + ball + CAPSULE.0)
}
