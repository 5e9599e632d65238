//! A block of contacts between bodies made by hand, and the passes that act on it.

use crate::base::disjoint::DisjointMut;
use crate::base::random::Random;
use crate::base::wide::{Kernel, LANES, Lane, Simd, Wide};
use crate::dim::contact::{ContactBlock, CoulombBlock};
use crate::dim::math::{
    ANG_ZERO, AngVector, AngularInertia, DIM, Real, Rotation, Vector, cross, mul_inertia,
    rotation_from_angle, torque, zero_inertia,
};
use crate::dim::spatial::join;
use crate::dim::state::{BodyPose, BodyState, READ_ONLY};
use crate::model::contact::{AnchorFrame, ContactInput, ContactReport};
use crate::model::params::{ContactPass, ImpactPass, Softness};
use crate::step::solver::contacts::{PrepareContext, passes, prepare, store_impulses};
use crate::step::solver::impact_time::ImpactTime;
use crate::step::solver::impacts::{
    ActiveBlock, ImpactBlock, ImpactMark, KnownVelocities, NormalRows, lanes,
};
use parry::shape::{Cuboid, Shape};

/// The lane that tests of one contact use.
pub const LANE: usize = LANES - 2;
/// Length of a substep (s).
pub const SUBSTEP: Real = 1.0 / 240.0;
/// Approach slower than this does not bounce (length/s).
pub const THRESHOLD: Real = 0.5;
/// Prediction distance.
pub const PREDICTION: Real = 0.02;

/// A body with the data that the solver reads.
#[derive(Copy, Clone)]
pub struct Body {
    pub rotation: Rotation,
    pub center: Vector,
    pub inv_mass: Vector,
    pub inv_inertia: AngularInertia,
    pub linvel: Vector,
    pub angvel: AngVector,
    pub read_only: bool,
}

impl Body {
    /// A body of mass 1 at rest at the origin, that nothing can turn.
    pub fn block() -> Self {
        Self {
            rotation: Rotation::IDENTITY,
            center: Vector::ZERO,
            inv_mass: Vector::ONE,
            inv_inertia: zero_inertia(),
            linvel: Vector::ZERO,
            angvel: ANG_ZERO,
            read_only: false,
        }
    }

    /// A box of any size, density, place, orientation and velocity.
    pub fn random(random: &mut Random) -> Self {
        let half_extents = random_vector(random, 0.3).abs() + Vector::splat(0.3);
        let mass = Cuboid::new(half_extents).mass_properties(random.within(0.5, 4.0));
        let rotation = rotation_from_angle(random_turn(random, 2.0));
        Self {
            rotation,
            center: random_vector(random, 1.0),
            inv_mass: Vector::splat(mass.inv_mass),
            inv_inertia: mass.world_inv_inertia(&rotation),
            linvel: random_vector(random, 1.0),
            angvel: random_turn(random, 1.0),
            read_only: false,
        }
    }

    /// Effect of an impulse at a world point on the velocities.
    pub fn pushed(&self, impulse: Vector, point: Vector) -> (Vector, AngVector) {
        let moment = torque(point - self.center, impulse);
        (
            self.linvel + self.inv_mass * impulse,
            self.angvel + mul_inertia(&self.inv_inertia, moment),
        )
    }
}

/// A vector with components within `-size..size`.
pub fn random_vector(random: &mut Random, size: f64) -> Vector {
    let mut vector = Vector::ZERO;
    for axis in 0..DIM {
        vector[axis] = random.within(-size, size);
    }
    vector
}

/// A unit vector.
pub fn random_direction(random: &mut Random) -> Vector {
    loop {
        let vector = random_vector(random, 1.0);
        if (0.1..1.0).contains(&vector.length()) {
            return vector.normalize();
        }
    }
}

/// A rotation vector of about this length.
pub fn random_turn(random: &mut Random, size: f64) -> AngVector {
    torque(random_vector(random, size), random_vector(random, 1.0))
}

/// A manifold: its points, each with its separation, and its material.
#[derive(Clone)]
pub struct Contact {
    pub normal: Vector,
    pub points: Vec<(Vector, Real)>,
    pub friction: Real,
    pub restitution: Real,
    pub tangent_velocity: Vector,
    /// Rotation (rad) of the bodies since.
    pub frozen_angle: Real,
}

