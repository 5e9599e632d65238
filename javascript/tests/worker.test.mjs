// A world in another thread, and the poses that arrive here.

import assert from "node:assert/strict";
import { once } from "node:events";
import test from "node:test";
import { Worker } from "node:worker_threads";
import { DIM, RAPIER, fails, makeWorld, near } from "./setup.mjs";

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
        assert.equal(bodies(), 3);
        await ask("more");
        await ask("step");
        await ask("step");
        assert.equal(bodies(), 203);
        assert.equal(follower.step, 3);
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

test("a rate that cannot be is refused", () => {
    const world = makeWorld();
    const port = { postMessage() {}, on() {}, off() {} };
    for (const rate of [0, -1, NaN, Infinity]) {
        assert.throws(() => new RAPIER.WorldPublisher(world, port, { rate }), fails("InvalidValue", String(rate)));
    }
    world.free();
});
