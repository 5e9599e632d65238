//! Objects that JavaScript owns: worlds, shapes, event queues and controllers. A number identifies each.
//!
//! A number combines slot and generation. The number of a freed object finds nothing after the slot is
//! reused, until the generations of the slot have wrapped around. JavaScript keeps no number of a freed
//! object: an owner clears its number, and a shape exists for one call.

use crate::events::{Events, give_back, lend};
use crate::fault::{Fault, Kind};
use crate::handle::Handle;
use crate::memory::{self, Single};
use crate::mirror::Mirror;
use crate::rapier::dynamics::{RigidBody, RigidBodyHandle, RigidBodySet};
use crate::rapier::geometry::{Collider, ColliderHandle, ColliderSet};
use crate::rapier::pipeline::{PhysicsWorld, QueryPipeline};
use core::cell::Cell;
use core::hint::black_box;
use core::ptr::null;

/// Bits of a number that are the slot.
const SLOT_BITS: u32 = 20;
/// The mask of the slot.
const SLOT_MASK: u32 = (1 << SLOT_BITS) - 1;
/// The last generation of a slot. The highest bit of a number stays 0, because results of WebAssembly are
/// signed in JavaScript: a number that comes back as a double would be negative.
const GENERATION_MAX: u32 = (1 << (31 - SLOT_BITS)) - 1;

/// A list of objects of one kind.
pub struct Registry<T> {
    slots: Vec<(u32, Option<Box<T>>)>,
    free: Vec<u32>,
}

impl<T> Registry<T> {
    /// An empty list.
    pub const fn new() -> Self {
        Self { slots: Vec::new(), free: Vec::new() }
    }

    /// Adds an object. Returns its number, which is not 0.
    pub fn insert(&mut self, object: T) -> u32 {
        let slot = match self.free.pop() {
            Some(slot) => slot,
            None => {
                self.slots.push((1, None));
                self.slots.len() as u32 - 1
            }
        };
        let (generation, place) = &mut self.slots[slot as usize];
        *place = Some(Box::new(object));
        (*generation << SLOT_BITS) | slot
    }

    /// The object of a number.
    pub fn get(&mut self, number: u32) -> Option<&mut T> {
        let (generation, object) = self.slots.get_mut((number & SLOT_MASK) as usize)?;
        if *generation != number >> SLOT_BITS {
            return None;
        }
        object.as_deref_mut()
    }

    /// The object of a number, to be shared.
    pub fn get_shared(&self, number: u32) -> Option<&T> {
        let (generation, object) = self.slots.get((number & SLOT_MASK) as usize)?;
        if *generation != number >> SLOT_BITS {
            return None;
        }
        object.as_deref()
    }

    /// Removes an object. The slot is reused with the next generation, so slots never run out.
    pub fn remove(&mut self, number: u32) -> Option<Box<T>> {
        self.get(number)?;
        let slot = number & SLOT_MASK;
        let (generation, object) = &mut self.slots[slot as usize];
        *generation = *generation % GENERATION_MAX + 1;
        self.free.push(slot);
        object.take()
    }
}

/// Present use of a world.
#[derive(Copy, Clone, PartialEq, Eq)]
pub enum Activity {
    /// No call.
    Idle,
    /// A query with callbacks reads it.
    Read,
    /// A step changes it.
    Stepped,
    /// A defect of the engine interrupted a step.
    Broken,
}

/// The sets that a hook may read while it runs.
pub type LentSets = (*const RigidBodySet, *const ColliderSet);

/// The trees of a world's queries. They contain edits since the last step, too.
struct Queries {
    pipeline: QueryPipeline,
    /// The world may have changed since the last update.
    is_stale: bool,
}

/// A world with the boundary's state. It is shared: a call from a hook reads it during the step.
pub struct Instance {
    world: Single<PhysicsWorld>,
    queries: Single<Queries>,
    activity: Cell<Activity>,
    sets: Cell<LentSets>,
    mirror: Single<Option<Mirror>>,
}

static WORLDS: Single<Registry<Instance>> = Single::new(Registry::new());

/// Adds a world.
pub fn insert_world(world: PhysicsWorld) -> u32 {
    let instance = Instance {
        world: Single::new(world),
        queries: Single::new(Queries { pipeline: QueryPipeline::new(), is_stale: true }),
        activity: Cell::new(Activity::Idle),
        sets: Cell::new((null(), null())),
        mirror: Single::new(None),
    };
    // SAFETY: the reference ends with the statement.
    unsafe { WORLDS.get().insert(instance) }
}

