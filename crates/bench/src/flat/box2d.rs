//! Box2D, through the crate that builds it from its C sources.
//!
//! Box2D supports circles, capsules, convex polygons of up to 8 corners with or without a round rim, and
//! chains of segments. Height fields become chains. A half-space becomes a box as large as the scene. The
//! benchmark transcribes no other shapes.

use super::box_engines::{self, HALF_SPACE_EXTENT};
use super::ours::prelude::*;
use super::template::{DT, SUBSTEPS, Template};
use crate::engine::{Counts, Engine, Stats, Template as _, Unsupported};
use boxdd_sys::ffi::*;

/// Limit of Box2D.
const POLYGON_VERTICES_MAX: usize = 8;
/// Limit of Box2D: it divides the awake bodies into four blocks per thread and counts the bodies of a block
/// in 16 bits. Larger numbers end the process.
const AWAKE_PER_THREAD: usize = 4 * u16::MAX as usize;

/// World in Box2D.
pub struct Box2d<'t> {
    template: &'t Template,
    world: World,
    bodies: Vec<b2BodyId>,
}

/// World that is destroyed when it is dropped.
struct World(b2WorldId);

impl Drop for World {
    fn drop(&mut self) {
        // SAFETY: the id is that of a live world, which no other code destroys.
        unsafe { b2DestroyWorld(self.0) };
    }
}

impl<'t> Box2d<'t> {
    /// Creates the scene at its start.
    pub fn new(template: &'t Template, threads: usize) -> Result<Self, Unsupported> {
        let most = AWAKE_PER_THREAD * threads;
        if template.dynamic_bodies() > most {
            return Err(Unsupported::because(format!("no more than {most} bodies can be awake")));
        }
        let world = create_world(template, threads);
        let mut bodies = Vec::with_capacity(template.bodies.len());
        for (body, colliders) in template.parts() {
            let id = create_body(&world, body, template.lets_sleep(body))?;
            for collider in colliders {
                let local = collider.position_wrt_parent().copied().unwrap_or(Pose::IDENTITY);
                create_shape(id, collider, &local)?;
            }
            // SAFETY: the body was created above.
            unsafe {
                b2Body_SetLinearVelocity(id, vector(body.linvel()));
                b2Body_SetAngularVelocity(id, body.angvel());
            }
            bodies.push(id);
        }
        // SAFETY: the definition is the default one, the world is live.
        let ground = unsafe { b2CreateBody(world.0, &b2DefaultBodyDef()) };
        for collider in template.loose_colliders() {
            create_shape(ground, collider, collider.position())?;
        }
        for (ends, joint) in &template.joints {
            create_joint(&world, ends.map(|body| bodies[body]), joint)?;
        }
        Ok(Self { template, world, bodies })
    }
}

impl Engine for Box2d<'_> {
    fn step(&mut self) {
        // SAFETY: the world is live.
        unsafe { b2World_Step(self.world.0, DT, SUBSTEPS as i32) };
    }

    fn counts(&self) -> Counts {
        // SAFETY: the world is live.
        let all = unsafe { b2World_GetCounters(self.world.0) }.bodyCount;
        box_engines::counts(all, &self.bodies, is_awake, count_contacts)
    }

    fn stats(&self) -> Stats {
        box_engines::stats(self.template, self.counts(), &self.bodies, pose, kinetic_energy)
    }

    fn foreign_bytes(&self) -> usize {
        // SAFETY: reads a counter. There is no other world of this engine at the time.
        usize::try_from(unsafe { b2GetByteCount() }).unwrap_or(0)
    }
}

fn create_world(template: &Template, threads: usize) -> World {
    // SAFETY: the calls take and return plain values; the definition outlives them.
    unsafe {
        let mut definition = b2DefaultWorldDef();
        definition.gravity = vector(template.world.gravity);
        definition.enableSleep = template.rules.may_sleep;
        definition.enableContinuous = template.rules.is_continuous;
        definition.frictionCallback = Some(box_engines::average);
        definition.restitutionCallback = Some(box_engines::average);
        definition.workerCount = threads as i32;
        World(b2CreateWorld(&definition))
    }
}

