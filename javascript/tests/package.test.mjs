// The package as a whole: its entries, and its definitions.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import test from "node:test";
import { DIM, PKG, entry, output } from "./setup.mjs";

const step = `
    const world = new RAPIER.PhysicsWorld();
    world.insert(RAPIER.RigidBodyDesc.dynamic(), RAPIER.ColliderDesc.ball(0.5));
    world.step();
    console.log(world.hash().toString());`;

test("all entries load, and give the same hash", async () => {
    const bytes = JSON.stringify(join(PKG, "rapier.wasm"));
    const hashes = await Promise.all([
        output("-e", `(async () => { const RAPIER = await import(${entry("rapier.node.mjs")}); await RAPIER.init(); ${step} })()`),
        output("-e", `(async () => { const RAPIER = await import(${entry("rapier.node.mjs")}); ${step} })()`),
        output("-e", `const RAPIER = require(${JSON.stringify(join(PKG, "rapier.node.cjs"))}); ${step}`),
        output("-e", `(async () => { const { default: RAPIER } = await import(${entry("rapier.compat.mjs")}); await RAPIER.init(); ${step} })()`),
        output("-e", `(async () => { const RAPIER = await import(${entry("rapier.mjs")}); await RAPIER.init({ module: require("fs").readFileSync(${bytes}) }); ${step} })()`),
    ]);
    assert.match(hashes[0], /^\d+$/);
    assert.equal(new Set(hashes).size, 1, hashes.join());
});

test("without init, other entries say what is missing", async () => {
    const program = `(async () => { const RAPIER = await import(${entry("rapier.mjs")}); try { new RAPIER.PhysicsWorld(); } catch (error) { console.log(error.code, error.message); } })()`;
    assert.match(await output("-e", program), /^NotInitialized .*init/);
});

test("the manifest names files that exist", () => {
    const manifest = JSON.parse(readFileSync(join(PKG, "package.json"), "utf8"));
    const files = (value) => (typeof value === "string" ? [value] : Object.values(value).flatMap(files));
    for (const file of [...files(manifest.exports), manifest.main, manifest.module, manifest.types]) {
        assert.ok(readFileSync(join(PKG, file)).length > 0, file);
    }
});

test("a strict program compiles against the definitions", async () => {
    const home = join(PKG, "..");
    const { resolve } = createRequire(join(home, "package.json"));
    const configuration = join(home, "node_modules", ".tsconfig.client.json");
    writeFileSync(configuration, JSON.stringify({
        compilerOptions: {
            target: "es2022", module: "esnext", moduleResolution: "bundler", lib: ["es2022", "dom"], types: [],
            strict: true, exactOptionalPropertyTypes: true, noUncheckedIndexedAccess: true, skipLibCheck: false, noEmit: true,
            paths: { [`rapier${DIM}d`]: [join(PKG, `types/rapier${DIM}.d.ts`)] },
        },
        files: [join(import.meta.dirname, `client${DIM}d.ts`)],
    }));
    try {
        await output(resolve("typescript/bin/tsc"), "-p", configuration);
    } catch (error) {
        assert.fail(error.stdout || error.message);
    }
});
