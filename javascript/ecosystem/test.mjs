// Type-checks and runs scenes of @react-three/rapier and of three.js's addon with the package of this
// repository in place of the published one. It must be built.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, realpathSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { build } from "esbuild";

const here = import.meta.dirname;
const require = createRequire(import.meta.url);
const out = join(here, "node_modules/.ecosystem");
mkdirSync(out, { recursive: true });
const OURS = "@dimforge/rapier3d-compat";
assert.equal(realpathSync(join(here, "node_modules", OURS)), join(here, "../../rapier3d/pkg"), "npm took the package of this repository");

/** Checks the scene, and the definitions of the library against ours. Other libraries are not checked. */
function checkTypes() {
    const configuration = join(out, "tsconfig.json");
    writeFileSync(configuration, JSON.stringify({
        compilerOptions: {
            target: "es2022", module: "esnext", moduleResolution: "bundler", jsx: "react-jsx", lib: ["es2023", "dom", "dom.iterable", "esnext.disposable"],
            types: [], strict: true, noEmit: true, skipLibCheck: false,
        },
        files: [join(here, "scene.tsx")],
    }));
    try {
        execFileSync(process.execPath, [require.resolve("typescript/bin/tsc"), "-p", configuration], { encoding: "utf8", cwd: here });
    } catch ({ stdout }) {
        const errors = stdout.split("\n").filter((line) => /^(scene\.tsx|node_modules\/@react-three\/rapier\/|.*rapier3d\/pkg\/)/.test(line));
        assert.deepEqual(errors, [], stdout);
    }
}

/**
 * The addon downloads the published package: this puts ours in its place, as an import map does on a page.
 */
const redirect = {
    name: "redirect",
    setup(setup) {
        setup.onResolve({ filter: /RapierPhysics\.js$/ }, () => ({ path: join(here, "node_modules/three/examples/jsm/physics/RapierPhysics.js") }));
        setup.onLoad({ filter: /RapierPhysics\.js$/ }, ({ path }) => {
            const text = readFileSync(path, "utf8");
            const redirected = text.replace(/'https:[^']*rapier3d-compat[^']*'/, JSON.stringify(OURS));
            assert.notEqual(redirected, text, "the addon names the published package");
            return { contents: redirected, loader: "js" };
        });
    },
};

async function load(file) {
    const outfile = join(out, `${file.replace(/\W/g, "_")}.mjs`);
    await build({
        entryPoints: [join(here, file)], outfile, bundle: true, format: "esm", platform: "node", jsx: "automatic", logLevel: "error", plugins: [redirect],
        external: [OURS, "react", "react-dom", "three", "@react-three/fiber", "@react-three/rapier"],
    });
    return import(pathToFileURL(outfile));
}

const near = (actual, expected, tolerance) => assert.ok(Math.abs(actual - expected) <= tolerance, `${actual} is not near ${expected}`);

// Node.js has no frames.
globalThis.IS_REACT_ACT_ENVIRONMENT = true;
globalThis.requestAnimationFrame ??= (run) => setTimeout(() => run(performance.now()), 16);
globalThis.cancelAnimationFrame ??= clearTimeout;

checkTypes();
console.log("@react-three/rapier: type-checks");
const react = await (await load("scene.tsx")).run();
near(react.ball, 0.5, 0.05);
near(react.crate, 0.5, 0.05);
react.stones.forEach((height, index) => near(height, 0.5 + index, 0.15));
assert.ok(react.pendulum < 9.99 && react.pendulum > 7, "the pendulum hangs on its joint");
assert.equal(react.anchor, 10, "an empty body carries a rope");
assert.ok(react.weight > 7.9 && react.weight < 10, "the weight hangs on its rope");
assert.ok(react.entered >= 1 && react.contacts >= 3, "sensors and collisions are reported");
near(react.hit, 5, 0.01);
console.log("@react-three/rapier: runs", JSON.stringify(react));
const three = await (await load("addon.mjs")).run();
near(three.ball, 0.5, 0.05);
three.boxes.forEach((height) => near(height, 0.5, 0.05));
console.log("three.js's RapierPhysics: runs", JSON.stringify(three));
process.exit(0);
