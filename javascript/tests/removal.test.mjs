// Removals of what is gone: they do nothing, as in the published packages. Programs remove a body and then its
// colliders and joints. Objects of other worlds stay an error, and a new object in the place of an old one stays.

import assert from "node:assert/strict";
import test from "node:test";
import { DIM, RAPIER, box, fails, insert, makeGround, makeWorld, steps, v } from "./setup.mjs";

const hinge = () => (DIM === 2 ? RAPIER.JointData.revolute(v(0, 0), v(0, 1)) : RAPIER.JointData.spherical(v(0, 0), v(0, 1)));

/** A thing of each kind in a world, with its removal by object, by handle, and by the set. */
function kinds(world) {
    const [one, other] = [insert(world, 0, 5, box(0.5, 0.5)), insert(world, 3, 5, box(0.5, 0.5))];
    const [third, fourth] = [insert(world, 6, 5, box(0.5, 0.5)), insert(world, 9, 5, box(0.5, 0.5))];
    const impulse = world.createImpulseJoint(hinge(), one.body, other.body, true);
    const multibody = world.createMultibodyJoint(hinge(), third.body, fourth.body, true);
    const alone = world.createCollider(box(0.25, 0.25));
    return {
        "rigid body": [one.body, (thing) => world.removeRigidBody(thing), (handle) => world.bodies.remove(handle)],
        collider: [alone, (thing) => world.removeCollider(thing, true), (handle) => world.colliders.remove(handle, world.islands, world.bodies, true)],
        "impulse joint": [impulse, (thing) => world.removeImpulseJoint(thing, true), (handle) => world.impulseJoints.remove(handle, true)],
        "multibody joint": [multibody, (thing) => world.removeMultibodyJoint(thing, true), (handle) => world.multibodyJoints.remove(handle, true)],
    };
}

const counts = (world) => [world.bodies, world.colliders, world.impulseJoints, world.multibodyJoints].map((set) => set.len()).join();

for (const kind of ["rigid body", "collider", "impulse joint", "multibody joint"]) {
    test(`a ${kind} can be removed again, by object and by handle`, () => {
        const { world } = makeGround();
        const [thing, remove, removeFromSet] = kinds(world)[kind];
        remove(thing);
        const [left, hash] = [counts(world), world.hash()];
        for (const again of [() => remove(thing), () => remove(thing.handle), () => removeFromSet(thing.handle)]) {
            again();
            assert.equal(counts(world), left);
            assert.equal(world.hash(), hash);
        }
        assert.ok(!thing.isValid());
        steps(world, 5);
        remove(thing);
        assert.equal(counts(world), left);
        world.free();
    });

    test(`a ${kind} is removed by its handle`, () => {
        const { world } = makeGround();
        const [thing, remove] = kinds(world)[kind];
        const before = counts(world);
        remove(thing.handle);
        assert.ok(!thing.isValid());
        assert.notEqual(counts(world), before);
        world.free();
    });

    test(`the removal of an old ${kind} leaves the new one in its place`, () => {
        const { world } = makeGround();
        const [thing, remove, removeFromSet] = kinds(world)[kind];
        remove(thing);
        // All slots are used again.
        const later = Array.from({ length: 4 }, () => kinds(world)[kind][0]);
        const before = counts(world);
        remove(thing);
        remove(thing.handle);
        removeFromSet(thing.handle);
        assert.equal(counts(world), before);
        later.forEach((other) => assert.ok(other.isValid()));
        world.free();
    });

    test(`a ${kind} of another world is refused, gone or not`, () => {
        const [one, other] = [makeGround().world, makeGround().world];
        const [thing, removeThere] = kinds(other)[kind];
        const [, remove] = kinds(one)[kind];
        const before = [counts(one), counts(other)];
        assert.throws(() => remove(thing), fails("StaleHandle", kind, "another world"));
        assert.deepEqual([counts(one), counts(other)], before);
        removeThere(thing);
        assert.throws(() => remove(thing), fails("StaleHandle", "another world"));
        one.free();
        other.free();
    });
}

