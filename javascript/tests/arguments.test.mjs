// Arguments of the wrong kind: a RapierError that names the argument and the value, and a world that continues.
// Handles take the place of objects.

import assert from "node:assert/strict";
import test from "node:test";
import { DIM, RAPIER, box, fails, insert, makeGround, makeWorld, steps, v } from "./setup.mjs";

const zero = v(0, 0);
const none = DIM === 2 ? 0 : { x: 0, y: 0, z: 0, w: 1 };
const hinge = () => (DIM === 2 ? RAPIER.JointData.revolute(zero, v(0, 1)) : RAPIER.JointData.spherical(zero, v(0, 1)));

/** A world with the things that the calls need. */
function scene() {
    const { world, ground, collider: floor } = makeGround();
    const [one, other] = [insert(world, 0, 5, box(0.5, 0.5)), insert(world, 3, 5, box(0.5, 0.5))];
    const joint = world.createImpulseJoint(hinge(), one.body, other.body, true);
    return {
        world, ground, floor, body: one.body, other: other.body, collider: one.collider, collider2: other.collider, joint,
        character: world.createCharacterController(0.1), pid: world.createPidController(1, 0, 0, RAPIER.PidAxesMask.All),
        ray: new RAPIER.Ray(v(0, 9), v(0, -1)), ball: new RAPIER.Ball(0.5), seen: () => true,
    };
}

