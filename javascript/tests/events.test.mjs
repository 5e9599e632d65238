// Events and hooks.

import assert from "node:assert/strict";
import test from "node:test";
import { RAPIER, fails, insert, box, makeGround, near, steps, v } from "./setup.mjs";

const { ActiveEvents, ActiveHooks, ColliderDesc, EventQueue, SolverFlags } = RAPIER;

test("collisions start and stop", () => {
    const { world, collider: ground } = makeGround();
    const queue = new EventQueue(true);
    const { body, collider } = insert(world, 0, 0.6, ColliderDesc.ball(0.5).setActiveEvents(ActiveEvents.COLLISION_EVENTS));
    const events = [];
    const record = () => queue.drainCollisionEvents((one, other, started) => events.push([[one, other].sort(), started]));
    for (let step = 0; step < 30; step += 1) {
        world.step(queue);
        record();
    }
    body.setTranslation(v(0, 5), true);
    for (let step = 0; step < 2; step += 1) {
        world.step(queue);
        record();
    }
    const pair = [ground.handle, collider.handle].sort();
    assert.deepEqual(events, [[pair, true], [pair, false]]);
    queue.free();
    assert.throws(() => queue.clear(), fails("Freed", "event queue"));
    assert.throws(() => world.step(queue), fails("Freed", "event queue"));
    world.free();
});

test("contact forces carry the weight", () => {
    const { world } = makeGround();
    const queue = new EventQueue(false);
    const desc = box(0.5, 0.5).setActiveEvents(ActiveEvents.CONTACT_FORCE_EVENTS);
    const { body, collider } = insert(world, 0, 0.5, desc);
    steps(world, 20);
    world.step(queue);
    const forces = [];
    let kept;
    queue.drainContactForceEvents((event) => {
        kept = event;
        assert.ok([event.collider1(), event.collider2()].includes(collider.handle));
        near(Math.abs(event.totalForce().y), event.totalForceMagnitude(), 1e-3);
        near(Math.abs(event.maxForceDirection().y), 1, 1e-3);
        assert.ok(event.maxForceMagnitude() > 0);
        forces.push(event.totalForceMagnitude());
    });
    assert.equal(forces.length, 1);
    near(forces[0], 9.81 * body.mass(), 0.05 * 9.81 * body.mass());
    assert.throws(() => kept.totalForce(), fails("Freed"));
    queue.free();
    world.free();
});

test("a hook lets pairs through", () => {
    const { world, ground } = makeGround();
    const { body } = insert(world, 0, 1, ColliderDesc.ball(0.5).setActiveHooks(ActiveHooks.FILTER_CONTACT_PAIRS));
    const solid = insert(world, 5, 1, ColliderDesc.ball(0.5).setActiveHooks(ActiveHooks.FILTER_CONTACT_PAIRS));
    let seen = 0;
    const hooks = {
        filterContactPair(_collider1, _collider2, body1, body2) {
            seen += 1;
            // Hooks read bodies while the step runs.
            assert.equal(ground.translation().y, -1);
            return [body1, body2].includes(body.handle) ? null : SolverFlags.COMPUTE_IMPULSE;
        },
        filterIntersectionPair: () => true,
    };
    steps(world, 60, undefined, hooks);
    assert.ok(seen > 0);
    assert.ok(body.translation().y < -1);
    near(solid.body.translation().y, 0.5, 0.02);
    world.free();
});

test("a filter leaves contacts without forces", () => {
    const { world, ground, collider: floor } = makeGround();
    const desc = ColliderDesc.ball(0.5).setActiveHooks(ActiveHooks.FILTER_CONTACT_PAIRS).setActiveEvents(ActiveEvents.COLLISION_EVENTS);
    const { body, collider } = insert(world, 0, 1, desc);
    const queue = new EventQueue(true);
    const events = [];
    for (let step = 0; step < 40; step += 1) {
        world.step(queue, { filterContactPair: () => SolverFlags.EMPTY });
        queue.drainCollisionEvents((_one, _other, started) => events.push(started));
    }
    assert.deepEqual(events, [true]);
    let contacts = 0;
    world.contactPair(collider, floor, (manifold) => (contacts += manifold.numContacts()));
    assert.ok(contacts > 0);
    assert.ok(body.translation().y < ground.translation().y + 1);
    queue.free();
    world.free();
});