/// Frees a world. A second time does nothing.
pub fn free_world(number: u32) -> Result<(), Fault> {
    let Ok(instance) = instance(number) else { return Ok(()) };
    let activity = instance.activity.get();
    if matches!(activity, Activity::Read | Activity::Stepped) {
        return Err(busy(activity));
    }
    // SAFETY: the reference ends with the statement.
    drop(unsafe { WORLDS.get().remove(number) });
    Ok(())
}

/// The world of a number, in any state.
fn instance(number: u32) -> Result<&'static Instance, Fault> {
    // SAFETY: boxes do not move when the registry grows, and only `free_world` drops one, which no function
    // does while it uses the world.
    unsafe { WORLDS.get().get_shared(number) }.ok_or_else(|| Fault::freed("world"))
}

/// A running step or query.
struct Running {
    /// An address of its stack frame. The stack grows downwards: frames of later calls have smaller
    /// addresses.
    frame: usize,
    world: u32,
    /// The world's activity before the call.
    before: Activity,
    /// The event queue that a step fills, or 0.
    queue: u32,
}

/// The running steps and queries, the outermost first.
static RUNNING: Single<Vec<Running>> = Single::new(Vec::new());

/// Runs the work of a step or query, and records it while it runs.
fn run<R>(
    world: u32,
    instance: &Instance,
    activity: Activity,
    queue: u32,
    work: impl FnOnce() -> R,
) -> R {
    let marker = 0_u8;
    let frame = black_box(&raw const marker) as usize;
    let before = instance.activity.replace(activity);
    // SAFETY: the reference ends with the statement.
    unsafe { RUNNING.get() }.push(Running { frame, world, before, queue });
    let result = work();
    abandon(frame);
    // SAFETY: the reference ends with the statement.
    unsafe { RUNNING.get() }.pop();
    instance.activity.set(before);
    give_back(queue);
    result
}

/// Ends the steps and queries whose frames lie below an address: an exception ended them.
fn abandon(floor: usize) {
    // SAFETY: the reference ends with the statement.
    while let Some(ended) = unsafe { RUNNING.get() }.pop_if(|running| running.frame < floor) {
        give_back(ended.queue);
        if let Ok(instance) = instance(ended.world) {
            let was_stepped = instance.activity.get() == Activity::Stepped;
            instance.activity.set(if was_stepped { Activity::Broken } else { ended.before });
        }
    }
}

exports! {
    /// Ends the steps and queries whose stack frames lie below an address: an exception ended them. A world
    /// in the middle of a step can only be freed.
    fn calls_abandon(floor: usize) {
        abandon(floor);
    }
}

/// Steps a world. JavaScript may use it meanwhile, but only in hooks, with the lent sets. A queue of 0 drops
/// events.
pub fn stepped(
    number: u32,
    queue: u32,
    work: impl FnOnce(&mut PhysicsWorld, &Cell<LentSets>, Option<&Events>),
) -> Result<(), Fault> {
    let instance = instance(number)?;
    let activity = instance.activity.get();
    if activity != Activity::Idle {
        return Err(busy(activity));
    }
    let events = lend(queue)?;
    run(number, instance, Activity::Stepped, queue, || {
        // SAFETY: while the activity is `Stepped`, no other function borrows the world.
        let world = unsafe { instance.world.get() };
        work(world, &instance.sets, events);
        // SAFETY: the reference ends with the statement.
        unsafe { instance.queries.get() }.is_stale = true;
        // SAFETY: the reference ends with the statement.
        if let Some(mirror) = unsafe { instance.mirror.get() } {
            mirror.update(world);
        }
    });
    memory::pass_warning_on();
    Ok(())
}

/// Returns the world for reading, with the colliders of bodies that were moved at their new poses. A callback
/// of a query reads what the query has moved.
pub fn moved(number: u32) -> Result<&'static PhysicsWorld, Fault> {
    let instance = instance(number)?;
    if instance.activity.get() == Activity::Idle {
        // SAFETY: no step or query is running, and the reference ends with the block.
        let world = unsafe { instance.world.get() };
        world.bodies.propagate_modified_body_positions_to_colliders(&mut world.colliders);
    }
    read(number)
}

/// Updates the trees of queries after edits and steps. Without any since the last update, it has no effect.
pub fn update_queries(
    number: u32,
) -> Result<(&'static PhysicsWorld, &'static QueryPipeline), Fault> {
    let instance = instance(number)?;
    // SAFETY: callbacks of queries change nothing, so only the outermost query updates the trees: it comes
    // before every use of them.
    let queries = unsafe { instance.queries.get() };
    if queries.is_stale && instance.activity.get() == Activity::Idle {
        queries.pipeline.update(&moved(number)?.colliders);
        queries.is_stale = false;
    }
    Ok((read(number)?, &queries.pipeline))
}

