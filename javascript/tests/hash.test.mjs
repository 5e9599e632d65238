// The same scene gives the same hash natively and in WebAssembly, with and without SIMD.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { join } from "node:path";
import test from "node:test";
import { promisify } from "node:util";
import { DIM, output } from "./setup.mjs";

const root = join(import.meta.dirname, "../..");

const hash = (lanes, steps) => output(join(import.meta.dirname, "hash_child.mjs"), DIM, lanes, steps);

// In the profile for tests: it is built already, and gives the same bits as a release build.
async function nativeHash(steps) {
    const cargo = ["run", "--quiet", "-p", "rapier-wasm", "--bin", "native-hash", "--no-default-features", "--features", `dim${DIM}`];
    const { stdout } = await promisify(execFile)("cargo", [...cargo, "--", steps], { cwd: root });
    return stdout.trim();
}

test("SIMD and scalar code give the same hash", async () => {
    const [simd, scalar] = await Promise.all([hash("simd", "1000"), hash("scalar", "1000")]);
    assert.match(simd, /^[0-9a-f]{16}$/);
    assert.equal(simd, scalar);
    assert.notEqual(simd, await hash("simd", "100"));
});

test("native code gives the same hash", { skip: process.env.RAPIER_NATIVE === "0" && "left out by RAPIER_NATIVE=0" }, async () => {
    assert.equal(await hash("simd", "1000"), await nativeHash("1000"));
});