impl Contact {
    /// Smooth points of no separation.
    pub fn at(normal: Vector, points: &[Vector]) -> Self {
        Self {
            normal,
            points: points.iter().map(|&point| (point, 0.0)).collect(),
            friction: 0.0,
            restitution: 0.0,
            tangent_velocity: Vector::ZERO,
            frozen_angle: 0.0,
        }
    }

    /// The same with friction.
    pub fn rough(self, friction: Real) -> Self {
        Self { friction, ..self }
    }
}

/// Bodies and one block of contacts between them.
pub struct Scene {
    pub poses: Vec<BodyPose>,
    pub states: Vec<BodyState>,
    pub before: Vec<BodyState>,
    pub input: ContactInput,
    pub reports: [ContactReport; LANES],
    pub block: ContactBlock,
    /// Friction per point, if the model has it.
    pub coulomb: Option<CoulombBlock>,
    pub pass: ContactPass,
    pub prediction: Real,
    pub simd: Simd,
}

impl Scene {
    /// An empty world.
    pub fn empty() -> Self {
        Self {
            poses: vec![BodyPose::WORLD],
            states: vec![BodyState::default()],
            before: vec![BodyState::default()],
            input: ContactInput::EMPTY,
            reports: [ContactReport::EMPTY; LANES],
            block: ContactBlock::EMPTY,
            coulomb: None,
            pass: ContactPass {
                inv_substep: 1.0 / SUBSTEP,
                softness: Softness::RIGID,
                push_velocity_max: 4.0,
                allowed_error: 0.0,
                is_last_iteration: true,
            },
            prediction: PREDICTION,
            simd: Simd::detect(),
        }
    }

    /// One contact, between two bodies or the world (`None`).
    pub fn new(bodies: [Option<Body>; 2], contact: &Contact) -> Self {
        let mut scene = Self::empty();
        scene.add(LANE, bodies, contact);
        scene
    }

    /// Fills a lane.
    pub fn add(&mut self, lane: usize, bodies: [Option<Body>; 2], contact: &Contact) {
        for (side, body) in bodies.iter().enumerate() {
            let index = match body {
                Some(body) => self.add_body(body),
                None => BodyPose::WORLD_INDEX,
            };
            self.input.bodies[side][lane] = index;
            self.input.is_world[side].0[lane] = if body.is_none() { 1.0 } else { 0.0 };
            self.input.mass_factors[side].0[lane] = 1.0;
        }
        let [x1, x2] = bodies.map(|body| body.map(|body| body.center));
        let anchor_frame = AnchorFrame {
            rotations: bodies.map(|body| body.map_or(Rotation::IDENTITY, |body| body.rotation)),
            centers: x2.unwrap_or_default() - x1.unwrap_or_default(),
            may_freeze: true,
        };
        self.input.anchor_frame.set_lane(lane, &anchor_frame, contact.normal, contact.frozen_angle);
        self.input.anchor_frame.set_near_rest(lane, true);
        for (k, &(point, separation)) in contact.points.iter().enumerate() {
            self.input.arms[k].set_lane(lane, point - x1.or(x2).unwrap_or_default());
            self.input.anchor_separations[k].0[lane] = separation;
            self.input.present[k].0[lane] = 1.0;
        }
        self.input.friction.0[lane] = contact.friction;
        self.input.restitution.0[lane] = contact.restitution;
        self.input.tangent_velocity.set_lane(lane, contact.tangent_velocity);
    }

    fn add_body(&mut self, body: &Body) -> u32 {
        let index = self.states.len() as u32;
        self.poses.push(BodyPose::new(
            body.rotation,
            body.center,
            body.inv_mass,
            &body.inv_inertia,
        ));
        self.states.push(BodyState::new(body.linvel, body.angvel));
        self.before.push(BodyState::new(body.linvel, body.angvel));
        if body.read_only { index | READ_ONLY } else { index }
    }

    /// Starts a substep as the driver does: accelerates, and applies the last substep's impulses.
    pub fn begin_substep(&mut self, acceleration: Vector) {
        for (state, before) in self.states.iter_mut().zip(&mut self.before).skip(1) {
            let ((v, w), (old_v, old_w)) = (state.velocity(), before.velocity());
            before.set_velocity(v + acceleration * SUBSTEP, w);
            state.set_velocity(v + acceleration * SUBSTEP + (v - old_v), w + (w - old_w));
        }
    }

    pub fn prepare(&mut self) {
        self.run(Pass::Prepare);
    }

    pub fn solve(&mut self) {
        self.run(Pass::Solve);
    }

