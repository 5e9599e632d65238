//! A world as programs for Rapier assemble it.

use rapier::prelude::*;

/// Gravitational acceleration (length/s²).
pub const GRAVITY: Real = 9.81;

/// All parts of a world.
#[derive(Default)]
pub struct World {
    pub pipeline: PhysicsPipeline,
    pub parameters: IntegrationParameters,
    pub islands: IslandManager,
    pub broad_phase: DefaultBroadPhase,
    pub narrow_phase: NarrowPhase,
    pub bodies: RigidBodySet,
    pub colliders: ColliderSet,
    pub impulse_joints: ImpulseJointSet,
    pub multibody_joints: MultibodyJointSet,
    #[cfg(rapier036)]
    pub soft_bodies: SoftBodySet,
    pub ccd_solver: CCDSolver,
}

impl World {
    /// Takes one step with gravity along -y.
    pub fn step_with(&mut self, hooks: &dyn PhysicsHooks, events: &dyn EventHandler) {
        self.pipeline.step(
            Vector::Y * -GRAVITY,
            &self.parameters,
            &mut self.islands,
            &mut self.broad_phase,
            &mut self.narrow_phase,
            &mut self.bodies,
            &mut self.colliders,
            &mut self.impulse_joints,
            &mut self.multibody_joints,
            #[cfg(rapier036)]
            &mut self.soft_bodies,
            &mut self.ccd_solver,
            hooks,
            events,
        );
    }

    /// Takes `count` steps without hooks and events.
    pub fn steps(&mut self, count: usize) {
        for _ in 0..count {
            self.step_with(&(), &());
        }
    }

    /// Inserts a body with one collider.
    pub fn insert(
        &mut self,
        body: RigidBodyBuilder,
        collider: ColliderBuilder,
    ) -> (RigidBodyHandle, ColliderHandle) {
        let body = self.bodies.insert(body);
        let collider = self.colliders.insert_with_parent(collider, body, &mut self.bodies);
        (body, collider)
    }

    /// Fixed ground with its top at y = 0, and a box of unit size that rests on it.
    pub fn box_on_ground() -> (Self, RigidBodyHandle, [ColliderHandle; 2]) {
        let mut world = Self::default();
        let ground = world.colliders.insert(cuboid(50.0, 1.0).translation(Vector::Y * -1.0));
        let body = RigidBodyBuilder::dynamic().translation(Vector::Y * 0.5).can_sleep(false);
        let (body, collider) = world.insert(body, cuboid(0.5, 0.5));
        (world, body, [ground, collider])
    }
}

/// A box with half extents `half` along the ground and `half_height` upwards.
pub fn cuboid(half: Real, half_height: Real) -> ColliderBuilder {
    #[cfg(feature = "dim2")]
    return ColliderBuilder::cuboid(half, half_height);
    #[cfg(feature = "dim3")]
    return ColliderBuilder::cuboid(half, half_height, half);
}

/// Asserts that two numbers differ by at most `tolerance`.
#[track_caller]
pub fn assert_near(value: Real, expected: Real, tolerance: Real) {
    let error = (value - expected).abs();
    assert!(error <= tolerance, "{value} instead of {expected}, tolerance {tolerance}");
}

/// The error of `count` roundings of numbers near 1.
pub fn rounding(count: u32) -> Real {
    count as Real * Real::EPSILON
}

/// Symplectic Euler with `n` substeps of `h` falls by `g h² n (n + 1) / 2`.
#[test]
fn bodies_fall() {
    let mut world = World::default();
    let (body, _) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.5));
    world.steps(60);
    let substeps = 60.0 * world.parameters.num_solver_iterations as Real;
    let h = 1.0 / substeps;
    let fallen = GRAVITY * h * h * substeps * (substeps + 1.0) / 2.0;
    assert_near(world.bodies[body].translation().y, -fallen, rounding(5_000));
    assert_near(world.bodies[body].linvel().y, -GRAVITY, rounding(5_000));
}

#[test]
fn islands_list_awake_bodies() {
    let mut world = World::default();
    let (body, _) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.5));
    world.steps(1);
    let awake: Vec<RigidBodyHandle> = world.islands.active_bodies().collect();
    assert_eq!(awake, [body]);
}

/// Three flags lock rotations, in two dimensions too: the last one is that of the z axis.
#[test]
fn rotations_are_locked_by_axis() {
    let mut world = World::default();
    let (body, _) = world.insert(RigidBodyBuilder::dynamic(), cuboid(0.5, 0.5));
    for enabled in [false, true] {
        let turned = &mut world.bodies[body];
        turned.set_enabled_rotations(true, true, enabled, true);
        let before = *turned.rotation();
        turned.apply_impulse_at_point(Vector::Y, turned.center_of_mass() + Vector::X, true);
        world.steps(1);
        let after = *world.bodies[body].rotation();
        assert_eq!(after != before, enabled);
    }
}

#[cfg(not(rapier036))]
#[test]
fn parameters_have_the_fields_of_version_032() {
    let mut parameters = IntegrationParameters {
        dt: 1.0 / 30.0,
        contact_softness: SpringCoefficients { natural_frequency: 60.0, damping_ratio: 2.0 },
        normalized_allowed_linear_error: 0.002,
        num_internal_stabilization_iterations: 2,
        min_island_size: 64,
        length_unit: 10.0,
        ..IntegrationParameters::default()
    };
    assert_near(parameters.allowed_linear_error(), 0.02, rounding(2));
    assert_near(parameters.prediction_distance(), 0.02, rounding(2));
    parameters.set_inv_dt(120.0);
    assert_near(parameters.dt, 1.0 / 120.0, rounding(1));
}