test("what goes with a body can be removed after it", () => {
    const { world } = makeGround();
    const [one, other] = [insert(world, 0, 5, box(0.5, 0.5)), insert(world, 3, 5, box(0.5, 0.5))];
    const second = world.createCollider(box(0.25, 0.25), one.body);
    const joints = [world.createImpulseJoint(hinge(), one.body, other.body, true), world.createMultibodyJoint(hinge(), other.body, one.body, true)];
    // The order of three.js's addon: the body first.
    world.removeRigidBody(one.body);
    for (const collider of [one.collider, second]) {
        world.removeCollider(collider, true);
    }
    world.removeImpulseJoint(joints[0], true);
    world.removeMultibodyJoint(joints[1], true);
    world.removeRigidBody(one.body);
    assert.equal(counts(world), "2,2,0,0");
    steps(world, 120);
    assert.ok(Math.abs(other.body.translation().y - 0.5) < 0.01, "the other body falls to the ground");
    world.free();
});

test("in a freed world all things are gone", () => {
    const { world } = makeGround();
    const things = Object.values(kinds(world));
    const character = world.createCharacterController(0.1);
    world.free();
    for (const [thing, remove, removeFromSet] of things) {
        remove(thing);
        remove(thing.handle);
        removeFromSet(thing.handle);
    }
    world.removeCharacterController(character);
    const other = makeGround().world;
    things.forEach(([thing], index) => assert.throws(() => Object.values(kinds(other))[index][1](thing), fails("StaleHandle", "another world")));
    other.free();
});

test("removals between steps and inside a frame are the same world", () => {
    const hashes = [false, true].map((again) => {
        const { world } = makeGround();
        const { body, collider } = insert(world, 0, 3, box(0.5, 0.5));
        insert(world, 0.25, 1, box(0.5, 0.5));
        steps(world, 10);
        world.removeRigidBody(body);
        if (again) {
            world.removeCollider(collider, true);
            world.removeRigidBody(body);
        }
        steps(world, 10);
        return world.hash();
    });
    assert.equal(hashes[0], hashes[1]);
});

test("controllers can be removed again, and in their own world only", () => {
    const [one, other] = [makeGround(), makeGround()];
    const makers = [
        [(world) => world.createCharacterController(0.1), (world, controller) => world.removeCharacterController(controller)],
        [(world) => world.createPidController(1, 0, 0, RAPIER.PidAxesMask.AllLin), (world, controller) => world.removePidController(controller)],
    ];
    if (DIM === 3) {
        makers.push([
            (world) => world.createVehicleController(insert(world, 0, 2, box(0.5, 0.5)).body),
            (world, controller) => world.removeVehicleController(controller),
        ]);
    }
    for (const [make, remove] of makers) {
        const controller = make(one.world);
        assert.throws(() => remove(other.world, controller), fails("StaleHandle", "another world"));
        assert.ok(controller.isAlive(), "the refused removal left it alive");
        remove(one.world, controller);
        const next = make(one.world);
        remove(one.world, controller);
        assert.ok(next.isAlive() && !controller.isAlive());
        for (const wrong of [undefined, null, 5, {}, one.ground]) {
            assert.throws(() => remove(one.world, wrong), fails("InvalidValue", "controller"));
        }
        const last = make(other.world);
        other.world.free();
        remove(other.world, last);
        Object.assign(other, makeGround());
    }
    one.world.free();
    other.world.free();
});

test("a removal needs a thing or a handle", () => {
    const world = makeWorld();
    const { body, collider } = insert(world, 0, 0, box(1, 1));
    for (const wrong of [undefined, null, "1", {}, NaN, []]) {
        assert.throws(() => world.removeRigidBody(wrong), fails("InvalidValue", "body is", "rigid body"));
        assert.throws(() => world.removeCollider(wrong, true), fails("InvalidValue", "collider is"));
        assert.throws(() => world.removeImpulseJoint(wrong, true), fails("InvalidValue", "joint is"));
        assert.throws(() => world.removeMultibodyJoint(wrong, true), fails("InvalidValue", "joint is"));
    }
    assert.throws(() => world.removeRigidBody(collider), fails("InvalidValue", "an object of Collider"));
    assert.throws(() => world.removeCollider(body, true), fails("InvalidValue", "an object of RigidBody"));
    assert.equal(counts(world), "1,1,0,0");
    world.free();
});

test("a hook cannot remove anything", () => {
    const { world } = makeGround();
    const { body, collider } = insert(world, 0, 0.4, box(0.5, 0.5).setActiveHooks(RAPIER.ActiveHooks.FILTER_CONTACT_PAIRS));
    const hooks = { filterContactPair: () => (world.removeCollider(collider, true), RAPIER.SolverFlags.COMPUTE_IMPULSE) };
    assert.throws(() => steps(world, 2, undefined, hooks), fails("Busy"));
    assert.ok(body.isValid() && collider.isValid());
    world.free();
});
