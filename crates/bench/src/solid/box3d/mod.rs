//! Box3D, through the crate that builds it from its C sources.
//!
//! Box3D supports spheres, capsules, convex hulls (boxes are hulls) and meshes. Height fields become meshes.
//! A cylinder becomes a prism, and a half-space becomes a box as large as the scene.

mod joints;

use super::box_engines::{self, HALF_SPACE_EXTENT};
use super::ours::prelude::*;
use super::template::{DT, SUBSTEPS, Template};
use super::vector_of;
use crate::engine::{Counts, Engine, Probes, Stats, Unsupported};
use box3d_sys::*;

/// Limit of Box3D.
const HULL_VERTICES_MAX: usize = 128;

/// Corners of the prism that replaces a cylinder. Box3D has no cylinders.
const CYLINDER_SIDES: usize = 16;

/// World in Box3D.
pub struct Box3d<'t> {
    template: &'t Template,
    world: World,
    bodies: Vec<b3BodyId>,
    /// Meshes of the shapes. Shapes hold pointers to them, so the meshes are dropped after the world.
    _meshes: Vec<Mesh>,
}

/// Mesh that is destroyed when it is dropped.
struct Mesh(*mut b3MeshData);

impl Drop for Mesh {
    fn drop(&mut self) {
        // SAFETY: no pointer to the mesh is left; no other code destroys it.
        unsafe { b3DestroyMesh(self.0) };
    }
}

/// World that is destroyed when it is dropped.
struct World(b3WorldId);

impl Drop for World {
    fn drop(&mut self) {
        // SAFETY: the id is that of a live world, which no other code destroys.
        unsafe { b3DestroyWorld(self.0) };
    }
}

impl<'t> Box3d<'t> {
    /// Creates the scene at its start.
    pub fn new(template: &'t Template, threads: usize) -> Result<Self, Unsupported> {
        let world = create_world(template, threads);
        let mut meshes = Vec::new();
        let mut bodies = Vec::with_capacity(template.bodies.len());
        for (body, colliders) in template.parts() {
            let id = create_body(&world, body, template.lets_sleep(body))?;
            for collider in colliders {
                let local = collider.position_wrt_parent().copied().unwrap_or(Pose::IDENTITY);
                create_shape(id, collider, &local, &mut meshes)?;
            }
            // SAFETY: the body was created above.
            unsafe {
                b3Body_SetLinearVelocity(id, vector(body.linvel()));
                b3Body_SetAngularVelocity(id, vector(body.angvel()));
            }
            bodies.push(id);
        }
        // SAFETY: the definition is the default one, the world is live.
        let ground = unsafe { b3CreateBody(world.0, &b3DefaultBodyDef()) };
        for collider in template.loose_colliders() {
            create_shape(ground, collider, collider.position(), &mut meshes)?;
        }
        for (ends, joint) in &template.joints {
            joints::create(world.0, ends.map(|body| bodies[body]), joint)?;
        }
        Ok(Self { template, world, bodies, _meshes: meshes })
    }
}

impl Engine for Box3d<'_> {
    fn step(&mut self) {
        // SAFETY: the world is live.
        unsafe { b3World_Step(self.world.0, DT, SUBSTEPS as i32) };
    }

    fn counts(&self) -> Counts {
        // SAFETY: the world is live.
        let all = unsafe { b3World_GetCounters(self.world.0) }.bodyCount;
        box_engines::counts(all, &self.bodies, is_awake, count_contacts)
    }

    fn stats(&self) -> Stats {
        box_engines::stats(self.template, self.counts(), &self.bodies, pose, kinetic_energy)
    }

    /// Casts rays only: ball casts return `None`.
    fn cast(&self, probes: &Probes, radius: Option<f32>) -> Option<usize> {
        if radius.is_some() {
            return None;
        }
        // SAFETY: the call returns plain values.
        let filter = unsafe { b3DefaultQueryFilter() };
        let hits =
            probes.origins.iter().zip(&probes.directions).filter(|&(&origin, &direction)| {
                let (origin, translation) =
                    (vector(vector_of(origin)), vector(vector_of(direction) * probes.reach));
                // SAFETY: the world is live, all other arguments are values.
                unsafe { b3World_CastRayClosest(self.world.0, origin, translation, filter) }.hit
            });
        Some(hits.count())
    }

    fn foreign_bytes(&self) -> usize {
        // SAFETY: reads a counter. There is no other world of this engine at the time.
        let bytes = unsafe { b3GetByteCount() };
        // The counter has 32 bits and wraps around. Read as unsigned it is right up to 4 GiB; a million
        // sleeping bodies take three.
        bytes.cast_unsigned() as usize
    }
}

