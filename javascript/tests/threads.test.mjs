// Steps on several threads: the bits of one thread, hooks, and starts that fail.

import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { DIM, PKG, RAPIER, entry, output } from "./setup.mjs";

const hasThreads = existsSync(join(PKG, "rapier_threads.wasm"));
const skip = !hasThreads && "this build has no module with threads: build_all.sh --threads makes it";

/** Runs the scene of threads_child.mjs in a process of its own. */
async function result(threads, hooks = "") {
    return JSON.parse(await output(join(import.meta.dirname, "threads_child.mjs"), DIM, threads, hooks));
}

/** Runs a program with an engine that is not loaded yet, in a process of its own. */
function run(program) {
    return output("--input-type=module", "-e", `import * as RAPIER from ${entry("rapier.node.mjs")};${program}`);
}

test("the number of threads changes no bit", { skip }, async () => {
    const one = await result(1);
    assert.equal(one.threads, 1);
    for (const count of [2, 3]) {
        assert.deepEqual(await result(count), { ...one, threads: count });
    }
});

test("hooks run while other threads exist, and change no bit", { skip }, async () => {
    const [one, three] = await Promise.all([result(1, "hooks"), result(3, "hooks")]);
    assert.ok(one.calls > 0);
    assert.deepEqual(three, { ...one, threads: 3 });
});

test("two calls of init wait for the same threads", { skip }, async () => {
    const program = `
        const first = RAPIER.init({ threads: 3 });
        await RAPIER.init();
        console.log(RAPIER.threads());
        await first;
        console.log(RAPIER.threads());`;
    assert.equal(await run(program), "3\n3");
});

test("a use before the end of init is an error of init, and the engine works", { skip }, async () => {
    const program = `
        const start = RAPIER.init({ threads: 2 });
        const world = new RAPIER.PhysicsWorld();
        await start.catch((error) => console.log(error.code));
        world.step();
        await RAPIER.init();
        console.log(RAPIER.threads());`;
    assert.equal(await run(program), "NotInitialized\n1");
});

test("a module without threads uses one", async () => {
    const file = JSON.stringify(join(PKG, "rapier_simd.wasm"));
    const program = `
        import { readFileSync } from "node:fs";
        await RAPIER.init({ threads: 2, module: readFileSync(${file}) });
        new RAPIER.PhysicsWorld().step();
        console.log(RAPIER.threads());`;
    assert.equal(await run(program), "1");
});

test("a package without the module uses one thread", { skip: hasThreads && "this build has the module" }, async () => {
    assert.equal(await run("await RAPIER.init({ threads: 0 }); new RAPIER.PhysicsWorld().step(); console.log(RAPIER.threads());"), "1");
});

test("views stay valid when shared memory grows", { skip }, async () => {
    const program = `
        await RAPIER.init({ threads: 2 });
        const world = new RAPIER.PhysicsWorld();
        world.insert(RAPIER.RigidBodyDesc.dynamic(), RAPIER.ColliderDesc.ball(0.5));
        const views = world.views;
        world.step();
        const before = views.poses[1];
        RAPIER.reserveMemory(64 << 20);
        world.step();
        console.log(views.poses[1] < before, views.poses.buffer.byteLength > 64 << 20);`;
    assert.equal(await run(program), "true true");
});

test("numbers of threads that cannot be are refused", async () => {
    assert.equal(RAPIER.threads(), 1);
    for (const threads of ["-1", "1.5", "65", "NaN"]) {
        const program = `await RAPIER.init({ threads: ${threads} }).catch(({ code, message }) => console.log(code, message));`;
        assert.match(await run(program), new RegExp(`^InvalidValue threads is ${threads},`));
    }
});
