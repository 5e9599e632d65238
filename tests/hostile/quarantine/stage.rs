//! A heap, a kinematic lift, a chain of links and a sleeping pile, all within reach of one suspect.

use super::super::event_checker::EventChecker;
use super::super::world::check;
use crate::dim::{about_z, cuboid, hinge, hostile::pose_bits, vec};
use rapier::prelude::*;
use std::collections::BTreeMap;
use std::sync::Mutex;

/// Number of undisturbed steps before the misuse. The heap is still moving at their end.
const BEFORE: usize = 20;

/// A world, and its misused bodies.
pub struct Stage {
    pub world: PhysicsWorld,
    /// A block in the middle of the heap.
    pub suspect: RigidBodyHandle,
    /// The block beside it.
    pub neighbour: RigidBodyHandle,
    /// A position-based kinematic body beneath some blocks of the heap.
    pub lift: RigidBodyHandle,
    /// Links of a multibody that reaches into the heap.
    pub links: Vec<RigidBodyHandle>,
    /// A block on a sleeping pile.
    pub sleeper: RigidBodyHandle,
    pub hooks: Numbers,
    event_checker: EventChecker,
}

/// Hooks that pass numbers to all contacts.
#[derive(Copy, Clone, Default)]
pub struct Numbers {
    pub restitution: Option<Real>,
    pub tangent_velocity: Option<Vector>,
}

impl PhysicsHooks for Numbers {
    fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
        if let Some(restitution) = self.restitution {
            context.set_restitution(restitution);
        }
        if let Some(velocity) = self.tangent_velocity {
            context.set_tangent_velocity(velocity);
        }
    }
}

/// Events of a step.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Events {
    pub quarantines: Vec<QuarantineEvent>,
    pub collisions: Vec<CollisionEvent>,
}

/// Handler that records events, and checks them.
struct Listener<'a> {
    event_checker: &'a EventChecker,
    events: Mutex<Events>,
}

impl EventHandler for Listener<'_> {
    fn handle_collision_event(
        &self,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
        event: &CollisionEvent,
        pair: Option<&ContactPair>,
    ) {
        self.events.lock().unwrap().collisions.push(*event);
        self.event_checker.handle_collision_event(bodies, colliders, event, pair);
    }

    fn handle_quarantine_event(
        &self,
        event: &QuarantineEvent,
        bodies: &RigidBodySet,
        _: &ColliderSet,
    ) {
        if let QuarantineEvent::Body { body, cause, position, velocity } = event {
            let body = &bodies[*body];
            assert!(!body.is_enabled(), "{event:?}");
            // The value may be NaN, which is not equal to itself.
            assert_eq!(format!("{:?}", body.quarantine()), format!("Some({cause:?})"));
            assert_eq!((body.position(), &body.vels()), (position, velocity));
        }
        self.events.lock().unwrap().quarantines.push(*event);
    }
}

impl Stage {
    pub fn new() -> Self {
        let mut world = PhysicsWorld::new();
        world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
        let block = |world: &mut PhysicsWorld, body: RigidBodyBuilder| {
            let collider = cuboid(0.5, 0.5).active_events(ActiveEvents::COLLISION_EVENTS);
            world.insert(body, collider.restitution(0.3)).0
        };
        let mut heap = Vec::new();
        for k in 0..20_u8 {
            let (column, row) = (Real::from(k % 5), Real::from(k / 5));
            let at = vec(1.05 * column + 0.1 * row, 0.6 + 1.15 * row);
            let body = RigidBodyBuilder::dynamic().translation(at).rotation(about_z(0.1 * column));
            heap.push(block(&mut world, body));
        }
        let lift = RigidBodyBuilder::kinematic_position_based().translation(vec(5.4, 0.1));
        let lift = world.insert(lift, cuboid(0.5, 0.1)).0;
        let mut parent = world.insert_body(RigidBodyBuilder::fixed().translation(vec(-3.0, 5.0)));
        let links = (0..4_u8).map(|k| {
            let at = vec(-2.5 + Real::from(k), 5.0);
            let body = RigidBodyBuilder::dynamic().translation(at);
            let link = world.insert(body, cuboid(0.4, 0.1)).0;
            let joint = hinge().local_anchor2(vec(-0.5, 0.0));
            let joint = joint.local_anchor1(vec(if k == 0 { 0.0 } else { 0.5 }, 0.0));
            world.multibody_joints.insert(parent, link, joint, true).expect("it fits");
            parent = link;
            link
        });
        let links = links.collect();
        let sleepers = [0.5, 1.5, 2.5].map(|y| {
            let body = RigidBodyBuilder::dynamic().translation(vec(12.0, y)).sleeping(true);
            block(&mut world, body)
        });
        let (suspect, neighbour, sleeper) = (heap[12], heap[13], sleepers[2]);
        let (hooks, event_checker) = (Numbers::default(), EventChecker::default());
        let mut stage =
            Self { world, suspect, neighbour, lift, links, sleeper, hooks, event_checker };
        for _ in 0..BEFORE {
            stage.step();
        }
        assert!(stage.world.bodies[stage.sleeper].is_sleeping());
        stage
    }