/** Calls with a wrong value at one place, by the name that the error gives the place. */
const CALLS = {
    "the gravity of a world": ["gravity", (_, x) => new RAPIER.World(x)],
    "the gravity in a step": ["gravity", ({ world }, x) => ((world.gravity = x), world.step())],
    createRigidBody: ["body", ({ world }, x) => world.createRigidBody(x)],
    createCollider: ["desc", ({ world }, x) => world.createCollider(x)],
    "ColliderDesc.shape": ["shape", ({ world }, x) => world.createCollider(new RAPIER.ColliderDesc(x))],
    "createImpulseJoint, data": ["params", ({ world, body, other }, x) => world.createImpulseJoint(x, body, other, true)],
    "createImpulseJoint, first": ["parent1", ({ world, body }, x) => world.createImpulseJoint(hinge(), x, body, true)],
    "createImpulseJoint, second": ["parent2", ({ world, body }, x) => world.createImpulseJoint(hinge(), body, x, true)],
    "createImpulseJoint, anchor": ["anchor1", ({ world, body, other }, x) => world.createImpulseJoint(RAPIER.JointData.rope(1, x, zero), body, other, true)],
    "createMultibodyJoint, first": ["parent1", ({ world, body }, x) => world.createMultibodyJoint(hinge(), x, body, true)],
    "createMultibodyJoint, second": ["parent2", ({ world, body }, x) => world.createMultibodyJoint(hinge(), body, x, true)],
    setAnchor1: ["anchor", ({ joint }, x) => joint.setAnchor1(x)],
    setFrameX2: ["rotation", ({ joint }, x) => joint.setFrameX2(x)],
    setLocalFrame2: ["anchor", ({ joint }, x) => joint.setLocalFrame2(x, none)],
    setTranslation: ["translation", ({ body }, x) => body.setTranslation(x, true)],
    setRotation: ["rotation", ({ body }, x) => body.setRotation(x, true)],
    "RigidBodyDesc.setRotation": ["rotation", (_, x) => RAPIER.RigidBodyDesc.dynamic().setRotation(x)],
    setLinvel: ["linvel", ({ body }, x) => body.setLinvel(x, true)],
    setAngvel: ["angvel", ({ body }, x) => body.setAngvel(x, true)],
    setNextKinematicTranslation: ["translation", ({ body }, x) => body.setNextKinematicTranslation(x)],
    addForce: ["force", ({ body }, x) => body.addForce(x, true)],
    addTorque: ["torque", ({ body }, x) => body.addTorque(x, true)],
    applyImpulseAtPoint: ["point", ({ body }, x) => body.applyImpulseAtPoint(zero, x, true)],
    "collider.setTranslation": ["translation", ({ collider }, x) => collider.setTranslation(x)],
    "collider.setRotationWrtParent": ["rotation", ({ collider }, x) => collider.setRotationWrtParent(x)],
    setShape: ["shape", ({ collider }, x) => collider.setShape(x)],
    setHalfExtents: ["halfExtents", ({ collider }, x) => collider.setHalfExtents(x)],
    "collider.castRay": ["ray", ({ collider }, x) => collider.castRay(x, 10, true)],
    "collider.castShape": ["shape2", ({ collider }, x) => collider.castShape(zero, x, zero, none, zero, 0, 1, true)],
    castCollider: ["collider2", ({ collider }, x) => collider.castCollider(zero, x, zero, 0, 1, true)],
    contactCollider: ["collider2", ({ collider }, x) => collider.contactCollider(x, 1)],
    "shape.containsPoint": ["point", ({ ball }, x) => ball.containsPoint(zero, none, x)],
    "world.castRay": ["ray", ({ world }, x) => world.castRay(x, 10, true)],
    "world.castRay, origin": ["ray.origin", ({ world }, x) => world.castRay(new RAPIER.Ray(x, zero), 10, true)],
    "world.castShape": ["shape", ({ world }, x) => world.castShape(zero, none, v(0, 1), x, 0, 1, true)],
    "world.castShape, velocity": ["shapeVel", ({ world, ball }, x) => world.castShape(zero, none, x, ball, 0, 1, true)],
    intersectionsWithShape: ["shape", ({ world, seen }, x) => world.intersectionsWithShape(zero, none, x, seen)],
    projectPoint: ["point", ({ world }, x) => world.projectPoint(x, true)],
    collidersWithAabb: ["aabbHalfExtents", ({ world, seen }, x) => world.collidersWithAabbIntersectingAabb(zero, x, seen)],
    contactPair: ["collider2", ({ world, collider, seen }, x) => world.contactPair(collider, x, seen)],
    contactPairsWith: ["collider1", ({ world, seen }, x) => world.contactPairsWith(x, seen)],
    intersectionPair: ["collider1", ({ world, collider }, x) => world.intersectionPair(x, collider)],
    computeColliderMovement: ["collider", ({ character }, x) => character.computeColliderMovement(x, zero)],
    "computeColliderMovement, movement": ["desiredTranslationDelta", ({ character, collider }, x) => character.computeColliderMovement(collider, x)],
    setUp: ["up", ({ character }, x) => character.setUp(x)],
    linearCorrection: ["body", ({ pid }, x) => pid.linearCorrection(x, zero, zero)],
    "linearCorrection, target": ["targetPosition", ({ pid, body }, x) => pid.linearCorrection(body, x, zero)],
    changeBodies: ["bodies", ({ world }, x) => world.changeBodies("linvel", x, [])],
    "changeBodies, values": ["values", ({ world }, x) => world.changeBodies("linvel", [], x)],
    "trimesh, vertices": ["vertices", ({ world }, x) => world.createCollider(RAPIER.ColliderDesc.trimesh(x, new Uint32Array(3)))],
    "trimesh, indices": ["indices", ({ world }, x) => world.createCollider(RAPIER.ColliderDesc.trimesh(new Float32Array(9), x))],
    convexHull: ["points", (_, x) => RAPIER.ColliderDesc.convexHull(x)],
    convexDecomposition: ["vertices", (_, x) => RAPIER.ColliderDesc.convexDecomposition(x, new Uint32Array(3))],
    compound: ["shapes", ({ world }, x) => world.createCollider(RAPIER.ColliderDesc.compound(x, [], []))],
    "compound, a shape": ["shape", ({ world }, x) => world.createCollider(RAPIER.ColliderDesc.compound([x], [zero], [none]))],
    "compound, a position": ["position", ({ world, ball }, x) => world.createCollider(RAPIER.ColliderDesc.compound([ball], [x], [none]))],
    restoreSnapshot: ["data", (_, x) => RAPIER.World.restoreSnapshot(x)],
    ...(DIM === 3 && { createVehicleController: ["chassis", ({ world }, x) => world.createVehicleController(x)] }),
};
const WRONG = { undefined: undefined, null: null, "a text": "5", "a boolean": true };