fn create_world(template: &Template, threads: usize) -> World {
    // SAFETY: the calls take and return plain values; the definition outlives them.
    unsafe {
        let mut definition = b3DefaultWorldDef();
        definition.gravity = vector(template.world.gravity);
        definition.enableSleep = template.rules.may_sleep;
        definition.enableContinuous = template.rules.is_continuous;
        definition.frictionCallback = Some(box_engines::average);
        definition.restitutionCallback = Some(box_engines::average);
        definition.workerCount = threads as u32;
        World(b3CreateWorld(&definition))
    }
}

fn create_body(world: &World, body: &RigidBody, may_sleep: bool) -> Result<b3BodyId, Unsupported> {
    box_engines::check_body(body)?;
    let axes = body.locked_axes();
    // SAFETY: the calls take and return plain values; the definition outlives them.
    unsafe {
        let mut definition = b3DefaultBodyDef();
        definition.type_ = match body.body_type() {
            RigidBodyType::Dynamic => b3BodyType_b3_dynamicBody,
            RigidBodyType::Fixed => b3BodyType_b3_staticBody,
            _ => b3BodyType_b3_kinematicBody,
        };
        definition.position = vector(body.translation());
        definition.rotation = quaternion(body.rotation());
        definition.linearDamping = body.linear_damping();
        definition.angularDamping = body.angular_damping();
        definition.gravityScale = body.gravity_scale();
        definition.enableSleep = may_sleep;
        definition.isEnabled = body.is_enabled();
        definition.motionLocks = b3MotionLocks {
            linearX: axes.contains(LockedAxes::TRANSLATION_LOCKED_X),
            linearY: axes.contains(LockedAxes::TRANSLATION_LOCKED_Y),
            linearZ: axes.contains(LockedAxes::TRANSLATION_LOCKED_Z),
            angularX: axes.contains(LockedAxes::ROTATION_LOCKED_X),
            angularY: axes.contains(LockedAxes::ROTATION_LOCKED_Y),
            angularZ: axes.contains(LockedAxes::ROTATION_LOCKED_Z),
        };
        Ok(b3CreateBody(world.0, &definition))
    }
}

