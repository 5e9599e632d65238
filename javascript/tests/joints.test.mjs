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

// ---- Gears, racks and pulleys ----

const gear = (ratio) => (DIM === 2 ? JointData.gear(ratio) : JointData.gear(z, z, ratio));
const rack = (radius) => (DIM === 2 ? JointData.rack(v(1, 0), radius) : JointData.rack(z, v(1, 0), radius));
const spin = (body) => (DIM === 2 ? body.angvel() : body.angvel().z);
const torque = (body, value) => body.addTorque(DIM === 2 ? value : { x: 0, y: 0, z: value }, true);
/** The moment of inertia of a ball of radius 0.5. */
const inertia = (mass) => (DIM === 2 ? 0.5 : 0.4) * mass * 0.5 ** 2;

/** A body of a mass whose axle or rail is a joint with the world. */
function held(world, x, y, mass, rail) {
    const post = world.createRigidBody(RigidBodyDesc.fixed().setTranslation(...c(x, y)));
    const { body } = insert(world, x, y, ColliderDesc.ball(0.5).setMass(mass));
    const axle = DIM === 2 ? JointData.revolute(v(0, 0), v(0, 0)) : JointData.revolute(v(0, 0), v(0, 0), z);
    world.createImpulseJoint(rail ? JointData.prismatic(v(0, 0), v(0, 0), rail) : axle, post, body, true);
    return body;
}

/** A torque `τ` on the first wheel: `α₁ = τ / (I₁ + I₂ / r²)`, `α₂ = -α₁ / r`. */
test("gears share a torque by their ratio", () => {
    for (const [ratio, mass] of [[-3, 1], [0.5, 2], [1, 1000], [10, 0.1]]) {
        const world = makeWorld(0);
        const [first, second] = [held(world, 0, 0, 1), held(world, 2, 0, mass)];
        const joint = world.createImpulseJoint(gear(ratio), first, second, true);
        assert.ok(joint instanceof RAPIER.GearImpulseJoint);
        assert.equal(joint.type(), JointType.Gear);
        assert.equal(joint.ratio(), ratio);
        assert.ok(!joint.contactsEnabled());
        const total = inertia(1) + inertia(mass) / ratio ** 2;
        torque(first, 5 * total);
        steps(world, 60);
        near(spin(first), 5, 0.01);
        near(spin(second), -5 / ratio, 0.01 / Math.abs(ratio));
        world.free();
    }
});

test("a gear has backlash, and its ratio can change", () => {
    const world = makeWorld(0);
    const [first, second] = [held(world, 0, 0, 1), held(world, 2, 0, 1)];
    const joint = world.createImpulseJoint(gear(1), first, second, true);
    assert.equal(joint.backlash(), 0);
    joint.setBacklash(0.5);
    assert.equal(joint.backlash(), 0.5);
    // Half of the backlash is on each side.
    first.setAngvel(DIM === 2 ? 0.5 : { x: 0, y: 0, z: 0.5 }, true);
    steps(world, 27);
    assert.equal(spin(second), 0);
    steps(world, 60);
    near(spin(first), 0.25, 0.01);
    near(spin(second), -0.25, 0.01);
    joint.setBacklash(0);
    joint.setRatio(2);
    assert.equal(joint.ratio(), 2);
    steps(world, 60);
    near(spin(first), -2 * spin(second), 1e-3);
    world.free();
});

/** A torque `τ` on a pinion of radius `r` moves a rack of mass `m`: `a = r τ / (I + m r²)`. */
test("a pinion moves its rack", () => {
    for (const [radius, mass] of [[-0.25, 1], [0.125, 100], [2, 0.1]]) {
        const world = makeWorld(0);
        const [pinion, bar] = [held(world, 0, 0, 1), held(world, 0, 1, mass, v(1, 0))];
        const joint = world.createImpulseJoint(rack(1), pinion, bar, true);
        assert.ok(joint instanceof RAPIER.RackImpulseJoint);
        assert.equal(joint.type(), JointType.Rack);
        assert.ok(!joint.contactsEnabled());
        joint.setRadius(radius);
        assert.equal(joint.radius(), radius);
        torque(pinion, 5 * (inertia(1) + mass * radius ** 2));
        steps(world, 60);
        near(bar.linvel().x, 5 * radius, 0.01 * Math.abs(radius));
        near(spin(pinion), 5, 0.01);
        world.free();
    }
});

/** Two weights: `a₁ = g (m₁ - m₂ / r) / (m₁ + m₂ / r²)`, and the rope pulls the first one by `m₁ (g - a₁)`. */
test("weights on a pulley accelerate", () => {
    for (const [ratio, mass] of [[1, 3], [2, 1], [0.5, 2]]) {
        const world = makeWorld(-10);
        const [first, second] = [[-1, 1], [1, mass]].map(([x, weight]) => insert(world, x, 20, ColliderDesc.ball(0.5).setMass(weight)).body);
        const data = JointData.pulley(v(0, 0.5), v(0, 0.5), v(-1, 40), v(1, 40), 19.5 * (1 + ratio), ratio);
        const joint = world.createImpulseJoint(data, first, second, true);
        assert.ok(joint instanceof RAPIER.PulleyImpulseJoint);
        assert.equal(joint.type(), JointType.Pulley);
        assert.ok(joint.contactsEnabled());
        near(joint.length(), 19.5 * (1 + ratio), 1e-5);
        assert.equal(joint.ratio(), ratio);
        assert.deepEqual([joint.over1().x, joint.over2().x, joint.over2().y], [-1, 1, 40]);
        steps(world, 30);
        const a = 10 * (1 - mass / ratio) / (1 + mass / ratio ** 2);
        near(first.linvel().y, -0.5 * a, 0.02);
        near(second.linvel().y, 0.5 * a / ratio, 0.02);
        near(joint.force().y, ratio * (10 - a), 0.1);
        world.free();
    }
});

