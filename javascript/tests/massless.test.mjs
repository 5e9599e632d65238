// Dynamic bodies without mass: no force moves them, as in the published packages. Programs hang things on
// empty dynamic bodies.

import assert from "node:assert/strict";
import test from "node:test";
import { DIM, RAPIER, box, c, insert, makeGround, makeWorld, near, steps, v } from "./setup.mjs";

const dynamic = (x, y) => RAPIER.RigidBodyDesc.dynamic().setTranslation(...c(x, y));
const at = (body) => c(...Object.values(body.translation()).slice(0, 3));

const KINDS = {
    "no collider": (world, desc) => world.createRigidBody(desc),
    "colliders of density 0": (world, desc) => {
        const body = world.createRigidBody(desc);
        world.createCollider(box(0.5, 0.5).setDensity(0), body);
        world.createCollider(RAPIER.ColliderDesc.ball(0.5).setMass(0), body);
        return body;
    },
    "a sensor of density 0": (world, desc) => {
        const body = world.createRigidBody(desc);
        world.createCollider(box(0.5, 0.5).setDensity(0).setSensor(true), body);
        return body;
    },
    "additional mass 0": (world, desc) => world.createRigidBody(desc.setAdditionalMass(0)),
    "gravity scale 5": (world, desc) => world.createRigidBody(desc.setGravityScale(5)),
};

RAPIER.setWarningHandler(() => {});

for (const [name, make] of Object.entries(KINDS)) {
    test(`a body without mass (${name}) stays, or keeps its velocity`, () => {
        const { world } = makeGround();
        const rest = make(world, dynamic(0, 5));
        const thrown = make(world, dynamic(30, 5).setLinvel(...c(1, 0.5)));
        const later = make(world, dynamic(60, 5));
        rest.addForce(v(100, -50), true);
        rest.applyImpulse(v(3, 4), true);
        later.setLinvel(v(-1, 2), true);
        const start = at(rest);
        steps(world, 120);
        assert.deepEqual(at(rest), start);
        assert.equal(rest.mass(), 0);
        // x = v t; the sum of 480 substeps is rounded.
        near(thrown.translation().x, 32, 2e-4);
        near(thrown.translation().y, 6, 2e-4);
        near(later.translation().x, 58, 2e-4);
        near(later.translation().y, 9, 2e-4);
        world.free();
    });
}

test("a body falls while it has mass", () => {
    const world = makeWorld();
    const body = world.createRigidBody(dynamic(0, 0));
    steps(world, 30);
    assert.equal(body.translation().y, 0);
    const collider = world.createCollider(box(0.5, 0.5), body);
    steps(world, 30);
    near(body.linvel().y, -9.81 / 2, 1e-3);
    world.removeCollider(collider, true);
    steps(world, 1);
    const speed = body.linvel().y;
    steps(world, 30);
    assert.equal(body.linvel().y, speed);
    world.free();
});

const zero = v(0, 0);
const arm = v(-1, 0);
const none = DIM === 2 ? 0 : { x: 0, y: 0, z: 0, w: 1 };
const JOINTS = {
    rope: () => RAPIER.JointData.rope(1.5, zero, zero),
    spring: () => RAPIER.JointData.spring(1, 50, 1, zero, zero),
    fixed: () => RAPIER.JointData.fixed(zero, none, arm, none),
    revolute: () => (DIM === 2 ? RAPIER.JointData.revolute(zero, arm) : RAPIER.JointData.revolute(zero, arm, { x: 0, y: 0, z: 1 })),
    prismatic: () => RAPIER.JointData.prismatic(zero, arm, v(0, 1)),
    ...(DIM === 3 && { spherical: () => RAPIER.JointData.spherical(zero, arm) }),
};

for (const [name, joint] of Object.entries(JOINTS)) {
    test(`an empty dynamic body carries a weight on a joint (${name}) as a fixed body does`, () => {
        const [fixed, empty] = [RAPIER.RigidBodyDesc.fixed(), RAPIER.RigidBodyDesc.dynamic()].map((desc) => {
            const world = makeWorld();
            const hook = world.createRigidBody(desc.setTranslation(...c(2, 10)));
            const weight = insert(world, 3, 10, box(0.25, 0.25)).body;
            world.createImpulseJoint(joint(), hook, weight, true);
            steps(world, 60);
            assert.deepEqual(at(hook), c(2, 10));
            const end = at(weight);
            world.free();
            return end;
        });
        fixed.forEach((component, index) => near(empty[index], component, 1e-4));
    });
}

test("a cradle of balls on empty dynamic bodies swings about them", () => {
    const { world } = makeGround();
    const hooks = Array.from({ length: 5 }, (_, index) => world.createRigidBody(dynamic(index, 5)));
    const balls = hooks.map((hook, index) => {
        const ball = insert(world, index, 2, RAPIER.ColliderDesc.ball(0.5).setRestitution(1)).body;
        world.createImpulseJoint(RAPIER.JointData.rope(3, zero, zero), hook, ball, true);
        return ball;
    });
    balls[0].applyImpulse(v(-1, 0), true);
    for (let step = 0; step < 300; step += 1) {
        world.step();
        balls.forEach((ball, index) => {
            const [dx, dy] = [ball.translation().x - index, ball.translation().y - 5];
            assert.ok(Math.hypot(dx, dy) < 3.05, `ball ${index} hangs on its hook`);
        });
    }
    hooks.forEach((hook, index) => assert.deepEqual(at(hook), c(index, 5)));
    world.free();
});