/// Gives a query read access to a world and to its trees. JavaScript may read the world meanwhile.
pub fn queried<R>(
    number: u32,
    work: impl FnOnce(&PhysicsWorld, &QueryPipeline) -> R,
) -> Result<R, Fault> {
    let (world, queries) = update_queries(number)?;
    Ok(run(number, instance(number)?, Activity::Read, 0, || work(world, queries)))
}

/// Returns the world for changes by a controller, and the trees of its queries.
pub fn controlled(
    number: u32,
) -> Result<(&'static mut PhysicsWorld, &'static QueryPipeline), Fault> {
    let (_, queries) = update_queries(number)?;
    Ok((write(number)?, queries))
}

/// Returns the mirror of a world, updated on request.
pub fn mirror(number: u32, refresh: bool) -> Result<Option<&'static Mirror>, Fault> {
    let instance = instance(number)?;
    // SAFETY: the exported functions of the mirror get one, once.
    let mirror = unsafe { instance.mirror.get() };
    if refresh {
        let mirror = mirror.get_or_insert_default();
        mirror.is_stale = true;
        mirror.update(read(number)?);
    }
    Ok(mirror.as_ref())
}

#[cold]
fn busy(activity: Activity) -> Fault {
    let what = match activity {
        Activity::Stepped => {
            "a step of this world is running: hooks may read bodies and colliders, and change nothing"
        }
        Activity::Broken => {
            "a defect of the engine ended a step of this world before its time: free the world"
        }
        _ => {
            "a query of this world is running: its callbacks may read the world, and not change it"
        }
    };
    Fault::new(Kind::Busy, what.to_string())
}

/// Returns the world for reading.
pub fn read(number: u32) -> Result<&'static PhysicsWorld, Fault> {
    let instance = instance(number)?;
    match instance.activity.get() {
        activity @ (Activity::Stepped | Activity::Broken) => Err(busy(activity)),
        // SAFETY: nothing changes the world: exported functions that read it end before others begin, or are
        // marked as queries.
        Activity::Idle | Activity::Read => Ok(unsafe { instance.world.get() }),
    }
}

/// Returns the world for changes.
pub fn write(number: u32) -> Result<&'static mut PhysicsWorld, Fault> {
    let instance = instance(number)?;
    let activity = instance.activity.get();
    if activity != Activity::Idle {
        return Err(busy(activity));
    }
    // SAFETY: the reference ends with the statement.
    unsafe { instance.queries.get() }.is_stale = true;
    // SAFETY: the reference ends with the statement.
    if let Some(mirror) = unsafe { instance.mirror.get() } {
        mirror.is_stale = true;
    }
    // SAFETY: no step or query is running, and an exported function borrows the world once at a time.
    Ok(unsafe { instance.world.get() })
}

/// Returns the bodies for reading, in hooks as well.
pub fn bodies(number: u32) -> Result<&'static RigidBodySet, Fault> {
    let instance = instance(number)?;
    if instance.activity.get() != Activity::Stepped {
        return Ok(&read(number)?.bodies);
    }
    // SAFETY: the hook stored the lent reference of the step, and clears it before it returns.
    unsafe { instance.sets.get().0.as_ref() }.ok_or_else(|| busy(Activity::Stepped))
}

/// Returns the colliders for reading, in hooks as well.
pub fn colliders(number: u32) -> Result<&'static ColliderSet, Fault> {
    let instance = instance(number)?;
    if instance.activity.get() != Activity::Stepped {
        return Ok(&read(number)?.colliders);
    }
    // SAFETY: the hook stored the lent reference of the step, and clears it before it returns.
    unsafe { instance.sets.get().1.as_ref() }.ok_or_else(|| busy(Activity::Stepped))
}

/// Returns a body for reading.
pub fn body(world: u32, handle: f64) -> Result<&'static RigidBody, Fault> {
    let found = bodies(world)?.get(RigidBodyHandle::of_number(handle));
    found.ok_or_else(|| Fault::stale("rigid body", handle))
}

/// Returns a body for changes.
pub fn body_mut(world: u32, handle: f64) -> Result<&'static mut RigidBody, Fault> {
    let found = write(world)?.bodies.get_mut(RigidBodyHandle::of_number(handle));
    found.ok_or_else(|| Fault::stale("rigid body", handle))
}

/// Returns a collider for reading.
pub fn collider(world: u32, handle: f64) -> Result<&'static Collider, Fault> {
    let found = colliders(world)?.get(ColliderHandle::of_number(handle));
    found.ok_or_else(|| Fault::stale("collider", handle))
}

/// Returns a collider for changes.
pub fn collider_mut(world: u32, handle: f64) -> Result<&'static mut Collider, Fault> {
    let found = write(world)?.colliders.get_mut(ColliderHandle::of_number(handle));
    found.ok_or_else(|| Fault::stale("collider", handle))
}
