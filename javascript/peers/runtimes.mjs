// Runs one program with the packages in Node.js, Deno and Bun: the same hash everywhere. npm run runtimes

import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

const here = import.meta.dirname;
const binary = (name) => join(here, "node_modules", ".bin", name);
const RUNTIMES = {
    "Node.js": [process.execPath],
    Deno: [binary("deno"), "run", "--allow-read", "--node-modules-dir=manual", "--quiet"],
    Bun: [binary("bun"), "run"],
};

const program = (dimension) => {
    const at = (...components) => components.slice(0, dimension).join(", ");
    return `import RAPIER from "rapier${dimension}d";
await RAPIER.init();
const world = new RAPIER.PhysicsWorld();
world.insert(RAPIER.RigidBodyDesc.fixed(), RAPIER.ColliderDesc.cuboid(${at(20, 1, 20)}));
for (let n = 0; n < 100; n += 1) {
    const place = [n % 10 * 0.9375, 2 + Math.floor(n / 10), 0.125 * (n % 3)].slice(0, ${dimension});
    world.insert(RAPIER.RigidBodyDesc.dynamic().setTranslation(...place), RAPIER.ColliderDesc.ball(0.5));
}
for (let n = 0; n < 300; n += 1) world.step();
console.log(world.hash().toString(16));
`;
};

let failed = false;
for (const dimension of [2, 3]) {
    const folder = mkdtempSync(join(tmpdir(), "runtimes-"));
    mkdirSync(join(folder, "node_modules"));
    symlinkSync(resolve(here, `../../rapier${dimension}d/pkg`), join(folder, "node_modules", `rapier${dimension}d`));
    writeFileSync(join(folder, "package.json"), JSON.stringify({ type: "module" }));
    const file = join(folder, "program.mjs");
    writeFileSync(file, program(dimension));
    const hashes = Object.entries(RUNTIMES).filter(([, [path]]) => existsSync(path)).map(([name, [path, ...options]]) => {
        const hash = execFileSync(path, [...options, file], { cwd: folder, encoding: "utf8" }).trim();
        console.log(`rapier${dimension}d ${name.padEnd(8)} ${hash}`);
        return hash;
    });
    failed ||= new Set(hashes).size !== 1 || hashes.length !== Object.keys(RUNTIMES).length;
    rmSync(folder, { recursive: true });
}
if (failed) {
    console.error("the hashes differ, or a runtime is not installed: npm install");
    process.exitCode = 1;
}
