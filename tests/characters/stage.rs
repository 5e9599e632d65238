//! A character in a world, moved as a game moves it.

use crate::dim::{about_z, cuboid, vec};
use rapier::control::*;
use rapier::prelude::*;

/// Length of a step (s).
pub const DT: Real = 1.0 / 60.0;
/// Half the height of the capsule's straight part, and its radius.
pub const CAPSULE: (Real, Real) = (0.6, 0.3);
/// From the capsule's middle to its lowest point.
pub const FOOT: Real = CAPSULE.0 + CAPSULE.1;
/// The gap that the character keeps: a hundredth of its height.
pub const OFFSET: Real = 0.02 * FOOT;
/// By how much a gap may differ from the offset: the controller's tolerance, and what casts lose.
pub const GAP_TOLERANCE: Real = 5.0e-4;

/// A walking character.
pub struct Walker {
    pub world: PhysicsWorld,
    pub controller: KinematicCharacterController,
    pub body: RigidBodyHandle,
    pub collider: ColliderHandle,
    /// Collisions of the last step.
    pub collisions: Vec<CharacterCollision>,
    /// The vertical velocity of the fall so far (length/s).
    pub fall: Real,
    /// Whether it rides on its ground.
    pub rides: bool,
    pub grounded: bool,
}

impl Walker {
    /// A capsule with its middle at a place.
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

    /// Where the lowest point of the capsule is.
    pub fn feet(&self) -> Real {
        self.place().y - FOOT
    }

    /// The controller's answer, without applying it.
    pub fn ask(&mut self, wish: Vector) -> EffectiveCharacterMovement {
        self.collisions.clear();
        let filter = QueryFilter::default().exclude_rigid_body(self.body);
        let collider = &self.world.colliders[self.collider];
        let collisions = &mut self.collisions;
        self.controller.move_shape(
            DT,
            &self.world.query_pipeline_with_filter(filter),
            collider.shape(),
            collider.position(),
            wish,
            |collision| collisions.push(collision),
        )
    }

    /// Wishes to go at a velocity for a step, and to fall; returns how far it came.
    pub fn step(&mut self, velocity: Vector) -> EffectiveCharacterMovement {
        self.fall = if self.grounded { 0.0 } else { self.fall } - 9.81 * DT;
        let movement = self.ask((velocity + Vector::Y * self.fall) * DT);
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

    /// Many steps.
    pub fn steps(&mut self, count: usize, velocity: Vector) {
        for _ in 0..count {
            self.step(velocity);
        }
    }

    /// Lets it come to rest.
    pub fn settled(mut self) -> Self {
        self.steps(60, Vector::ZERO);
        assert!(self.grounded, "it should have landed, but is at {}", self.place());
        self
    }
}

/// A world whose ground is level at height 0.
pub fn level() -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    world.insert_collider(cuboid(100.0, 1.0).translation(vec(0.0, -1.0)), None);
    world
}

/// A world with a plane through the origin that rises to the right.
pub fn slope(degrees: Real) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let angle = degrees.to_radians();
    let place = vec(angle.sin(), -angle.cos());
    let plane = cuboid(200.0, 1.0).translation(place).rotation(about_z(angle));
    world.insert_collider(plane, None);
    world
}

/// Where a capsule's middle is when it stands, at the offset, on a slope through the origin.
pub fn on_slope(degrees: Real, x: Real) -> Vector {
    let angle = degrees.to_radians();
    // The lower ball touches where its normal is that of the slope.
    let ball = (CAPSULE.1 + OFFSET) / angle.cos();
    vec(x, x * angle.tan() + ball + CAPSULE.0)
}
