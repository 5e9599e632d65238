// A world in another thread, and the poses that arrive here.

import assert from "node:assert/strict";
import { once } from "node:events";
import test from "node:test";
import { Worker } from "node:worker_threads";
import { DIM, RAPIER, box, fails, insert, makeGround, makeWorld, near } from "./setup.mjs";

const ANGLE = DIM === 2 ? 2 : 5;

/** Starts a worker, and follows its world. */
async function start(data) {
    const worker = new Worker(new URL("./worker_world.mjs", import.meta.url), { workerData: { count: 200, ...data } });
    const follower = new RAPIER.WorldFollower(worker);
    const answer = async (wanted) => {
        for (;;) {
            const [message] = await once(worker, "message");
            if (message.done === wanted) return message;
        }
    };
    const ask = async (what) => {
        const answered = answer(what);
        worker.postMessage({ ask: what });
        return answered;
    };
    const { spinner } = await answer("begin");
    const stop = async () => {
        const ended = once(worker, "exit");
        worker.postMessage({ ask: "stop" });
        follower.free();
        await ended;
    };
    return { follower, ask, stop, slot: RAPIER.bodyIndex(spinner) };
}

/** Twice the angle's half about z: the component of the rotation that grows with it. */
const angleOf = (poses, slot, stride) => {
    const value = poses[slot * stride + ANGLE];
    return DIM === 2 ? value : 2 * Math.asin(value);
};

for (const shared of [true, false]) {
    test(`poses lie between the last two steps (${shared ? "shared memory" : "messages"})`, async () => {
        const { follower, ask, stop, slot } = await start({ shared });
        assert.equal(follower.step, 0);
        assert.equal(follower.poses().length, 0);
        for (let step = 0; step < 10; step += 1) await ask("step");
        assert.equal(follower.step, 10);
        assert.equal(follower.isShared(), shared);
        const stride = follower.poseStride;
        const [before, after] = [-1e9, 1e18].map((time) => follower.poses(time).slice());
        near(angleOf(before, slot, stride), (9 * 3) / 60, 1e-3);
        near(angleOf(after, slot, stride), (10 * 3) / 60, 1e-3);
        const falling = (slot + 1) * stride + 1;
        assert.ok(after[falling] < before[falling]);
        assert.equal(follower.poses(), follower.poses(), "frames create no array");
        await stop();
    });

    test(`a world that grows stays visible (${shared ? "shared memory" : "messages"})`, async () => {
        const { follower, ask, stop, slot } = await start({ shared });
        await ask("step");
        const bodies = () => follower.handles.filter((handle) => !Number.isNaN(handle)).length;
        assert.equal(follower.step, 1);
        assert.equal(bodies(), 3);
        await ask("more");
        await ask("step");
        await ask("step");
        assert.equal(bodies(), 3, "handles belong to the step of the last call");
        assert.equal(follower.step, 3);
        assert.equal(bodies(), 203);
        near(angleOf(follower.poses(1e18), slot, follower.poseStride), (3 * 3) / 60, 1e-3);
        await stop();
    });
}

test("a worker steps by itself", async () => {
    const { follower, stop } = await start({ rate: 500, shared: true });
    while (follower.step < 5) {
        await new Promise((resolve) => setTimeout(resolve, 1));
    }
    assert.ok(follower.poses().every(Number.isFinite));
    await stop();
});

/** Two connected ports that deliver each message at once. */
function makePorts() {
    const [one, other] = [[], []].map((listeners) => ({
        listeners,
        on: (_, listener) => listeners.push(listener),
        off: (_, listener) => listeners.splice(listeners.indexOf(listener), 1),
    }));
    one.postMessage = (message) => other.listeners.forEach((listener) => listener(message));
    other.postMessage = (message) => one.listeners.forEach((listener) => listener(message));
    return [one, other];
}

test("memory that grows delivers only steps that it contains", () => {
    const { world } = makeGround();
    const [inner, outer] = makePorts();
    let memory;
    outer.on("message", ({ rapier, buffer }) => {
        if (rapier === "shared") memory = buffer;
    });
    const publisher = new RAPIER.WorldPublisher(world, inner, { shared: true });
    const follower = new RAPIER.WorldFollower(outer);
    publisher.step();
    assert.equal(follower.step, 1);
    const small = memory;
    for (let number = 0; number < 200; number += 1) insert(world, 5 + 2 * number, 20, box(0.5, 0.5));
    publisher.step();
    assert.notEqual(memory, small, "the memory has grown");
    // The header counts a third step, which the memory does not contain.
    new Int32Array(memory, 0, 2).fill(3);
    assert.equal(follower.step, 2);
    assert.equal(follower.handles.filter((handle) => !Number.isNaN(handle)).length, 201);
    publisher.step();
    assert.equal(follower.step, 3);
    world.free();
});

