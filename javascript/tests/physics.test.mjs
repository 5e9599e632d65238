// Formulas of mechanics, measured through the package.

import assert from "node:assert/strict";
import test from "node:test";
import { DIM, RAPIER, c, insert, box, makeGround, makeWorld, near, steps, v } from "./setup.mjs";

const ball = (radius) => RAPIER.ColliderDesc.ball(radius);

test("a free fall covers g t² / 2", () => {
    const world = makeWorld();
    const { body } = insert(world, 0, 100, ball(0.5));
    steps(world, 60);
    near(body.translation().y, 100 - 9.81 / 2, 0.1);
    near(body.linvel().y, -9.81, 1e-3);
    world.free();
});

test("a ball of restitution 0.8 bounces to 0.64 of its height", () => {
    const { world, collider } = makeGround();
    collider.setRestitution(0.8);
    const { body } = insert(world, 0, 5.5, ball(0.5).setRestitution(0.8));
    let [peak, hit] = [0, false];
    for (let step = 0; step < 200; step += 1) {
        world.step();
        const { y } = body.linvel();
        hit ||= y > 0;
        if (hit) {
            peak = Math.max(peak, body.translation().y);
            if (y < 0) break;
        }
    }
    near(peak - 0.5, 5 * 0.64, 0.3);
    world.free();
});

test("a box slides v² / (2 µ g)", () => {
    const { world } = makeGround();
    const { body } = insert(world, 0, 0.5, box(0.5, 0.5).setFriction(0.5));
    body.setLinvel(v(4, 0), true);
    steps(world, 180);
    near(body.translation().x, 16 / (2 * 0.5 * 9.81), 0.15);
    near(body.linvel().x, 0, 1e-3);
    world.free();
});

test("an impulse changes the velocity by its quotient with the mass", () => {
    const world = makeWorld(0);
    const { body } = insert(world, 0, 0, box(0.5, 0.5, 0.5).setDensity(2));
    near(body.mass(), 2, 1e-5);
    body.applyImpulse(v(3, 0), true);
    near(body.linvel().x, 1.5, 1e-5);
    body.addForce(v(0, 4), true);
    steps(world, 60);
    near(body.linvel().y, 2, 1e-3);
    assert.equal(body.userForce().y, 4);
    body.resetForces(true);
    assert.equal(body.userForce().y, 0);
    world.free();
});

test("a pile falls asleep, and a touch wakes it", () => {
    const { world } = makeGround();
    const boxes = Array.from({ length: 5 }, (_, layer) => insert(world, 0, 0.5 + layer, box(0.5, 0.5)));
    steps(world, 300);
    assert.ok(boxes.every(({ body }) => body.isSleeping()));
    let active = 0;
    world.forEachActiveRigidBody(() => (active += 1));
    assert.equal(active, 0);
    boxes[4].body.applyImpulse(v(0.5, 0), true);
    world.step();
    assert.ok(!boxes[4].body.isSleeping());
    world.free();
});

test("locked axes hold", () => {
    const world = makeWorld();
    const { body } = insert(world, 0, 0, ball(1));
    body.lockTranslations(true, true);
    steps(world, 30);
    assert.equal(body.translation().y, 0);
    body.setEnabledTranslations(...(DIM === 2 ? [false, true] : [false, true, false]), true);
    body.applyImpulse(v(5, 0), true);
    steps(world, 30);
    assert.ok(body.translation().y < -0.5);
    assert.equal(body.translation().x, 0);
    world.free();
});

test("a kinematic body arrives where it was sent", () => {
    const world = makeWorld();
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicPositionBased());
    body.setNextKinematicTranslation(v(1, 2));
    assert.deepEqual({ ...body.nextTranslation() }, v(1, 2));
    world.step();
    assert.deepEqual({ ...body.translation() }, v(1, 2));
    near(body.linvel().x, 60, 1e-3);
    world.free();
});

test("getters fill a target", () => {
    const world = makeWorld();
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(...c(1, 2, 3)));
    const target = v(0, 0, 0);
    assert.equal(body.translation(target), target);
    assert.deepEqual(target, v(1, 2, 3));
    world.free();
});
