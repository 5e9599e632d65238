//! Actions of the pointer: it pulls a body by a spring, and throws balls.

use crate::rapier::prelude::*;

/// Frequency of the spring (Hz) and its damping ratio.
const FREQUENCY: Real = 2.2;
const DAMPING: Real = 0.9;
/// Fraction of the angular velocity that a step takes away from a held body.
const SPIN_DAMPING: Real = 0.06;
/// Velocity of a thrown ball, in sizes of the scene a second, and its radius in such sizes.
const THROW: Real = 2.2;
const BALL: Real = 0.025;
/// Density of a thrown ball.
const BALL_DENSITY: Real = 6.0;

/// A body that the pointer pulls.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(crate) struct Grip {
    pub body: RigidBodyHandle,
    /// The point that is held, in the frame of the body.
    pub local_anchor: Vector,
    /// The point to which it is pulled.
    pub target: Vector,
}

impl Grip {
    /// Holds a point of a body.
    pub(crate) fn new(world: &PhysicsWorld, body: RigidBodyHandle, point: Vector) -> Option<Self> {
        let found = world.bodies.get(body)?;
        let local_anchor = found.position().inverse() * point;
        found.is_dynamic().then_some(Self { body, local_anchor, target: point })
    }

    /// The held point.
    pub(crate) fn anchor(&self, world: &PhysicsWorld) -> Option<Vector> {
        world.bodies.get(self.body).map(|body| *body.position() * self.local_anchor)
    }

    /// Pulls for one step: the impulse of a damped spring between the held point and the target.
    pub(crate) fn pull(&self, world: &mut PhysicsWorld) {
        let dt = world.integration_parameters.dt;
        let Some(body) = world.bodies.get_mut(self.body) else { return };
        let anchor = *body.position() * self.local_anchor;
        let omega = std::f64::consts::TAU as Real * FREQUENCY;
        let stretch = self.target - anchor;
        let velocity = body.velocity_at_point(anchor);
        // The implicit form is stable at every length of the step.
        let denominator = 1.0 + 2.0 * DAMPING * omega * dt + omega * omega * dt * dt;
        let change =
            (stretch * (omega * omega) - velocity * (2.0 * DAMPING * omega)) * (dt / denominator);
        let impulse = change * body.mass();
        let spin = body.angvel();
        body.apply_impulse_at_point(impulse, anchor, true);
        body.set_angvel(body.angvel() - spin * SPIN_DAMPING, true);
    }
}

/// The body under a ray, with the point that it hits. A half-space that contains the origin is not drawn, and
/// not picked.
pub(crate) fn pick(
    world: &PhysicsWorld,
    origin: Vector,
    direction: Vector,
) -> Option<(ColliderHandle, Vector)> {
    if DIM == 2 {
        let mut found = world.intersect_point(origin, QueryFilter::default().exclude_sensors());
        return found.next().map(|(handle, _)| (handle, origin));
    }
    let ray = Ray::new(origin, direction);
    let is_drawn = |_, collider: &Collider| {
        let local = collider.position().inverse_transform_point(origin);
        collider.shape().as_halfspace().is_none_or(|plane| local.dot(plane.normal) > 0.0)
    };
    let filter = QueryFilter::default().exclude_sensors().predicate(&is_drawn);
    let (handle, distance) = world.cast_ray(&ray, Real::MAX, true, filter)?;
    Some((handle, ray.point_at(distance)))
}

/// Throws a ball from a place in a direction, in a scene of a size.
pub(crate) fn throw(world: &mut PhysicsWorld, from: Vector, direction: Vector, size: Real) {
    let body = RigidBodyBuilder::dynamic()
        .translation(from)
        .linvel(direction * (THROW * size))
        .ccd_enabled(true);
    world.insert(body, ColliderBuilder::ball(BALL * size).density(BALL_DENSITY));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The spring brings a body to the target in about a second, against gravity, and holds it there.
    #[test]
    fn a_held_body_follows() {
        let mut world = PhysicsWorld::new();
        let (body, _) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.5));
        let mut grip = Grip::new(&world, body, Vector::ZERO).expect("it is dynamic");
        grip.target = Vector::X * 3.0;
        for _ in 0..90 {
            grip.pull(&mut world);
            world.step();
        }
        let place = world.bodies[body].translation();
        // Gravity stretches the spring by g / ω², 5 cm.
        assert!((place - grip.target).length() < 0.15, "at {place}");
    }

    /// A wall of glass in front of a drum is a half-space that faces away.
    #[test]
    fn a_body_is_picked_through_the_back_of_a_wall() {
        let mut world = PhysicsWorld::new();
        world.insert_collider(ColliderBuilder::halfspace(Vector::X), None);
        let place = RigidBodyBuilder::dynamic().translation(3.0 * Vector::X);
        let (_, ball) = world.insert(place, ColliderBuilder::ball(0.5));
        world.step();
        let eye = if DIM == 2 { 3.0 * Vector::X } else { -5.0 * Vector::X };
        let picked = pick(&world, eye, Vector::X);
        assert_eq!(picked.map(|(collider, _)| collider), Some(ball));
    }

    #[test]
    fn fixed_bodies_are_not_held() {
        let mut world = PhysicsWorld::new();
        let (body, _) = world.insert(RigidBodyBuilder::fixed(), ColliderBuilder::ball(0.5));
        assert_eq!(Grip::new(&world, body, Vector::ZERO), None);
    }
}
