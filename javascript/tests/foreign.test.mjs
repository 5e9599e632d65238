// Objects of other libraries: vectors whose components are accessors, and proxies of worlds.

import assert from "node:assert/strict";
import test from "node:test";
import { DIM, RAPIER, box, makeGround, v } from "./setup.mjs";

/**
 * An object that has the components of another one as accessors of its prototype, as quaternions of three.js
 * have.
 */
function accessors(components) {
    const getters = Object.keys(components).map((name) => [name, { get: () => components[name] }]);
    return Object.create(Object.create(Object.prototype, Object.fromEntries(getters)));
}

test("components may be accessors", () => {
    const { world } = makeGround();
    const turned = DIM === 2 ? 0.5 : accessors({ x: 0, y: 0, z: 0.6, w: 0.8 });
    const spin = DIM === 2 ? 2 : accessors({ x: 0, y: 2, z: 0 });
    const center = accessors(v(0.25, 0.5));
    const inertia = DIM === 2 ? [2] : [accessors({ x: 1, y: 2, z: 3 }), accessors({ x: 0, y: 0, z: 0, w: 1 })];
    const desc = RAPIER.RigidBodyDesc.dynamic().setRotation(turned).setAngvel(spin);
    const body = world.createRigidBody(desc.setAdditionalMassProperties(2, center, ...inertia));
    const collider = world.createCollider(box(1, 1).setDensity(0).setRotation(turned), body);
    const angle = (rotation) => (DIM === 2 ? rotation : rotation.z);
    assert.equal(angle(body.rotation()), Math.fround(DIM === 2 ? 0.5 : 0.6));
    assert.equal(DIM === 2 ? body.angvel() : body.angvel().y, 2);
    assert.ok(Math.abs(angle(collider.rotationWrtParent()) - (DIM === 2 ? 0.5 : 0.6)) < 1e-6);
    world.step();
    assert.deepEqual([body.localCom().x, body.localCom().y], [0.25, 0.5]);
    world.free();
});

test("a proxy stands for its world", () => {
    const { world, ground } = makeGround();
    const proxy = new Proxy(world, {});
    const body = proxy.createRigidBody(RAPIER.RigidBodyDesc.dynamic());
    const zero = v(0, 0);
    const data = DIM === 2 ? RAPIER.JointData.revolute(zero, zero) : RAPIER.JointData.spherical(zero, zero);
    const joint = proxy.createImpulseJoint(data, ground, body, true);
    proxy.step();
    proxy.removeImpulseJoint(joint, true);
    proxy.removeRigidBody(body);
    assert.equal(world.bodies.len(), 1);
    world.free();
});