for (const [before, after] of [[true, true], [true, false], [false, true], [false, false]]) {
    test(`a second publisher takes over (shared memory: ${before}, then ${after})`, () => {
        const { world } = makeGround();
        const { body } = insert(world, 0, 20, box(0.5, 0.5));
        const [inner, outer] = makePorts();
        const follower = new RAPIER.WorldFollower(outer);
        const first = new RAPIER.WorldPublisher(world, inner, { shared: before });
        for (let step = 0; step < 10; step += 1) first.step();
        assert.equal(follower.step, 10);
        first.free();
        const second = new RAPIER.WorldPublisher(world, inner, { shared: after });
        for (let step = 1; step < 4; step += 1) {
            second.step();
            assert.equal(follower.step, step);
        }
        assert.equal(follower.isShared(), after);
        const height = follower.poses(1e18)[RAPIER.bodyIndex(body.handle) * follower.poseStride + 1];
        near(height, body.translation().y, 1e-6);
        world.free();
    });
}

/** Milliseconds per step of the publishers with a clock. */
const INTERVAL = 8;

/**
 * A publisher whose timers run by a clock of the test. `act` is called in each step, with its number from 1.
 */
function makeClocked(t, act) {
    const { world } = makeGround();
    const timers = new Map();
    let [now, made] = [1000, 0];
    t.mock.method(performance, "now", () => now);
    t.mock.method(globalThis, "setTimeout", (run, delay) => {
        made += 1;
        timers.set(made, { run, due: now + delay });
        return made;
    });
    t.mock.method(globalThis, "clearTimeout", (timer) => timers.delete(timer));
    const advance = (time) => {
        now += time;
        for (const [timer, { run, due }] of [...timers]) {
            if (due <= now && timers.delete(timer)) run();
        }
    };
    const count = { begun: 0, published: 0, timers: () => timers.size };
    const port = { postMessage: ({ rapier }) => (count.published += Number(rapier === "step")), on() {}, off() {} };
    const beforeStep = () => act?.((count.begun += 1), { publisher, world });
    const publisher = new RAPIER.WorldPublisher(world, port, { rate: 1000 / INTERVAL, shared: false, beforeStep });
    publisher.start();
    return { publisher, world, count, advance };
}

test("late steps are made up for, up to a bound", (t) => {
    const { publisher, world, count, advance } = makeClocked(t);
    assert.equal(count.published, 1);
    for (const [time, total] of [[INTERVAL, 2], [INTERVAL / 2, 2], [INTERVAL / 2, 3], [3 * INTERVAL, 6], [100 * INTERVAL, 11], [INTERVAL, 12]]) {
        advance(time);
        assert.equal(count.published, total);
    }
    publisher.free();
    assert.equal(count.timers(), 0);
    world.free();
});

test("a step stops the publisher", (t) => {
    const { world, count, advance } = makeClocked(t, (number, { publisher }) => {
        if (number === 3) publisher.stop();
    });
    advance(4 * INTERVAL);
    assert.equal(count.published, 3);
    assert.equal(count.timers(), 0);
    world.free();
});

test("a step frees the publisher and its world", (t) => {
    const { count, advance } = makeClocked(t, (number, { publisher, world }) => {
        if (number === 3) {
            publisher.free();
            world.free();
        }
    });
    advance(4 * INTERVAL);
    assert.equal(count.begun, 3);
    assert.equal(count.published, 2);
    assert.equal(count.timers(), 0);
});

test("a start in a step leaves one loop", (t) => {
    const { world, count, advance } = makeClocked(t, (number, { publisher }) => {
        if (number === 2) publisher.start();
    });
    advance(INTERVAL);
    assert.equal(count.timers(), 1);
    assert.equal(count.published, 3);
    advance(INTERVAL);
    assert.equal(count.published, 4);
    world.free();
});

test("a step of a freed world is refused", () => {
    const world = makeWorld();
    const port = { postMessage() {}, on() {}, off() {} };
    const publisher = new RAPIER.WorldPublisher(world, port, { beforeStep() {} });
    world.free();
    assert.throws(() => publisher.step(), fails("Freed"));
});

test("a rate that cannot be is refused", () => {
    const world = makeWorld();
    const port = { postMessage() {}, on() {}, off() {} };
    for (const rate of [0, -1, NaN, Infinity]) {
        assert.throws(() => new RAPIER.WorldPublisher(world, port, { rate }), fails("InvalidValue", String(rate)));
    }
    world.free();
});