/// A contact spring of angular frequency `ω` under gravity sinks in by `g/ω²` beyond the allowed error. (A
/// ball has one contact, whose effective mass is that of the ball.)
#[test]
fn soft_contacts_sink_in() {
    let mut world = World::default();
    world.colliders.insert(cuboid(50.0, 1.0).translation(Vector::Y * -1.0));
    let body = RigidBodyBuilder::dynamic().translation(Vector::Y * 0.5).can_sleep(false);
    let (body, _) = world.insert(body, ColliderBuilder::ball(0.5));
    let frequency = 5.0;
    world.parameters.contact_softness =
        SpringCoefficients { natural_frequency: frequency, damping_ratio: 1.0 };
    // The defaults select those of the engine.
    world.parameters.normalized_allowed_linear_error = 0.002;
    world.steps(600);
    let omega = core::f64::consts::TAU as Real * frequency;
    let depth = GRAVITY / (omega * omega) + world.parameters.allowed_linear_error();
    assert_near(world.bodies[body].translation().y, 0.5 - depth, 0.1 * depth);
}

/// A contact spring without a frequency corrects no overlap; one with a frequency does.
#[test]
fn softness_without_a_frequency_keeps_overlap() {
    for (frequency, remaining) in [(0.0, 0.1), (60.0, 0.0)] {
        let mut world = World::default();
        world.colliders.insert(cuboid(50.0, 1.0).translation(Vector::Y * -1.0));
        let body = RigidBodyBuilder::dynamic().translation(Vector::Y * 0.4).gravity_scale(0.0);
        let (body, _) = world.insert(body, ColliderBuilder::ball(0.5));
        world.parameters.contact_softness =
            SpringCoefficients { natural_frequency: frequency, damping_ratio: 1.0 };
        world.steps(60);
        let overlap = (0.5 - world.bodies[body].translation().y).max(0.0);
        assert_near(overlap, remaining, 0.005);
    }
}

/// Counts of zero and a coefficient above 1 act as the nearest valid values.
#[test]
fn invalid_parameters_are_clamped() {
    let fall = |parameters: IntegrationParameters| {
        let (mut world, body, _) = World::box_on_ground();
        world.parameters = parameters;
        world.bodies[body].set_translation(Vector::Y * 1.0, true);
        world.steps(40);
        (world.bodies[body].translation(), world.bodies[body].quarantine().is_some())
    };
    let defaults = IntegrationParameters::default();
    let invalid = IntegrationParameters {
        num_solver_iterations: 0,
        num_internal_pgs_iterations: 0,
        warmstart_coefficient: 1.5,
        ..defaults
    };
    let nearest = IntegrationParameters { num_solver_iterations: 1, ..defaults };
    let (place, is_quarantined) = fall(invalid);
    assert_eq!((place, is_quarantined), fall(nearest));
    assert!(!is_quarantined);
    assert_near(place.y, 0.5, 0.02);
}

#[cfg(feature = "debug-render")]
mod debug_render {
    use super::World;
    use rapier::prelude::*;

    #[test]
    fn modes_have_the_bits_of_rapier() {
        let modes = [
            DebugRenderMode::COLLIDER_SHAPES,
            DebugRenderMode::RIGID_BODY_AXES,
            DebugRenderMode::MULTIBODY_JOINTS,
            DebugRenderMode::IMPULSE_JOINTS,
            DebugRenderMode::SOLVER_CONTACTS,
            DebugRenderMode::CONTACTS,
            DebugRenderMode::COLLIDER_AABBS,
            DebugRenderMode::JOINTS,
            DebugRenderMode::default(),
            DebugRenderMode::all(),
        ];
        let all = if cfg!(rapier036) { 2047 } else { 127 };
        assert_eq!(modes.map(|mode| mode.bits()), [1, 2, 4, 8, 16, 32, 64, 12, 15, all]);
    }

    /// Counts lines by the kind of their object.
    #[derive(Default)]
    struct Lines {
        axes: usize,
        boxes: usize,
        others: usize,
    }

    impl DebugRenderBackend for Lines {
        fn draw_line(&mut self, object: DebugRenderObject, _: Vector, _: Vector, _: DebugColor) {
            match object {
                DebugRenderObject::RigidBody(..) => self.axes += 1,
                DebugRenderObject::ColliderAabb(..) => self.boxes += 1,
                _ => self.others += 1,
            }
        }
    }

    /// The mode of the pipeline selects the same parts as the engine's mode of that name.
    #[test]
    fn modes_select_parts() {
        let (mut world, ..) = World::box_on_ground();
        world.steps(1);
        let draw = |mode| {
            let mut lines = Lines::default();
            DebugRenderPipeline::new(DebugRenderStyle::default(), mode).render(
                &mut lines,
                &world.bodies,
                &world.colliders,
                &world.impulse_joints,
                &world.multibody_joints,
                &world.narrow_phase,
                #[cfg(rapier036)]
                &world.soft_bodies,
            );
            [lines.axes > 0, lines.boxes > 0, lines.others > 0]
        };
        assert_eq!(draw(DebugRenderMode::RIGID_BODY_AXES), [true, false, false]);
        assert_eq!(draw(DebugRenderMode::COLLIDER_AABBS), [false, true, false]);
        assert_eq!(draw(DebugRenderMode::CONTACTS), [false, false, true]);
        assert_eq!(draw(DebugRenderMode::JOINTS), [false, false, false]);
    }
}
