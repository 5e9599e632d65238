// The package as a whole: its entries, and its definitions.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
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
        output("-e", `(async () => { const { default: RAPIER } = await import(${entry("rapier.mjs")}); await RAPIER.init(); ${step} })()`),
        output("-e", `(async () => { const RAPIER = await import(${entry("rapier.file.mjs")}); await RAPIER.init({ module: require("fs").readFileSync(${bytes}) }); ${step} })()`),
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

test("the tarball holds what the manifest names, and no address of a registry", async () => {
    const [{ files }] = JSON.parse(await new Promise((resolve, reject) => {
        execFile("npm", ["pack", "--dry-run", "--json"], { cwd: PKG }, (error, stdout) => (error ? reject(error) : resolve(stdout)));
    }));
    const packed = new Set(files.map(({ path }) => path));
    const present = readdirSync(PKG, { recursive: true }).filter((path) => /\.(mjs|cjs|wasm|d\.ts)$|^LICENSE|^README/.test(path));
    assert.deepEqual(present.filter((path) => !packed.has(path)), []);
    const text = readFileSync(join(PKG, "package.json"), "utf8");
    assert.doesNotMatch(text, /registry|resolved|_id|file:|link:|\.\.\//);
    const { engines, sideEffects, private: isPrivate, scripts, dependencies, devDependencies } = JSON.parse(text);
    assert.match(engines.node, /^>=\d/);
    assert.equal(sideEffects, false);
    assert.deepEqual([isPrivate, scripts, dependencies, devDependencies], Array(4).fill(undefined));
});

test("a program that is a CommonJS module compiles against the definitions", async () => {
    const home = join(PKG, "..");
    const folder = mkdtempSync(join(tmpdir(), "commonjs-"));
    try {
        mkdirSync(join(folder, "node_modules"));
        symlinkSync(PKG, join(folder, "node_modules", `rapier${DIM}d`));
        writeFileSync(join(folder, "package.json"), JSON.stringify({ type: "commonjs" }));
        writeFileSync(join(folder, "client.ts"), `import RAPIER = require("rapier${DIM}d");
const world: RAPIER.World = new RAPIER.PhysicsWorld();
export const body: RAPIER.RigidBody = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic());
`);
        writeFileSync(join(folder, "tsconfig.json"), JSON.stringify({
            compilerOptions: { target: "es2022", module: "node16", lib: ["es2022", "dom"], types: [], strict: true, skipLibCheck: false, noEmit: true },
            files: ["client.ts"],
        }));
        const { resolve } = createRequire(join(home, "package.json"));
        await output(resolve("typescript/bin/tsc"), "-p", folder).catch((error) => assert.fail(error.stdout || error.message));
    } finally {
        rmSync(folder, { recursive: true });
    }
});

test("a missing or wrong module says what to do", async () => {
    const page = "data:text/html,<!doctype html>";
    for (const [address, text] of [[page, "is no WebAssembly module"], ["http://127.0.0.1:9/none.wasm", "cannot be fetched"]]) {
        const program = `(async () => { const RAPIER = await import(${entry("rapier.mjs")}); try { await RAPIER.init({ module: ${JSON.stringify(address)} }); } catch (error) { console.log(error.name, error.code, error.message); } })()`;
        assert.match(await output("-e", program), new RegExp(`^RapierError NotInitialized .*${text}.*init\\(\\{ module \\}\\)`, "s"));
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