for (const [name, [argument, call]] of Object.entries(CALLS)) {
    test(`${name} names a wrong argument`, () => {
        const parts = scene();
        const before = parts.world.hash();
        for (const [shown, value] of Object.entries(WRONG)) {
            const given = shown.startsWith("a ") ? JSON.stringify(value) : shown;
            assert.throws(() => call(parts, value), fails("InvalidValue", `${argument}`, `is ${given}`), shown);
        }
        parts.world.gravity = v(0, -9.81);
        assert.equal(parts.world.hash(), before);
        steps(parts.world, 2);
        parts.world.free();
    });
}

test("optional arguments of the wrong kind are named", () => {
    const { world, ray, body, collider } = scene();
    const queue = new RAPIER.EventQueue(true);
    for (const wrong of ["5", true, {}]) {
        assert.throws(() => world.createCollider(box(1, 1), wrong), fails("InvalidValue", "parent is"));
        assert.throws(() => world.castRay(ray, 10, true, 0, undefined, wrong), fails("InvalidValue", "filterExcludeCollider is"));
        assert.throws(() => world.castRay(ray, 10, true, 0, undefined, undefined, wrong), fails("InvalidValue", "filterExcludeRigidBody is"));
        assert.throws(() => world.step(wrong), fails("InvalidValue", "eventQueue is"));
    }
    assert.throws(() => world.step(undefined, "5"), fails("InvalidValue", "hooks is"));
    for (const wrong of ["5", true, {}, 5]) {
        assert.throws(() => world.step(undefined, { filterContactPair: wrong }), fails("InvalidValue", "hooks.filterContactPair is"));
        assert.throws(() => world.castRay(ray, 10, true, 0, undefined, undefined, undefined, wrong), fails("InvalidValue", "filterPredicate is"));
        assert.throws(() => world.intersectionsWithRay(ray, 10, true, wrong), fails("InvalidValue", "callback is"));
        assert.throws(() => world.intersectionsWithPoint(zero, wrong), fails("InvalidValue", "callback is"));
        assert.throws(() => world.contactPairsWith(collider, wrong), fails("InvalidValue", "f is"));
        assert.throws(() => queue.drainCollisionEvents(wrong), fails("InvalidValue", "f is"));
    }
    for (const wrong of ["5", true, 5]) {
        assert.throws(() => body.translation(wrong), fails("InvalidValue", "target is"));
    }
    for (const absent of [undefined, null, false]) {
        assert.equal(world.createCollider(box(1, 1), absent).parent(), null);
        assert.ok(world.castRay(ray, 10, true, 0, undefined, absent, absent, absent));
        world.step(absent, absent);
    }
    queue.free();
    world.free();
});

test("objects of another kind are refused by their class", () => {
    const { world, body, collider, joint } = scene();
    assert.throws(() => world.createImpulseJoint(hinge(), collider, body, true), fails("InvalidValue", "parent1 is an object of Collider", "rigid body"));
    assert.throws(() => world.createCollider(box(1, 1), joint), fails("InvalidValue", "parent is", "Joint"));
    assert.throws(() => world.createCollider(RAPIER.RigidBodyDesc.dynamic()), fails("InvalidValue", "desc is an object of RigidBodyDesc"));
    assert.throws(() => world.createRigidBody(box(1, 1)), fails("InvalidValue", "body is an object of ColliderDesc"));
    world.free();
});

