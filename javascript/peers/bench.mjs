// Times the steps of five scenes with each engine: node bench.mjs [DIMENSION] [ROUNDS]. Prints a table of milliseconds of processor time per step.
// Each measurement is a process of its own. Rounds take turns, and the smallest time of a scene counts.

import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import { ENGINES } from "./engines.mjs";
import { SCENES } from "./scenes.mjs";

const STEPS = 200;
const WARM = 20;

const [first, second, third, fourth] = process.argv.slice(2);
if (first === "measure") {
    const dimension = Number(second);
    const { step, height } = await ENGINES[dimension][third](dimension, SCENES[fourth](dimension));
    for (let count = 0; count < WARM; count += 1) step();
    const start = process.cpuUsage();
    for (let count = 0; count < STEPS; count += 1) step();
    const { user, system } = process.cpuUsage(start);
    const result = height();
    if (!Number.isFinite(result)) {
        throw new Error(`the scene ended at a height of ${result}`);
    }
    process.stdout.write(String((user + system) / 1000 / STEPS), () => process.exit(0));
} else {
    const rounds = Number(second ?? 3);
    for (const dimension of first ? [Number(first)] : [3, 2]) {
        const engines = Object.keys(ENGINES[dimension]);
        const times = Object.fromEntries(Object.keys(SCENES).map((scene) => [scene, engines.map(() => Infinity)]));
        for (let round = 0; round < rounds; round += 1) {
            for (const [scene, row] of Object.entries(times)) {
                engines.forEach((engine, column) => {
                    try {
                        const output = execFileSync(process.execPath, [fileURLToPath(import.meta.url), "measure", dimension, engine, scene], { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
                        row[column] = Math.min(row[column], Number(output.trim().split("\n").at(-1)));
                    } catch (error) {
                        console.error(`${engine}, ${scene}: ${error.stderr || error.message}`);
                    }
                });
            }
        }
        console.log(`\n| ${dimension}D, ms per step | ${engines.join(" | ")} |`);
        console.log(`|---|${engines.map(() => "--:|").join("")}`);
        for (const [scene, row] of Object.entries(times)) {
            console.log(`| ${scene} | ${row.map((time) => (Number.isFinite(time) ? time.toFixed(time < 10 ? 2 : 1) : "failed")).join(" | ")} |`);
        }
    }
}