test("hooks change contacts", () => {
    const { world } = makeGround();
    const belt = box(0.5, 0.5).setFriction(1).setActiveHooks(ActiveHooks.MODIFY_SOLVER_CONTACTS);
    const { body } = insert(world, 0, 0.5, belt);
    const hooks = {
        modifySolverContacts(contacts) {
            assert.ok(contacts.numContacts > 0);
            near(Math.abs(contacts.normal.y), 1, 1e-3);
            contacts.tangentVelocity = v(2, 0);
        },
    };
    steps(world, 90, undefined, hooks);
    near(Math.abs(body.linvel().x), 2, 0.05);
    world.free();
});

test("a hook cannot change the world, and its exception ends no step", () => {
    const { world, ground } = makeGround();
    const { body } = insert(world, 0, 0.5, ColliderDesc.ball(0.5).setActiveHooks(ActiveHooks.FILTER_CONTACT_PAIRS));
    let caught;
    const hooks = {
        filterContactPair() {
            try {
                ground.setTranslation(v(0, 0), true);
            } catch (error) {
                caught = error;
            }
            throw new Error("of the hook");
        },
    };
    assert.throws(() => world.step(undefined, hooks), /of the hook/);
    assert.ok(fails("Busy", "step")(caught));
    world.step();
    assert.ok(Number.isFinite(body.translation().y));
    world.free();
});

test("a hook can neither free nor use the queue of its step", () => {
    const { world } = makeGround();
    const other = makeGround().world;
    const queue = new EventQueue(true);
    const desc = ColliderDesc.ball(0.5).setActiveEvents(ActiveEvents.COLLISION_EVENTS).setActiveHooks(ActiveHooks.FILTER_CONTACT_PAIRS);
    insert(world, 0, 0.45, desc);
    const calls = [() => queue.free(), () => queue.clear(), () => queue.takeCollisionEvents(), () => other.step(queue)];
    let refused = 0;
    const hooks = {
        filterContactPair() {
            for (const call of calls) {
                assert.throws(call, fails("Busy", "event queue"));
                refused += 1;
            }
            other.step();
            return SolverFlags.COMPUTE_IMPULSE;
        },
    };
    world.step(queue, hooks);
    assert.ok(refused >= calls.length);
    // A rejected step keeps all events.
    other.free();
    assert.throws(() => other.step(queue), fails("Freed", "world"));
    assert.equal(queue.takeCollisionEvents().length, 3);
    queue.free();
    queue.free();
    world.free();
});

test("an exception of a hook leaves contacts as they are", () => {
    const { world, ground } = makeGround();
    const { body } = insert(world, 0, 0.5, box(0.5, 0.5).setActiveHooks(ActiveHooks.MODIFY_SOLVER_CONTACTS));
    let thrown = 0;
    const hooks = {
        modifySolverContacts() {
            ground.translation();
            throw new Error("of the hook");
        },
    };
    for (let step = 0; step < 40; step += 1) {
        try {
            world.step(undefined, hooks);
        } catch (error) {
            assert.match(error.message, /of the hook/);
            thrown += 1;
        }
    }
    assert.ok(thrown > 20);
    near(body.translation().y, 0.5, 0.02);
    near(body.linvel().x, 0, 1e-3);
    world.free();
});

test("contacts keep numbers of 32 bits", () => {
    const { world } = makeGround();
    insert(world, 0, 0.5, box(0.5, 0.5).setActiveHooks(ActiveHooks.MODIFY_SOLVER_CONTACTS));
    for (const number of [16777217, 0xffffffff, 0x12345678]) {
        let seen;
        const hooks = {
            modifySolverContacts(contacts) {
                seen = contacts.userData;
                contacts.userData = number;
            },
        };
        steps(world, 2, undefined, hooks);
        assert.equal(seen, number);
    }
    world.free();
});
