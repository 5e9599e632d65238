// Joints of all kinds.

import assert from "node:assert/strict";
import test from "node:test";
import { DIM, RAPIER, c, fails, insert, makeWorld, near, r, steps, v } from "./setup.mjs";

const { ColliderDesc, JointData, JointType, MotorModel, RigidBodyDesc } = RAPIER;
const z = { x: 0, y: 0, z: 1 };

/** A fixed body at the origin and a dynamic ball at (1, 0). */
function pair(gravity = -9.81) {
    const world = makeWorld(gravity);
    const anchor = world.createRigidBody(RigidBodyDesc.fixed());
    const { body } = insert(world, 1, 0, ColliderDesc.ball(0.25));
    return { world, anchor, body };
}

const distance = (body) => {
    const { x, y, z = 0 } = body.translation();
    return Math.hypot(x, y, z);
};
const hinge = () => (DIM === 2 ? JointData.revolute(v(0, 0), v(-1, 0)) : JointData.revolute(v(0, 0), v(-1, 0), z));

test("a hinge keeps its distance, and its limits", () => {
    const { world, anchor, body } = pair();
    const joint = world.createImpulseJoint(hinge(), anchor, body, true);
    assert.ok(joint instanceof RAPIER.RevoluteImpulseJoint);
    assert.equal(joint.type(), JointType.Revolute);
    assert.equal(joint.body1(), anchor);
    assert.equal(joint.body2(), body);
    steps(world, 20);
    near(distance(body), 1, 1e-2);
    assert.ok(body.translation().y < -0.3);
    assert.ok(!joint.limitsEnabled());
    joint.setLimits(-0.25, 0.25);
    assert.ok(joint.limitsEnabled());
    assert.deepEqual([joint.limitsMin(), joint.limitsMax()], [-0.25, 0.25]);
    steps(world, 200);
    near(body.translation().y, -Math.sin(0.25), 0.05);
    assert.ok(Math.abs(joint.force().y) > 0);
    world.free();
});

test("a motor turns a hinge", () => {
    const { world, anchor, body } = pair(0);
    const joint = world.createImpulseJoint(hinge(), anchor, body, true);
    joint.configureMotorModel(MotorModel.ForceBased);
    joint.configureMotorVelocity(2, 10);
    steps(world, 120);
    const spin = body.angvel();
    near(Math.abs(DIM === 2 ? spin : spin.z), 2, 0.05);
    joint.configureMotorPosition(0, 50, 10);
    steps(world, 600);
    near(body.translation().y, 0, 0.02);
    assert.throws(() => joint.configureMotorVelocity(NaN, 1), fails("InvalidValue", "targetVel", "NaN"));
    assert.throws(() => joint.setLimits(NaN, 1), fails("InvalidValue"));
    world.free();
});

test("a slider slides", () => {
    const { world, anchor, body } = pair();
    const data = JointData.prismatic(v(0, 0), v(-1, 0), v(0, 1));
    data.limitsEnabled = true;
    data.limits = [-2, 2];
    const joint = world.createImpulseJoint(data, anchor, body, true);
    assert.ok(joint instanceof RAPIER.PrismaticImpulseJoint);
    steps(world, 200);
    near(body.translation().y, -2, 0.05);
    near(body.translation().x, 1, 0.01);
    world.free();
});

test("ropes, springs and fixed joints hold", () => {
    const rope = pair();
    rope.world.createImpulseJoint(JointData.rope(2, v(0, 0), v(0, 0)), rope.anchor, rope.body, true);
    steps(rope.world, 120);
    near(distance(rope.body), 2, 0.05);
    rope.world.free();

    const spring = pair(0);
    const joint = spring.world.createImpulseJoint(JointData.spring(0.5, 100, 10, v(0, 0), v(0, 0)), spring.anchor, spring.body, true);
    assert.equal(joint.type(), JointType.Spring);
    steps(spring.world, 300);
    near(distance(spring.body), 0.5, 0.05);
    spring.world.free();

    const fixed = pair();
    const data = JointData.fixed(v(0, 0), r(0), v(-1, 0), r(0));
    const held = fixed.world.createImpulseJoint(data, fixed.anchor, fixed.body, true);
    steps(fixed.world, 60);
    near(fixed.body.translation().y, 0, 0.02);
    near(held.anchor2().x, -1, 1e-6);
    held.setAnchor1(v(0, 1));
    near(held.anchor1().y, 1, 1e-6);
    steps(fixed.world, 120);
    near(fixed.body.translation().y, 1, 0.05);
    fixed.world.free();
});