    pub fn relax(&mut self) {
        self.run(Pass::Relax);
    }

    /// The warm-start impulses of the lanes for the next step.
    pub fn keep(&mut self) {
        self.run(Pass::Keep);
    }

    /// A round of an impact of all lanes.
    pub fn bounce(&mut self) {
        self.run(Pass::Bounce);
    }

    fn run(&mut self, pass: Pass) {
        self.simd.run(Run { scene: self, pass });
    }

    /// The velocities of a body of the scene (0 is the world).
    pub fn velocity(&self, body: usize) -> (Vector, AngVector) {
        self.states[body].velocity()
    }

    /// The sum of the normal impulses of the one contact.
    pub fn normal_impulse(&self) -> Real {
        self.block.points.iter().map(|point| point.impulse.0[LANE]).sum()
    }

    /// The friction impulse of the one contact, in world space.
    pub fn friction_impulse(&mut self) -> Vector {
        self.keep();
        self.input.friction_impulse.lane(LANE)
    }

    /// Velocity of the second body relative to the first at a point of the one contact.
    pub fn relative_velocity(&self, bodies: [Option<Body>; 2], point: Vector) -> Vector {
        let mut index = 0;
        let [first, second] = bodies.map(|body| {
            let Some(body) = body else { return Vector::ZERO };
            index += 1;
            let (linvel, angvel) = self.velocity(index);
            linvel + cross(angvel, point - body.center)
        });
        second - first
    }
}

#[derive(Copy, Clone)]
enum Pass {
    Prepare,
    Solve,
    Relax,
    Keep,
    Bounce,
}

struct Run<'a> {
    scene: &'a mut Scene,
    pass: Pass,
}

impl Kernel for Run<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        let Scene { poses, states, before, input, reports, block, coulomb, pass, .. } = self.scene;
        let prediction = self.scene.prediction;
        let loaded = states.to_vec();
        let states = DisjointMut::new(states);
        // SAFETY: this thread owns the states exclusively.
        unsafe {
            match self.pass {
                Pass::Prepare => {
                    let context =
                        PrepareContext { poses, states: &states, prediction, half_step: 0.0 };
                    let coulomb = coulomb.as_mut();
                    prepare::<W>(input, block, coulomb, context);
                }
                Pass::Solve => passes::solve::<W>(block, &states, pass),
                Pass::Relax => passes::relax::<W>(block, coulomb.as_mut(), &states, pass),
                Pass::Keep => store_impulses::<W>(block, coulomb.as_ref(), input, reports, 0.0),
                Pass::Bounce => {
                    let pass = ImpactPass {
                        step: SUBSTEP,
                        substep: SUBSTEP,
                        inv_substep: 1.0 / SUBSTEP,
                        threshold: THRESHOLD,
                        fall: 10.0 * SUBSTEP,
                    };
                    let known = KnownVelocities { last: before, loaded: &loaded };
                    bounce::<W>(block, coulomb.as_mut(), input.restitution, &states, known, &pass);
                }
            }
        }
    }
}

/// # Safety
/// The caller has exclusive access to the states of the block's bodies.
#[inline(always)]
unsafe fn bounce<W: Wide>(
    block: &mut ContactBlock,
    coulomb: Option<&mut CoulombBlock>,
    restitution: Lane,
    states: &DisjointMut<BodyState>,
    known: KnownVelocities<'_>,
    pass: &ImpactPass,
) {
    let mut impact = ImpactBlock::new(0, restitution, [0; LANES]);
    let mut mark = ImpactMark::default();
    // SAFETY: the caller's promise.
    unsafe {
        let rows = NormalRows::<W>::gather(states, block);
        impact.begin(&rows, block, known, pass);
        impact.mark(&mut mark, &rows, block, pass);
        let mut active = ActiveBlock::EMPTY;
        lanes(mark.active).for_each(|lane| active.push(0, lane, &impact, block));
        active.iterate::<W>(states);
        let mut times = vec![ImpactTime::default(); states.len()];
        active.end::<W>(states, &DisjointMut::new(&mut times));
        active.commit(core::slice::from_mut(&mut impact), |_| 1.0);
        impact.defer(&mut mark, block);
        impact.solve_friction::<W>(block, coulomb, states);
    }
}

/// Moves a body by `h` times its velocity.
pub fn advance(state: &mut BodyState, h: Real) {
    let (linvel, angvel) = state.velocity();
    state.add_displacement(join(linvel * h, angvel * h));
}
