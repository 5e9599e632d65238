// Runs one program with the packages in Node.js, Deno, Bun and a worker of Chromium, on one and on two
// threads: the same hash everywhere. Chromium is left out where it is not installed.
//     npm run runtimes

import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { findChromium } from "../../testbed/tools/chromium.mjs";
import { openBrowser } from "./browser.mjs";

const here = import.meta.dirname;
const binary = (name) => join(here, "node_modules", ".bin", name);
const RUNTIMES = {
    "Node.js": [process.execPath],
    Deno: [binary("deno"), "run", "--allow-read", "--node-modules-dir=manual", "--quiet"],
    Bun: [binary("bun"), "run"],
};

/** A pile of balls. The program imports the engine by a name, and passes its result to a function. */
function program(dimension, threads, engine, report) {
    const at = (...components) => components.slice(0, dimension).join(", ");
    return `import RAPIER from ${JSON.stringify(engine)};
await RAPIER.init({ threads: ${threads} });
const world = new RAPIER.PhysicsWorld();
world.insert(RAPIER.RigidBodyDesc.fixed(), RAPIER.ColliderDesc.cuboid(${at(20, 1, 20)}));
for (let n = 0; n < 600; n += 1) {
    const place = [n % 10 * 0.9375, 2 + Math.floor(n / 10), 0.125 * (n % 3)].slice(0, ${dimension});
    world.insert(RAPIER.RigidBodyDesc.dynamic().setTranslation(...place), RAPIER.ColliderDesc.ball(0.5));
}
for (let n = 0; n < 100; n += 1) world.step();
${report}(world.hash().toString(16) + ", threads: " + RAPIER.threads());
`;
}

/** Runs the program in a process of a runtime, in a folder that has the package installed. */
function runProcess(dimension, threads, [path, ...options]) {
    const folder = mkdtempSync(join(tmpdir(), "runtimes-"));
    mkdirSync(join(folder, "node_modules"));
    symlinkSync(resolve(here, `../../rapier${dimension}d/pkg`), join(folder, "node_modules", `rapier${dimension}d`));
    writeFileSync(join(folder, "package.json"), JSON.stringify({ type: "module" }));
    const file = join(folder, "program.mjs");
    writeFileSync(file, program(dimension, threads, `rapier${dimension}d`, "console.log"));
    try {
        return execFileSync(path, [...options, file], { cwd: folder, encoding: "utf8", timeout: 60_000 }).trim();
    } finally {
        rmSync(folder, { recursive: true });
    }
}

const chromium = findChromium() ? await openBrowser() : null;
if (!chromium) console.log("Chromium is not installed: left out");
let failed = false;
for (const dimension of [2, 3]) {
    const pkg = `rapier${dimension}d/pkg`;
    const hasThreads = existsSync(resolve(here, "../..", pkg, "rapier_threads.wasm"));
    if (!hasThreads) console.log(`rapier${dimension}d has no module with threads: build_all.sh --threads makes it`);
    const hashes = new Set();
    for (const threads of hasThreads ? [1, 2] : [1]) {
        const found = Object.entries(RUNTIMES).map(([name, runtime]) => [name, runProcess(dimension, threads, runtime)]);
        if (chromium) {
            const worker = (address) => program(dimension, threads, `${address}${pkg}/rapier.mjs`, "postMessage");
            found.push(["Chromium", await chromium.runWorker(worker)]);
        }
        for (const [name, report] of found) {
            console.log(`rapier${dimension}d ${name.padEnd(8)} ${report}`);
            hashes.add(report.split(",")[0]);
            failed ||= !report.endsWith(`threads: ${threads}`);
        }
    }
    failed ||= hashes.size !== 1;
}
await chromium?.close();
if (failed) {
    console.error("the hashes differ, or a runtime used another number of threads");
    process.exitCode = 1;
}