fn create_shape(
    body: b3BodyId,
    collider: &Collider,
    local: &Pose,
    meshes: &mut Vec<Mesh>,
) -> Result<(), Unsupported> {
    let definition = shape_definition(collider)?;
    let at = |point: Vector| vector(*local * point);
    let mut add_mesh = |mesh: Mesh| {
        // SAFETY: the body is live; the mesh is kept until the world is gone.
        unsafe { b3CreateMeshShape(body, &definition, mesh.0, vector(Vector::ONE)) };
        meshes.push(mesh);
    };
    // SAFETY: the body is live, definitions and geometry outlive the calls, which copy them.
    unsafe {
        match collider.shape().as_typed_shape() {
            TypedShape::Ball(ball) => {
                let sphere = b3Sphere { center: at(Vector::ZERO), radius: ball.radius };
                b3CreateSphereShape(body, &definition, &sphere);
            }
            TypedShape::Capsule(capsule) => {
                let (a, b) = (capsule.segment.a, capsule.segment.b);
                let capsule = b3Capsule { center1: at(a), center2: at(b), radius: capsule.radius };
                b3CreateCapsuleShape(body, &definition, &capsule);
            }
            TypedShape::Cuboid(cuboid) => {
                let half = cuboid.half_extents;
                let frame =
                    b3Transform { p: vector(local.translation), q: quaternion(&local.rotation) };
                let hull = b3MakeTransformedBoxHull(half.x, half.y, half.z, frame);
                b3CreateHullShape(body, &definition, &hull.base);
            }
            TypedShape::ConvexPolyhedron(polyhedron) => {
                let points: Vec<b3Vec3> = polyhedron.points().iter().map(|&p| at(p)).collect();
                if points.len() > HULL_VERTICES_MAX {
                    return Err(Unsupported::because("a hull has too many vertices"));
                }
                create_hull(body, &definition, &points)?;
            }
            TypedShape::Cylinder(cylinder) => {
                let sides: Vec<b3Vec3> = prism(cylinder).map(at).collect();
                create_hull(body, &definition, &sides)?;
            }
            TypedShape::HalfSpace(half_space) => {
                let turn = Rotation::from_rotation_arc(Vector::Y, half_space.normal);
                let frame = b3Transform {
                    p: at(half_space.normal * -HALF_SPACE_EXTENT),
                    q: quaternion(&(local.rotation * turn)),
                };
                let [x, y, z] = [HALF_SPACE_EXTENT; 3];
                let hull = b3MakeTransformedBoxHull(x, y, z, frame);
                b3CreateHullShape(body, &definition, &hull.base);
            }
            TypedShape::HeightField(field) => {
                let (vertices, triangles) = field.to_trimesh();
                add_mesh(create_mesh(&vertices, &triangles, local)?);
            }
            TypedShape::TriMesh(mesh) => {
                add_mesh(create_mesh(mesh.vertices(), mesh.indices(), local)?);
            }
            _ => return Err(box_engines::unknown_shape(collider)),
        }
    }
    Ok(())
}

/// Returns the corners of the prism that replaces a cylinder.
fn prism(cylinder: &Cylinder) -> impl Iterator<Item = Vector> {
    (0..2 * CYLINDER_SIDES).map(|k| {
        let angle = (k / 2) as f32 / CYLINDER_SIDES as f32 * std::f32::consts::TAU;
        let height = cylinder.half_height * if k % 2 == 0 { 1.0 } else { -1.0 };
        Vector::new(angle.cos() * cylinder.radius, height, angle.sin() * cylinder.radius)
    })
}

/// # Safety
/// The body must be live.
unsafe fn create_hull(
    body: b3BodyId,
    definition: &b3ShapeDef,
    points: &[b3Vec3],
) -> Result<(), Unsupported> {
    // SAFETY: the caller's contract; definitions and geometry outlive the calls, which copy them.
    unsafe {
        let hull = b3CreateHull(points.as_ptr(), points.len() as i32, points.len() as i32);
        if hull.is_null() {
            return Err(Unsupported::because("it refuses a hull"));
        }
        b3CreateHullShape(body, definition, hull);
        b3DestroyHull(hull);
    }
    Ok(())
}

/// Creates a mesh with marked edges, so that bodies do not catch on the edges between coplanar triangles.
fn create_mesh(
    vertices: &[Vector],
    triangles: &[[u32; 3]],
    local: &Pose,
) -> Result<Mesh, Unsupported> {
    let mut vertices: Vec<b3Vec3> = vertices.iter().map(|&v| vector(*local * v)).collect();
    let mut indices: Vec<i32> = triangles.iter().flatten().map(|&index| index as i32).collect();
    let definition = b3MeshDef {
        vertices: vertices.as_mut_ptr(),
        indices: indices.as_mut_ptr(),
        materialIndices: core::ptr::null_mut(),
        weldTolerance: 0.0,
        vertexCount: vertices.len() as i32,
        triangleCount: triangles.len() as i32,
        weldVertices: false,
        useMedianSplit: false,
        identifyEdges: true,
    };
    // SAFETY: the definition and its pointers outlive the call, which copies them.
    let mesh = unsafe { b3CreateMesh(&definition, core::ptr::null_mut(), 0) };
    if mesh.is_null() { Err(Unsupported::because("it refuses a mesh")) } else { Ok(Mesh(mesh)) }
}

