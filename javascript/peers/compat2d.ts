// A program written for @dimforge/rapier2d-compat. It type-checks and runs with that package and with ours:
// only the import differs.

import RAPIER, { type Collider, type RigidBody, Vector2 } from "rapier";

/** Checks a condition of the program. */
function check(condition: boolean, what: string): void {
    if (!condition) {
        throw new Error(`not so: ${what}`);
    }
}

const near = (actual: number, expected: number, tolerance: number) => Math.abs(actual - expected) <= tolerance;
const zero = { x: 0, y: 0 };
const identity: RAPIER.Rotation = RAPIER.RotationOps.identity();

function bodies(world: RAPIER.World): RigidBody {
    const desc = RAPIER.RigidBodyDesc.dynamic()
        .setTranslation(0, 5)
        .setRotation(0)
        .setLinvel(0, 0)
        .setAngvel(1)
        .setGravityScale(1)
        .setLinearDamping(0.1)
        .setAngularDamping(0.1)
        .setCanSleep(true)
        .setSleeping(false)
        .setCcdEnabled(true)
        .setSoftCcdPrediction(0)
        .setDominanceGroup(0)
        .setAdditionalSolverIterations(1)
        .setAdditionalMass(0.5)
        .enabledTranslations(true, true)
        .setEnabled(true)
        .setUserData({ name: "player" });
    const body: RAPIER.RigidBody = world.createRigidBody(desc);
    const handle: RAPIER.RigidBodyHandle = body.handle;
    check(world.getRigidBody(handle) === body, "a body is found by its handle");
    check((body.userData as { name: string }).name === "player", "user data stays");
    body.setTranslation({ x: 1, y: 5 }, true);
    const target = new RAPIER.Vector2(0, 0);
    check(body.translation(target) === target && target.x === 1, "targets are filled");
    body.setRotation(identity, true);
    const rotation: RAPIER.Rotation = body.rotation();
    check(near(rotation, 0, 1e-6), "the rotation is set");
    body.setLinvel({ x: 1, y: 0 }, true);
    body.setAngvel(0, true);
    check(near(body.velocityAtPoint({ x: 1, y: 6 }).x, 1, 1e-5), "points have velocities");
    body.lockRotations(false, true);
    body.lockTranslations(false, true);
    body.setEnabledTranslations(true, true, true);
    body.enableCcd(false);
    body.setGravityScale(1, true);
    body.setLinearDamping(0);
    body.setAngularDamping(0);
    body.setDominanceGroup(1);
    check(body.dominanceGroup() === 1, "the dominance group is set");
    body.addForce({ x: 0, y: 1 }, true);
    body.addTorque(0, true);
    body.addForceAtPoint(zero, zero, true);
    check(near(body.userForce().y, 1, 1e-6), "forces add up");
    body.resetForces(true);
    body.resetTorques(true);
    body.applyImpulse(zero, true);
    body.applyTorqueImpulse(0, true);
    body.applyImpulseAtPoint(zero, zero, true);
    body.setAdditionalMass(1, true);
    body.setAdditionalMassProperties(1, zero, 1, true);
    check(body.isDynamic() && !body.isFixed() && !body.isKinematic(), "the body is dynamic");
    check(body.bodyType() === RAPIER.RigidBodyType.Dynamic, "the type of a body");
    body.sleep();
    check(body.isSleeping(), "the body sleeps");
    body.wakeUp();
    check(body.isEnabled() && body.isValid() && !body.isCcdEnabled(), "the body's state");
    return body;
}

