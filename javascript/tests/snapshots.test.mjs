// Snapshots: restored worlds continue bit for bit, damaged ones are rejected.

import assert from "node:assert/strict";
import test from "node:test";
import { DIM, RAPIER, c, fails, insert, box, makeGround, near, steps, v } from "./setup.mjs";

const { ColliderDesc, JointData, World } = RAPIER;

/** A pile with a joint. */
function pile() {
    const { world, ground } = makeGround();
    const boxes = Array.from({ length: 12 }, (_, layer) => insert(world, (layer % 2) * 0.2, 0.6 + layer * 1.1, box(0.5, 0.5)));
    const joint = world.createImpulseJoint(JointData.rope(3, v(0, 0), v(0, 0)), boxes[10].body, boxes[11].body, true);
    steps(world, 30);
    return { world, ground, boxes, joint };
}

test("a restored world continues bit for bit", () => {
    const { world, boxes, joint } = pile();
    const snapshot = world.takeSnapshot();
    const restored = World.restoreSnapshot(snapshot);
    assert.ok(restored instanceof World);
    assert.equal(restored.hash(), world.hash());
    near(restored.gravity.y, -9.81, 1e-6);
    assert.equal(restored.bodies.len(), world.bodies.len());
    assert.equal(restored.colliders.len(), world.colliders.len());
    const twin = restored.getRigidBody(boxes[3].body.handle);
    assert.deepEqual(twin.translation(), boxes[3].body.translation());
    assert.equal(restored.getCollider(boxes[3].collider.handle).parent(), twin);
    assert.ok(restored.getImpulseJoint(joint.handle) instanceof RAPIER.RopeImpulseJoint);
    steps(world, 100);
    steps(restored, 100);
    assert.equal(restored.hash(), world.hash());
    assert.deepEqual(restored.takeSnapshot(), world.takeSnapshot());
    world.free();
    restored.step();
    restored.free();
});

test("a copy continues bit for bit", () => {
    const { world } = pile();
    const copy = world.clone();
    steps(world, 50);
    assert.notEqual(copy.hash(), world.hash());
    steps(copy, 50);
    assert.equal(copy.hash(), world.hash());
    assert.equal(copy.constructor, world.constructor);
    copy.free();
    world.free();
});

test("snapshots and copies hold the gravity that no step has used yet", () => {
    const world = new World(v(0, -1));
    const gravityOf = (saved) => {
        const { y } = saved.gravity;
        saved.free();
        return y;
    };
    assert.equal(gravityOf(World.restoreSnapshot(world.takeSnapshot())), -1);
    assert.equal(gravityOf(world.clone()), -1);
    world.step();
    world.gravity = v(0, -2);
    assert.equal(gravityOf(World.restoreSnapshot(world.takeSnapshot())), -2);
    assert.equal(gravityOf(world.clone()), -2);
    const parts = [world.integrationParameters, world.islands, world.broadPhase, world.narrowPhase, world.bodies];
    const data = world.serializationPipeline.serializeAll(v(0, -3), ...parts);
    assert.equal(gravityOf(World.restoreSnapshot(data)), -3);
    assert.equal(world.gravity.y, -2);
    world.gravity = v(NaN, 0);
    assert.throws(() => world.takeSnapshot(), fails("InvalidValue", "gravity"));
    world.free();
});

test("damaged snapshots are refused", () => {
    const { world } = pile();
    const snapshot = world.takeSnapshot();
    const damaged = snapshot.slice();
    damaged[damaged.length >> 1] ^= 1;
    assert.throws(() => World.restoreSnapshot(damaged), fails("InvalidSnapshot", "damaged"));
    assert.throws(() => World.restoreSnapshot(snapshot.slice(0, 100)), fails("InvalidSnapshot", "bytes"));
    assert.throws(() => World.restoreSnapshot(new Uint8Array(0)), fails("InvalidSnapshot"));
    assert.throws(() => World.restoreSnapshot(new TextEncoder().encode("no snapshot at all, but longer than a header, surely: yes")), fails("InvalidSnapshot"));
    steps(world, 2);
    world.free();
});

test("4000 snapshots come and go in flat memory", () => {
    const { world } = pile();
    const cycle = () => World.restoreSnapshot(world.takeSnapshot()).free();
    for (let warm = 0; warm < 100; warm += 1) cycle();
    const before = RAPIER.memoryBytes();
    for (let count = 0; count < 4000; count += 1) cycle();
    assert.equal(RAPIER.memoryBytes(), before);
    world.free();
});

test("the pipelines of the published packages do the same", () => {
    const { world } = pile();
    const copy = world.clone();
    const { integrationParameters, islands, broadPhase, narrowPhase, bodies, colliders, impulseJoints, multibodyJoints, ccdSolver } = copy;
    const gravity = v(0, -9.81);
    const parts = [integrationParameters, islands, broadPhase, narrowPhase, bodies, colliders, impulseJoints, multibodyJoints];
    for (let step = 0; step < 10; step += 1) {
        world.step();
        copy.physicsPipeline.step(gravity, ...parts, ccdSolver);
    }
    assert.equal(copy.hash(), world.hash());
    const snapshot = copy.serializationPipeline.serializeAll(gravity, ...parts);
    assert.deepEqual(snapshot, world.takeSnapshot());
    const again = copy.serializationPipeline.deserializeAll(snapshot);
    assert.equal(again.hash(), world.hash());
    again.free();
    copy.free();
    world.free();
});

test("steps are timed if that is asked for", () => {
    const { world } = pile();
    world.step();
    assert.equal(world.timingStep(), 0);
    world.profilerEnabled = true;
    let total = 0;
    for (let step = 0; step < 50; step += 1) {
        world.step();
        total += world.timingStep();
        assert.ok(world.timingSolver() <= world.timingStep());
    }
    assert.ok(total > 0);
    world.free();
});