test("a generic joint locks what its mask says", () => {
    const { world, anchor, body } = pair();
    const mask = RAPIER.JointAxesMask.LinX | RAPIER.JointAxesMask.AngX;
    const joint = world.createImpulseJoint(JointData.generic(v(0, 0), v(-1, 0), v(1, 0), mask), anchor, body, true);
    assert.ok(joint instanceof RAPIER.GenericImpulseJoint);
    steps(world, 60);
    near(body.translation().x, 1, 0.01);
    assert.ok(body.translation().y < -1);
    world.free();
});

test("a ball joint turns as it likes", { skip: DIM === 2 }, () => {
    const { world, anchor, body } = pair();
    const joint = world.createImpulseJoint(JointData.spherical(v(0, 0), v(-1, 0)), anchor, body, true);
    assert.ok(joint instanceof RAPIER.SphericalImpulseJoint);
    joint.configureMotorVelocity(RAPIER.JointAxis.AngX, 1, 1);
    body.setLinvel(v(0, 0, 2), true);
    steps(world, 60);
    near(distance(body), 1, 0.02);
    world.free();
});

test("joints go with their bodies, and stale ones are refused", () => {
    const { world, anchor, body } = pair();
    const joint = world.createImpulseJoint(hinge(), anchor, body, true);
    joint.setContactsEnabled(false);
    assert.ok(!joint.contactsEnabled());
    assert.equal(world.impulseJoints.len(), 1);
    const attached = [];
    world.impulseJoints.forEachJointHandleAttachedToRigidBody(body.handle, (handle) => attached.push(handle));
    assert.deepEqual(attached, [joint.handle]);
    world.removeRigidBody(body);
    assert.ok(!joint.isValid());
    assert.equal(world.impulseJoints.len(), 0);
    assert.throws(() => joint.anchor1(), fails("StaleHandle", "impulse joint"));
    assert.throws(() => world.createImpulseJoint(hinge(), anchor, body, true), fails("StaleHandle", "rigid body"));
    const { body: other } = insert(world, 2, 0, ColliderDesc.ball(0.5));
    assert.throws(() => world.createImpulseJoint(hinge(), other, other, true), fails("InvalidValue"));
    const again = world.createImpulseJoint(hinge(), anchor, other, true);
    world.removeImpulseJoint(again, true);
    world.step();
    world.free();
});

test("a multibody never drifts apart", () => {
    const world = makeWorld();
    const anchor = world.createRigidBody(RigidBodyDesc.fixed());
    let parent = anchor;
    const joints = [];
    for (let link = 1; link <= 5; link += 1) {
        const { body } = insert(world, link, 0, ColliderDesc.ball(0.2));
        const data = DIM === 2 ? JointData.revolute(v(0.5, 0), v(-0.5, 0)) : JointData.revolute(v(0.5, 0), v(-0.5, 0), z);
        joints.push(world.createMultibodyJoint(data, parent, body, true));
        parent = body;
    }
    assert.ok(joints[0] instanceof RAPIER.RevoluteMultibodyJoint);
    joints[1].setAxisLimits(RAPIER.JointAxis.AngX, -0.5, 0.5);
    steps(world, 120);
    let [previous, worst] = [v(0.5, 0), 0];
    for (const joint of joints) {
        const body = joint.body2();
        const { x, y } = body.translation();
        const angle = DIM === 2 ? body.rotation() : 2 * Math.atan2(body.rotation().z, body.rotation().w);
        worst = Math.max(worst, Math.hypot(x - 0.5 * Math.cos(angle) - previous.x, y - 0.5 * Math.sin(angle) - previous.y));
        previous = v(x + 0.5 * Math.cos(angle), y + 0.5 * Math.sin(angle));
    }
    assert.ok(worst < 1e-3, `${worst}`);
    assert.equal(world.multibodyJoints.len(), 5);
    world.removeMultibodyJoint(joints[4], true);
    assert.equal(world.multibodyJoints.len(), 4);
    world.step();
    world.free();
});