test("handles take the place of bodies and colliders", () => {
    const run = (of) => {
        const { world, ground, collider: floor } = makeGround();
        const [one, other] = [insert(world, 0, 2, box(0.5, 0.5)), insert(world, 3, 2, box(0.5, 0.5))];
        world.createCollider(RAPIER.ColliderDesc.ball(0.25), of(one.body));
        const joint = world.createImpulseJoint(RAPIER.JointData.rope(4, zero, zero), of(one.body), of(other.body), true);
        const chain = world.createMultibodyJoint(hinge(), of(ground), of(other.body), true);
        const character = world.createCharacterController(0.1);
        character.computeColliderMovement(of(one.collider), v(0, -5));
        const pid = world.createPidController(1, 0, 0, RAPIER.PidAxesMask.All);
        pid.applyLinearCorrection(of(one.body), v(0, 3), zero);
        const ray = new RAPIER.Ray(v(0, 9), v(0, -1));
        const hit = world.castRay(ray, 20, true, undefined, undefined, of(one.collider), of(ground));
        if (DIM === 3) {
            assert.equal(world.createVehicleController(of(other.body)).chassis(), other.body);
        }
        steps(world, 120);
        const pairs = [];
        world.contactPairsWith(of(floor), (collider) => pairs.push(collider.handle));
        world.contactPair(of(floor), of(one.collider), (manifold) => pairs.push(manifold.numContacts()));
        assert.equal(world.intersectionPair(of(floor), of(one.collider)), false);
        world.removeImpulseJoint(of(joint), true);
        world.removeMultibodyJoint(of(chain), true);
        steps(world, 2);
        return [world.hash(), character.computedMovement().y, hit?.timeOfImpact, pairs];
    };
    assert.deepEqual(run((part) => part.handle), run((part) => part));
});

test("a handle that finds nothing is refused", () => {
    const { world, body, other } = scene();
    world.removeRigidBody(other);
    assert.throws(() => world.createImpulseJoint(hinge(), body.handle, other.handle, true), fails("StaleHandle", "rigid body"));
    assert.throws(() => world.createCollider(box(1, 1), other.handle), fails("StaleHandle"));
    world.free();
});

test("numbers that cannot be used are named", () => {
    const { world, collider, character, pid, body } = scene();
    const names = ["numSolverIterations", "numInternalPgsIterations", "maxCcdSubsteps", "numAdditionalFrictionIterations"];
    for (const wrong of [NaN, Infinity, -1]) {
        const text = Number.isFinite(wrong) ? "-1" : Number.isNaN(wrong) ? "NaN" : "inf";
        assert.throws(() => (world.timestep = wrong), fails("InvalidValue", "timestep", text));
        assert.throws(() => (world.integrationParameters.dt = wrong), fails("InvalidValue", "dt", text));
        for (const name of [...names, "lengthUnit"]) {
            assert.throws(() => (world[name] = wrong), fails("InvalidValue", name, text));
        }
        for (const name of ["contact_erp", "contact_natural_frequency", "contact_damping_ratio", "normalizedAllowedLinearError", "normalizedPredictionDistance"]) {
            assert.throws(() => (world.integrationParameters[name] = wrong), fails("InvalidValue", name, text));
        }
        assert.throws(() => body.setAdditionalSolverIterations(wrong), fails("InvalidValue", "additionalSolverIterations"));
        assert.throws(() => body.setAdditionalPgsIterations(wrong), fails("InvalidValue", "additionalPgsIterations"));
    }
    names.forEach((name) => assert.throws(() => (world[name] = 2.5), fails("InvalidValue", name, "2.5", "whole")));
    assert.throws(() => (world.numSolverIterations = 0), fails("InvalidValue", "numSolverIterations", "0"));
    for (const [name, set] of Object.entries({
        friction: () => collider.setFriction(NaN),
        restitution: () => collider.setRestitution(NaN),
        density: () => collider.setDensity(NaN),
        mass: () => collider.setMass(NaN),
        contactSkin: () => collider.setContactSkin(NaN),
        contactForceEventThreshold: () => collider.setContactForceEventThreshold(NaN),
        maxSlopeClimbAngle: () => character.setMaxSlopeClimbAngle(NaN),
        minSlopeSlideAngle: () => character.setMinSlopeSlideAngle(NaN),
        ki: () => pid.setKi(NaN, RAPIER.PidAxesMask.All),
        linvel: () => world.changeBodies("linvel", [body], new Float32Array(DIM).fill(NaN)),
    })) {
        assert.throws(set, fails("InvalidValue", name, "NaN"));
    }
    if (DIM === 3) {
        const vehicle = world.createVehicleController(body);
        vehicle.addWheel(zero, v(0, -1), v(1, 0), 0.5, 0.25);
        assert.throws(() => vehicle.setWheelBrake(0, NaN), fails("InvalidValue", "wheelBrake"));
        assert.throws(() => vehicle.setWheelSteering(0, NaN), fails("InvalidValue", "wheelSteering"));
    }
    world.free();
});