test("the rope of a pulley can be wound up, and its wheels can move", () => {
    const world = makeWorld();
    const [first, second] = [-1, 1].map((x) => insert(world, x, 0, ColliderDesc.ball(0.5).setMass(1)).body);
    const joint = world.createImpulseJoint(JointData.pulley(v(0, 0), v(0, 0), v(-1, 5), v(1, 5), 10, 1), first, second, true);
    const height = () => first.translation().y + second.translation().y;
    joint.setLength(9);
    joint.setRatio(1);
    steps(world, 60);
    near(height(), 1, 0.02);
    joint.setOver1(v(-1, 6));
    joint.setOver2(v(1, 7));
    assert.deepEqual([joint.over1().y, joint.over2().y], [6, 7]);
    steps(world, 60);
    near(height(), 4, 0.02);
    world.free();
});

test("gears, racks and pulleys keep their kind in snapshots", () => {
    const world = makeWorld(0);
    const [first, second] = [held(world, 0, 0, 1), held(world, 2, 0, 1)];
    const pulley = JointData.pulley(v(0, 0), v(0, 0), v(0, 5), v(2, 5), 10, 2);
    const joints = [gear(3), rack(2), pulley].map((data) => world.createImpulseJoint(data, first, second, true));
    joints[0].setBacklash(0.25);
    const restored = RAPIER.World.restoreSnapshot(world.takeSnapshot());
    const [one, two, three] = joints.map(({ handle }) => restored.getImpulseJoint(handle));
    assert.ok(one instanceof RAPIER.GearImpulseJoint && two instanceof RAPIER.RackImpulseJoint && three instanceof RAPIER.PulleyImpulseJoint);
    assert.deepEqual([one, two, three].map((joint) => joint.type()), [JointType.Gear, JointType.Rack, JointType.Pulley]);
    assert.deepEqual([one.ratio(), one.backlash(), two.radius(), three.length(), three.ratio()], [3, 0.25, 2, 10, 2]);
    world.free();
    restored.free();
});

test("unusable transmissions are refused by name", () => {
    const world = makeWorld(0);
    const [first, second] = [held(world, 0, 0, 1), held(world, 2, 0, 1)];
    const create = (data) => world.createImpulseJoint(data, first, second, true);
    const pulley = (over, length, ratio) => JointData.pulley(v(0, 0), v(0, 0), over, over, length, ratio);
    for (const wrong of [0, NaN, Infinity, 1e-300, 1e300]) {
        assert.throws(() => create(gear(wrong)), fails("InvalidValue", "ratio", "1e-6 to 1e6"));
        assert.throws(() => create(rack(wrong)), fails("InvalidValue", "radius", "1e-6 to 1e6"));
        assert.throws(() => create(pulley(v(0, 5), 10, wrong)), fails("InvalidValue", "ratio", "1e-6 to 1e6"));
    }
    assert.throws(() => create(pulley(v(0, 5), -1, 1)), fails("InvalidValue", "length", "-1"));
    assert.throws(() => create(pulley(v(0, NaN), 1, 1)), fails("InvalidValue", "over1", "NaN"));
    assert.throws(() => create(DIM === 2 ? JointData.rack(v(0, 0), 1) : JointData.gear(z, v(0, 0), 1)), fails("InvalidValue", "ax", "length"));
    assert.equal(world.impulseJoints.len(), 2);
    const [teeth, bar, rope] = [gear(3), rack(2), pulley(v(0, 5), 10, 2)].map(create);
    assert.throws(() => teeth.setRatio(0), fails("InvalidValue", "ratio is 0"));
    assert.throws(() => teeth.setBacklash(-1), fails("InvalidValue", "angle is -1"));
    assert.throws(() => teeth.setAxisLimits(RAPIER.JointAxis.AngX, -1, 1), fails("InvalidValue"));
    assert.throws(() => bar.setRadius(NaN), fails("InvalidValue", "radius is NaN"));
    assert.throws(() => rope.setLength(-1), fails("InvalidValue", "length is -1"));
    assert.throws(() => rope.setRatio(Infinity), fails("InvalidValue", "ratio"));
    assert.throws(() => rope.setOver1(v(NaN, 0)), fails("InvalidValue", "over"));
    assert.deepEqual([teeth.ratio(), teeth.backlash(), bar.radius(), rope.length(), rope.ratio()], [3, 0, 2, 10, 2]);
    const { body } = insert(world, 5, 5, ColliderDesc.ball(0.5));
    assert.throws(() => world.createMultibodyJoint(gear(1), first, body, true), fails("InvalidValue"));
    world.free();
});