fn create_body(world: &World, body: &RigidBody, may_sleep: bool) -> Result<b2BodyId, Unsupported> {
    box_engines::check_body(body)?;
    let axes = body.locked_axes();
    // SAFETY: the calls take and return plain values; the definition outlives them.
    unsafe {
        let mut definition = b2DefaultBodyDef();
        definition.type_ = match body.body_type() {
            RigidBodyType::Dynamic => b2BodyType_b2_dynamicBody,
            RigidBodyType::Fixed => b2BodyType_b2_staticBody,
            _ => b2BodyType_b2_kinematicBody,
        };
        definition.position = vector(body.translation());
        definition.rotation = rotation(body.rotation());
        definition.linearDamping = body.linear_damping();
        definition.angularDamping = body.angular_damping();
        definition.gravityScale = body.gravity_scale();
        definition.enableSleep = may_sleep;
        definition.isEnabled = body.is_enabled();
        definition.motionLocks = b2MotionLocks {
            linearX: axes.contains(LockedAxes::TRANSLATION_LOCKED_X),
            linearY: axes.contains(LockedAxes::TRANSLATION_LOCKED_Y),
            angularZ: axes.contains(LockedAxes::ROTATION_LOCKED_Z),
        };
        Ok(b2CreateBody(world.0, &definition))
    }
}

fn create_shape(body: b2BodyId, collider: &Collider, local: &Pose) -> Result<(), Unsupported> {
    let definition = shape_definition(collider)?;
    let at = |point: Vector| vector(*local * point);
    let (center, turn) = (vector(local.translation), rotation(&local.rotation));
    // SAFETY: the body is live, definitions and geometry outlive the calls, which copy them.
    unsafe {
        match collider.shape().as_typed_shape() {
            TypedShape::Ball(ball) => {
                let circle = b2Circle { center, radius: ball.radius };
                b2CreateCircleShape(body, &definition, &circle);
            }
            TypedShape::Capsule(capsule) => {
                let (a, b) = (capsule.segment.a, capsule.segment.b);
                let capsule = b2Capsule { center1: at(a), center2: at(b), radius: capsule.radius };
                b2CreateCapsuleShape(body, &definition, &capsule);
            }
            TypedShape::Cuboid(cuboid) => {
                let half = cuboid.half_extents;
                let polygon = b2MakeOffsetBox(half.x, half.y, center, turn);
                b2CreatePolygonShape(body, &definition, &polygon);
            }
            TypedShape::RoundCuboid(round) => {
                let half = round.inner_shape.half_extents;
                let radius = round.border_radius;
                let polygon = b2MakeOffsetRoundedBox(half.x, half.y, center, turn, radius);
                b2CreatePolygonShape(body, &definition, &polygon);
            }
            TypedShape::HalfSpace(half_space) => {
                let up = half_space.normal;
                let turn = Rotation { re: up.y, im: -up.x };
                let polygon = b2MakeOffsetBox(
                    HALF_SPACE_EXTENT,
                    HALF_SPACE_EXTENT,
                    at(up * -HALF_SPACE_EXTENT),
                    rotation(&(local.rotation * turn)),
                );
                b2CreatePolygonShape(body, &definition, &polygon);
            }
            TypedShape::HeightField(field) => create_chain(body, &definition, field, &at),
            TypedShape::ConvexPolygon(polygon) => {
                let points: Vec<b2Vec2> = polygon.points().iter().map(|&p| at(p)).collect();
                if points.len() > POLYGON_VERTICES_MAX {
                    return Err(Unsupported::because("a polygon has too many corners"));
                }
                let hull = b2ComputeHull(points.as_ptr(), points.len() as i32);
                if hull.count == 0 {
                    return Err(Unsupported::because("it refuses a polygon"));
                }
                let polygon = b2MakePolygon(&hull, 0.0);
                b2CreatePolygonShape(body, &definition, &polygon);
            }
            _ => return Err(box_engines::unknown_shape(collider)),
        }
    }
    Ok(())
}

/// Creates the surface of a height field, solid from above.
///
/// # Safety
/// The body must be live.
unsafe fn create_chain(
    body: b2BodyId,
    shape: &b2ShapeDef,
    field: &HeightField,
    at: &impl Fn(Vector) -> b2Vec2,
) {
    // Box2D treats the right side of the point sequence as the outside. The first and the last segment are
    // not solid.
    let mut points: Vec<Vector> =
        field.segments().next().map(|first| first.a).into_iter().collect();
    points.extend(field.segments().map(|segment| segment.b));
    points.reverse();
    if let [first, .., last] = points[..] {
        points.insert(0, first + Vector::X);
        points.push(last - Vector::X);
    }
    let points: Vec<b2Vec2> = points.into_iter().map(at).collect();
    // SAFETY: the caller's contract; the definition and its pointers outlive the call, which copies them.
    unsafe {
        let mut definition = b2DefaultChainDef();
        definition.points = points.as_ptr();
        definition.count = points.len() as i32;
        definition.materials = &shape.material;
        definition.materialCount = 1;
        definition.filter = shape.filter;
        b2CreateChain(body, &definition);
    }
}