test("iterations beyond those of the world are kept apart, and each costs a substep", () => {
    const world = makeWorld();
    const made = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setAdditionalSolverIterations(3).setAdditionalPgsIterations(2));
    assert.deepEqual([made.additionalSolverIterations(), made.additionalPgsIterations()], [3, 2]);
    made.setAdditionalPgsIterations(5);
    made.setAdditionalSolverIterations(1);
    assert.deepEqual([made.additionalSolverIterations(), made.additionalPgsIterations()], [1, 5]);
    world.numAdditionalFrictionIterations = 4;
    assert.equal(world.integrationParameters.numAdditionalFrictionIterations, 4);
    world.free();
    // A fall with h = dt / (4 + n) is shorter by g t h / 2 than that of the exact solution.
    const drop = (set) => {
        const falling = makeWorld();
        const { body } = insert(falling, 0, 0, box(0.5, 0.5));
        set(body);
        steps(falling, 60);
        return -body.translation().y;
    };
    const drops = [drop((body) => body.setAdditionalPgsIterations(4)), drop((body) => body.setAdditionalSolverIterations(4))];
    assert.equal(drops[0], drops[1]);
    assert.ok(Math.abs(drops[0] - (9.81 / 2) * (1 + 1 / 480)) < 1e-4, `${drops[0]}`);
});

test("the published packages' default of the contact spring is the engine's default", () => {
    const { world } = makeGround();
    const { integrationParameters } = world;
    const own = integrationParameters.contact_erp;
    const fractions = [0, 10, 60, 120, 1e6].map((frequency) => {
        integrationParameters.contact_natural_frequency = frequency;
        return integrationParameters.contact_erp;
    });
    assert.ok(fractions[0] === 0 && fractions.every((fraction, index) => index === 0 || fraction >= fractions[index - 1]), `${fractions}`);
    assert.equal(fractions.at(-1), 1);
    // @react-three/rapier sets 30 in each world.
    integrationParameters.contact_natural_frequency = 30;
    assert.equal(integrationParameters.contact_erp, own);
    const boxes = Array.from({ length: 5 }, (_, index) => insert(world, 0, 1 + 2 * index, box(0.5, 0.5)).body);
    steps(world, 120);
    boxes.forEach((body, index) => assert.ok(Math.abs(body.translation().y - (0.5 + index)) < 0.02, `box ${index} lies in its stack`));
    world.free();
});

test("errors and classes have their names", () => {
    const { RapierError } = RAPIER;
    assert.equal(RapierError.name, "RapierError");
    try {
        new RAPIER.World(undefined);
        assert.fail("it is refused");
    } catch (error) {
        assert.equal(error.name, "RapierError");
        assert.equal(error.constructor.name, "RapierError");
        assert.match(error.stack, /^RapierError: gravity is undefined/);
        assert.match(String(error), /^RapierError: gravity/);
        assert.ok(error instanceof RapierError && error instanceof Error);
    }
    for (const [name, part] of Object.entries(RAPIER)) {
        if (typeof part === "function") {
            assert.equal(part.name, name);
        }
    }
});

test("all collision types are all", () => {
    const { ALL, ...others } = RAPIER.ActiveCollisionTypes;
    const all = Object.values(others).filter((value) => typeof value === "number").reduce((sum, value) => sum | value, 0);
    assert.equal(ALL & all, all);
    // Two fixed bodies, one of them a sensor, intersect only with FIXED_FIXED.
    const { world, collider } = makeGround();
    const sensor = world.createCollider(box(1, 1).setSensor(true).setActiveCollisionTypes(ALL), world.createRigidBody(RAPIER.RigidBodyDesc.fixed()));
    steps(world, 2);
    assert.ok(world.intersectionPair(sensor, collider));
    world.free();
});