function colliders(world: RAPIER.World, body: RigidBody): Collider {
    const points = new Float32Array([0, 0, 1, 0, 1, 1, 0, 1]);
    const triangles = new Uint32Array([0, 1, 2, 0, 2, 3]);
    const descs: (RAPIER.ColliderDesc | null)[] = [
        RAPIER.ColliderDesc.ball(0.5),
        RAPIER.ColliderDesc.cuboid(0.5, 0.5),
        RAPIER.ColliderDesc.roundCuboid(0.5, 0.5, 0.1),
        RAPIER.ColliderDesc.capsule(0.5, 0.25),
        RAPIER.ColliderDesc.segment(zero, { x: 1, y: 0 }),
        RAPIER.ColliderDesc.triangle(zero, { x: 1, y: 0 }, { x: 0, y: 1 }),
        RAPIER.ColliderDesc.polyline(points, null),
        RAPIER.ColliderDesc.trimesh(points, triangles),
        RAPIER.ColliderDesc.convexHull(points),
        RAPIER.ColliderDesc.convexPolyline(points),
        RAPIER.ColliderDesc.halfspace({ x: 0, y: 1 }),
        RAPIER.ColliderDesc.roundConvexHull(points, 0.1),
        RAPIER.ColliderDesc.heightfield(new Float32Array([0, 1, 0, 1]), { x: 4, y: 1 }),
        RAPIER.ColliderDesc.compound([new RAPIER.Ball(0.5), new RAPIER.Cuboid(1, 1)], [zero, { x: 2, y: 0 }], [identity, identity]),
        RAPIER.ColliderDesc.voxels(new Int32Array([0, 0, 1, 0]), { x: 1, y: 1 }),
    ];
    for (const desc of descs) {
        check(desc !== null, "shapes are made");
        const collider = world.createCollider(desc!.setTranslation(100, 0).setSensor(true));
        check(collider.isValid() && collider.isSensor(), "the collider is a sensor");
        check(collider.shape.type === collider.shapeType(), "shapes know their type");
        world.removeCollider(collider, false);
    }
    const desc = RAPIER.ColliderDesc.ball(0.5)
        .setDensity(1)
        .setFriction(0.5)
        .setRestitution(0.1)
        .setFrictionCombineRule(RAPIER.CoefficientCombineRule.Average)
        .setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Max)
        .setCollisionGroups(0xffffffff)
        .setSolverGroups(0xffffffff)
        .setActiveEvents(RAPIER.ActiveEvents.COLLISION_EVENTS | RAPIER.ActiveEvents.CONTACT_FORCE_EVENTS)
        .setActiveHooks(RAPIER.ActiveHooks.FILTER_CONTACT_PAIRS)
        .setActiveCollisionTypes(RAPIER.ActiveCollisionTypes.DEFAULT)
        .setContactForceEventThreshold(0)
        .setContactSkin(0);
    const collider = world.createCollider(desc, body);
    check(collider.parent() === body && body.numColliders() === 1 && body.collider(0) === collider, "the collider has a body");
    collider.setRadius(0.5);
    check(near(collider.radius(), 0.5, 1e-6) && near(collider.volume(), 0.7854, 1e-2), "the sizes of a ball");
    collider.setFriction(0.6);
    collider.setRestitution(0.2);
    check(near(collider.friction(), 0.6, 1e-6) && near(collider.restitution(), 0.2, 1e-6), "the material");
    collider.setTranslationWrtParent(zero);
    check(collider.translationWrtParent() !== null, "the offset of a collider");
    check(collider.containsPoint(body.translation()), "points in colliders");
    return collider;
}

function joints(world: RAPIER.World): void {
    const make = (x: number) => world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(x, 20).setAdditionalMass(1));
    const [one, other] = [make(50), make(51)];
    const axis = { x: 0, y: 1 };
    const half = { x: 0.5, y: 0 };
    const minus = { x: -0.5, y: 0 };
    const data: RAPIER.JointData[] = [
        RAPIER.JointData.fixed(half, identity, minus, identity),
        RAPIER.JointData.revolute(half, minus),
        RAPIER.JointData.prismatic(half, minus, axis),
        RAPIER.JointData.rope(2, half, minus),
        RAPIER.JointData.spring(1, 10, 1, half, minus),
    ];
    for (const params of data) {
        const joint = world.createImpulseJoint(params, one, other, true);
        check(joint.isValid() && joint.body1() === one && joint.body2() === other, "the bodies of a joint");
        joint.setContactsEnabled(false);
        check(!joint.contactsEnabled(), "contacts of joined bodies");
        if (joint instanceof RAPIER.RevoluteImpulseJoint || joint instanceof RAPIER.PrismaticImpulseJoint) {
            const unit = joint as RAPIER.UnitImpulseJoint;
            unit.setLimits(-1, 1);
            check(unit.limitsEnabled() && near(unit.limitsMin(), -1, 1e-6) && near(unit.limitsMax(), 1, 1e-6), "limits");
            unit.configureMotorModel(RAPIER.MotorModel.ForceBased);
            unit.configureMotorVelocity(1, 1);
            unit.configureMotorPosition(0, 1, 1);
            unit.configureMotor(0, 0, 1, 1);
        }
        world.step();
        world.removeImpulseJoint(joint, true);
    }
    const link = world.createMultibodyJoint(RAPIER.JointData.revolute(half, minus), one, other, true);
    check(link.isValid() && world.multibodyJoints.len() === 1, "multibody joints");
    world.step();
    world.removeMultibodyJoint(link, true);
    world.removeRigidBody(one);
    world.removeRigidBody(other);
}