fn shape_definition(collider: &Collider) -> Result<b3ShapeDef, Unsupported> {
    box_engines::check_collider(collider)?;
    let groups = collider.collision_groups();
    // SAFETY: the call returns plain values.
    let mut definition = unsafe { b3DefaultShapeDef() };
    definition.density = box_engines::density(collider);
    definition.baseMaterial.friction = collider.friction();
    definition.baseMaterial.restitution = collider.restitution();
    definition.filter.categoryBits = groups.memberships.bits().into();
    definition.filter.maskBits = groups.filter.bits().into();
    definition.isSensor = collider.is_sensor();
    Ok(definition)
}

/// Returns whether the body is dynamic and awake.
fn is_awake(body: b3BodyId) -> bool {
    // SAFETY: the body is live; the calls return plain values.
    unsafe { b3Body_GetType(body) == b3BodyType_b3_dynamicBody && b3Body_IsAwake(body) }
}

/// Counts the touching pairs with the body in first place, and their points.
fn count_contacts(body: b3BodyId) -> (usize, usize) {
    let mut counts = (0, 0);
    // SAFETY: the body is live; the second call returns the number of initialised contacts; their manifolds
    // stay valid until the next step.
    unsafe {
        let capacity = b3Body_GetContactCapacity(body);
        let mut contacts: Vec<b3ContactData> = Vec::with_capacity(capacity as usize);
        let count = b3Body_GetContactData(body, contacts.as_mut_ptr(), capacity);
        contacts.set_len(count as usize);
        for contact in contacts {
            if b3Shape_GetBody(contact.shapeIdA).index1 == body.index1 {
                let count = contact.manifoldCount as usize;
                let manifolds = std::slice::from_raw_parts(contact.manifolds, count);
                counts.0 += 1;
                counts.1 += manifolds.iter().map(|m| m.pointCount as usize).sum::<usize>();
            }
        }
    }
    counts
}

fn pose(body: b3BodyId) -> Pose {
    // SAFETY: the body is live; the calls return plain values.
    let (p, q) = unsafe { (b3Body_GetPosition(body), b3Body_GetRotation(body)) };
    let rotation = Rotation::from_xyzw(q.v.x, q.v.y, q.v.z, q.s);
    Pose::from_parts(Vector::new(p.x, p.y, p.z), rotation)
}

fn kinetic_energy(body: b3BodyId) -> f64 {
    // SAFETY: the body is live; the calls take and return plain values.
    let (kind, mass, inertia, linear, angular, rotation) = unsafe {
        (
            b3Body_GetType(body),
            b3Body_GetMass(body),
            b3Body_GetLocalRotationalInertia(body),
            b3Body_GetLinearVelocity(body),
            b3Body_GetAngularVelocity(body),
            b3Body_GetRotation(body),
        )
    };
    if kind != b3BodyType_b3_dynamicBody {
        return 0.0;
    }
    let back = |v: b3Vec3| Vector::new(v.x, v.y, v.z);
    let rotation = Rotation::from_xyzw(rotation.v.x, rotation.v.y, rotation.v.z, rotation.s);
    let local = rotation.inverse() * back(angular);
    let momentum =
        back(inertia.cx) * local.x + back(inertia.cy) * local.y + back(inertia.cz) * local.z;
    0.5 * f64::from(mass * back(linear).length_squared() + momentum.dot(local))
}

fn vector(v: Vector) -> b3Vec3 {
    b3Vec3 { x: v.x, y: v.y, z: v.z }
}

fn quaternion(rotation: &Rotation) -> b3Quat {
    b3Quat { v: b3Vec3 { x: rotation.x, y: rotation.y, z: rotation.z }, s: rotation.w }
}