    /// Returns the suspect for edits.
    pub fn suspect(&mut self) -> &mut RigidBody {
        &mut self.world.bodies[self.suspect]
    }

    /// Adds a motor between the neighbour and the suspect, with this number for all its settings.
    pub fn drive(&mut self, model: MotorModel, number: Real) {
        let hinge = hinge().local_anchor1(vec(0.5, 0.0)).local_anchor2(vec(-0.5, 0.0));
        let mut joint: GenericJoint = hinge.build().into();
        joint.set_motor_model(JointAxis::AngX, model);
        joint.set_motor(JointAxis::AngX, 3.0, number, number, number);
        self.world.insert_impulse_joint(self.suspect, self.neighbour, joint);
    }

    /// Runs one step and checks the invariants. Returns the events.
    pub fn step(&mut self) -> Events {
        let listener = Listener { event_checker: &self.event_checker, events: Mutex::default() };
        self.world.step_with_events(&self.hooks, &listener);
        let events = listener.events.into_inner().unwrap();
        check(&self.world);
        self.event_checker.check();
        events
    }

    /// Returns all bits of the state of all enabled bodies.
    pub fn bits(&self) -> Vec<String> {
        let taking_part = self.world.bodies.iter().filter(|(_, body)| body.is_enabled());
        let bits = taking_part.map(|(handle, body)| {
            let velocity = (body.linvel(), body.angvel());
            format!(
                "{handle:?} {:?} {velocity:?} {:?}",
                pose_bits(body.position()),
                body.activation()
            )
        });
        bits.collect()
    }
}

/// A disabled body, its step and the cause.
pub type Disabled = (usize, RigidBodyHandle, QuarantineCause);

/// Misuses a stage, and steps it beside its twin.
pub fn experiment(misuse: impl Fn(&mut Stage)) -> Vec<Disabled> {
    let (mut stage, mut twin) = (Stage::new(), Stage::new());
    misuse(&mut stage);
    misuse(&mut twin);
    beside_its_twin(&mut stage, &mut twin)
}

/// Steps a stage beside its twin for two seconds.
pub fn beside_its_twin(stage: &mut Stage, twin: &mut Stage) -> Vec<Disabled> {
    (0..120).flat_map(|step| step_beside(step, stage, twin)).collect()
}

/// Runs one step of two stages with equal edits.
///
/// # Panics
/// If a bit or an event differs, or if a disabled body is not in its state before the step.
pub fn step_alike(step: usize, stage: &mut Stage, twin: &mut Stage) -> Vec<Disabled> {
    let before = copies_of_bodies(stage);
    let events = stage.step();
    // Texts compare NaN as equal.
    assert_eq!(format!("{events:?}"), format!("{:?}", twin.step()), "step {step}");
    assert_eq!(stage.bits(), twin.bits(), "step {step}");
    disabled_in(step, &events, stage, &before)
}

/// Runs one step of a stage and its twin.
///
/// # Panics
/// If the bits of an enabled body differ between both worlds, or if an event does.
pub fn step_beside(step: usize, stage: &mut Stage, twin: &mut Stage) -> Vec<Disabled> {
    let before = copies_of_bodies(stage);
    let events = stage.step();
    let disabled = disabled_in(step, &events, stage, &before);
    for &(_, body, _) in &disabled {
        twin.world.bodies[body].set_enabled(false);
    }
    let events_of_twin = twin.step();
    assert_eq!(events_of_twin.quarantines, [], "step {step}");
    assert_eq!(events.collisions, events_of_twin.collisions, "step {step}");
    assert_eq!(stage.bits(), twin.bits(), "step {step}, without {disabled:?}");
    disabled
}

fn copies_of_bodies(stage: &Stage) -> BTreeMap<RigidBodyHandle, RigidBody> {
    stage.world.bodies.iter().map(|(handle, body)| (handle, body.clone())).collect()
}

/// The bodies that a step disabled.
///
/// # Panics
/// If one of them is not in its state before the step or was disabled before, or if the counter has another
/// number.
fn disabled_in(
    step: usize,
    events: &Events,
    stage: &Stage,
    before: &BTreeMap<RigidBodyHandle, RigidBody>,
) -> Vec<Disabled> {
    let disabled = events.quarantines.iter().filter_map(|event| match *event {
        QuarantineEvent::Body { body, cause, position, velocity } => {
            let old = &before[&body];
            let state = (*old.position(), old.vels());
            assert_eq!((position, velocity), state, "the state before the step");
            assert!(old.is_enabled(), "{body:?} is disabled once");
            Some((step, body, cause))
        }
        _ => None,
    });
    let disabled: Vec<_> = disabled.collect();
    assert_eq!(stage.world.physics_pipeline.counters.solver.nquarantined, disabled.len());
    disabled
}