function queries(world: RAPIER.World, body: RigidBody, collider: Collider): void {
    const { x, y } = body.translation();
    const ray = new RAPIER.Ray({ x, y: y + 5 }, { x: 0, y: -1 });
    const hit: RAPIER.RayColliderHit | null = world.castRay(ray, 100, true);
    check(hit?.collider === collider && near(hit.timeOfImpact, 4.5, 1e-2), "a ray hits");
    check(near(ray.pointAt(hit!.timeOfImpact).y, y + 0.5, 1e-2), "the point of a ray");
    const normal = world.castRayAndGetNormal(ray, 100, true, RAPIER.QueryFilterFlags.EXCLUDE_SENSORS, undefined, undefined, undefined, (c) => c.isValid());
    check(near(normal!.normal.y, 1, 1e-2), "a ray has a normal");
    check(world.castRay(ray, 100, true, undefined, undefined, collider, body)?.collider !== collider, "excluded colliders");
    let count = 0;
    world.intersectionsWithRay(ray, 100, true, () => ++count > 0);
    world.intersectionsWithPoint({ x, y }, (found) => found !== collider);
    world.intersectionsWithShape({ x, y }, identity, new RAPIER.Ball(1), () => ++count > 0);
    world.collidersWithAabbIntersectingAabb({ x, y }, { x: 1, y: 1 }, () => ++count > 0);
    check(count >= 3, "intersections");
    check(world.projectPoint({ x, y: y + 3 }, true)?.collider === collider, "projections");
    check(world.projectPointAndGetFeature({ x, y: y + 3 }) !== null, "projections with features");
    check(world.intersectionWithShape({ x, y }, identity, new RAPIER.Ball(0.1)) !== null, "a shape intersects");
    const cast = world.castShape({ x, y: y + 5 }, identity, { x: 0, y: -1 }, new RAPIER.Ball(0.5), 0, 100, true);
    check(cast?.collider === collider && near(cast.time_of_impact, 4, 0.05), "a shape is cast");
}

function steps(world: RAPIER.World, body: RigidBody, ground: Collider, collider: Collider): void {
    const queue = new RAPIER.EventQueue(true);
    const hooks: RAPIER.PhysicsHooks = {
        filterContactPair: (_c1, _c2, _b1, _b2) => RAPIER.SolverFlags.COMPUTE_IMPULSE,
        filterIntersectionPair: () => true,
    };
    let [started, force] = [0, 0];
    for (let step = 0; step < 120; step += 1) {
        world.step(queue, hooks);
        queue.drainCollisionEvents((_one, _other, begins) => (started += Number(begins)));
        queue.drainContactForceEvents((event) => (force = Math.max(force, event.totalForceMagnitude())));
    }
    check(started > 0 && force > 0, "events");
    check(near(body.translation().y, 0.5, 0.05), "the ball lies on the ground");
    let contacts = 0;
    world.contactPair(ground, collider, (manifold, flipped) => {
        contacts += manifold.numContacts();
        check(near(Math.abs(manifold.normal().y), 1, 1e-2) && typeof flipped === "boolean", "the normal of a contact");
    });
    check(contacts > 0, "contacts");
    world.contactPairsWith(collider, (other) => check(other === ground, "the partner of a contact"));
    queue.clear();
    queue.free();
}

function controllers(world: RAPIER.World): void {
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicPositionBased().setTranslation(-10, 1.02));
    const collider = world.createCollider(RAPIER.ColliderDesc.capsule(0.5, 0.5), body);
    world.step();
    const character = world.createCharacterController(0.02);
    character.setUp({ x: 0, y: 1 });
    character.enableAutostep(0.3, 0.1, true);
    character.enableSnapToGround(0.2);
    character.setApplyImpulsesToDynamicBodies(true);
    character.setMaxSlopeClimbAngle(Math.PI / 4);
    character.computeColliderMovement(collider, { x: 0.1, y: -0.1 });
    check(near(character.computedMovement().x, 0.1, 0.02) && character.computedGrounded(), "a character moves");
    world.removeCharacterController(character);

    const pid = world.createPidController(10, 0, 1, RAPIER.PidAxesMask.All);
    const held = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(-20, 10).setAdditionalMass(1));
    pid.applyLinearCorrection(held, { x: -20, y: 11 }, zero);
    check(held.linvel().y > 0, "a PID controller corrects");
    world.removePidController(pid);
}

/** Runs the program. */
export async function run(): Promise<string> {
    await RAPIER.init();
    const world = new RAPIER.World({ x: 0, y: -9.81 });
    world.timestep = 1 / 60;
    world.numSolverIterations = 4;
    world.integrationParameters.lengthUnit = 1;
    const floor = world.createRigidBody(RAPIER.RigidBodyDesc.fixed().setTranslation(0, -1));
    const ground = world.createCollider(RAPIER.ColliderDesc.cuboid(100, 1), floor);
    const body = bodies(world);
    const collider = colliders(world, body);
    world.step();
    queries(world, body, collider);
    body.setLinvel(zero, true);
    steps(world, body, ground, collider);
    joints(world);
    controllers(world);
    const buffers = world.debugRender();
    check(buffers.vertices.length > 0 && buffers.colors.length > 0, "debug lines");
    const snapshot: Uint8Array = world.takeSnapshot();
    const copy = RAPIER.World.restoreSnapshot(snapshot);
    check(copy!.bodies.len() === world.bodies.len(), "snapshots");
    copy!.free();
    let count = 0;
    world.forEachRigidBody(() => (count += 1));
    world.forEachCollider(() => (count += 1));
    world.forEachActiveRigidBody(() => (count += 1));
    check(count > 2, "all bodies and colliders");
    world.removeRigidBody(body);
    check(!world.bodies.contains(body.handle), "a removed body");
    world.propagateModifiedBodyPositionsToColliders();
    world.free();
    return RAPIER.version();
}