fn shape_definition(collider: &Collider) -> Result<b2ShapeDef, Unsupported> {
    box_engines::check_collider(collider)?;
    let groups = collider.collision_groups();
    // SAFETY: the call returns plain values.
    let mut definition = unsafe { b2DefaultShapeDef() };
    definition.density = box_engines::density(collider);
    definition.material.friction = collider.friction();
    definition.material.restitution = collider.restitution();
    definition.filter.categoryBits = groups.memberships.bits().into();
    definition.filter.maskBits = groups.filter.bits().into();
    definition.isSensor = collider.is_sensor();
    Ok(definition)
}

/// Creates a hinge: no scene here has other joints, motors or springs.
fn create_joint(
    world: &World,
    bodies: [b2BodyId; 2],
    joint: &GenericJoint,
) -> Result<(), Unsupported> {
    if joint.locked_axes != JointAxesMask::LOCKED_REVOLUTE_AXES
        || !joint.motor_axes.is_empty()
        || joint.softness.is_some()
    {
        return Err(Unsupported::because("a joint is not transcribed"));
    }
    let frame =
        |pose: &Pose| b2Transform { p: vector(pose.translation), q: rotation(&pose.rotation) };
    // SAFETY: the calls take and return plain values. The definition outlives them. The world and the bodies
    // are live.
    unsafe {
        let mut definition = b2DefaultRevoluteJointDef();
        [definition.base.bodyIdA, definition.base.bodyIdB] = bodies;
        definition.base.localFrameA = frame(&joint.local_frame1);
        definition.base.localFrameB = frame(&joint.local_frame2);
        definition.base.collideConnected = joint.contacts_enabled;
        if let Some(limits) = joint.limits(JointAxis::AngX) {
            definition.enableLimit = true;
            (definition.lowerAngle, definition.upperAngle) = (limits.min, limits.max);
        }
        b2CreateRevoluteJoint(world.0, &definition);
    }
    Ok(())
}

/// Returns whether the body is dynamic and awake.
fn is_awake(body: b2BodyId) -> bool {
    // SAFETY: the body is live; the calls return plain values.
    unsafe { b2Body_GetType(body) == b2BodyType_b2_dynamicBody && b2Body_IsAwake(body) }
}

/// Counts the touching pairs with the body in first place, and their points.
fn count_contacts(body: b2BodyId) -> (usize, usize) {
    let mut counts = (0, 0);
    // SAFETY: the body is live; the second call returns the number of initialised contacts.
    unsafe {
        let capacity = b2Body_GetContactCapacity(body);
        let mut contacts: Vec<b2ContactData> = Vec::with_capacity(capacity as usize);
        let count = b2Body_GetContactData(body, contacts.as_mut_ptr(), capacity);
        contacts.set_len(count as usize);
        for contact in contacts {
            if b2Shape_GetBody(contact.shapeIdA).index1 == body.index1 {
                counts.0 += 1;
                counts.1 += contact.manifold.pointCount as usize;
            }
        }
    }
    counts
}

fn pose(body: b2BodyId) -> Pose {
    // SAFETY: the body is live; the calls return plain values.
    let (p, q) = unsafe { (b2Body_GetPosition(body), b2Body_GetRotation(body)) };
    let rotation = Rotation { re: q.c, im: q.s };
    Pose::from_parts(Vector::new(p.x, p.y), rotation)
}

fn kinetic_energy(body: b2BodyId) -> f64 {
    // SAFETY: the body is live; the calls take and return plain values.
    let (kind, mass, inertia, linear, angular) = unsafe {
        (
            b2Body_GetType(body),
            b2Body_GetMass(body),
            b2Body_GetRotationalInertia(body),
            b2Body_GetLinearVelocity(body),
            b2Body_GetAngularVelocity(body),
        )
    };
    if kind != b2BodyType_b2_dynamicBody {
        return 0.0;
    }
    let speed_squared = linear.x * linear.x + linear.y * linear.y;
    0.5 * f64::from(mass * speed_squared + inertia * angular * angular)
}

fn vector(v: Vector) -> b2Vec2 {
    b2Vec2 { x: v.x, y: v.y }
}

fn rotation(rotation: &Rotation) -> b2Rot {
    b2Rot { c: rotation.re, s: rotation.im }
}
