// Steps on several threads: the bits of one thread, hooks, and what the platform refuses.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { existsSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { promisify } from "node:util";
import { DIM, PKG, RAPIER } from "./setup.mjs";

const run = promisify(execFile);
const skip = !existsSync(join(PKG, "rapier_threads.wasm")) && "this build has no module with threads: build_all.sh without --fast makes it";

/** Runs the scene of threads_child.mjs in a process of its own. */
async function result(threads, hooks = "") {
    const { stdout } = await run(process.execPath, [join(import.meta.dirname, "threads_child.mjs"), DIM, threads, hooks]);
    return JSON.parse(stdout);
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

test("numbers of threads that cannot be are refused", async () => {
    assert.equal(RAPIER.threads(), 1);
    const { default: other } = await import(`${new URL(`file://${join(PKG, "rapier.node.mjs")}`).href}?threads`);
    for (const threads of [-1, 1.5, 65, NaN]) {
        await assert.rejects(other.init({ threads }), (error) => error.code === "InvalidValue" && error.message.includes(String(threads)));
    }
    await other.init({ threads: 1 });
    assert.equal(other.threads(), 1);
});
