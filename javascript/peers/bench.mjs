// Times the steps of all scenes with each engine: node bench.mjs [DIMENSION] [ROUNDS] [--browser]. Prints a
// table of milliseconds per step: of processor time in Node.js, of wall-clock time in Chromium. Each
// measurement is a process or a page of its own. Rounds take turns, and the smallest time of a scene counts;
// each round prints the table so far.

import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import { openBrowser } from "./browser.mjs";
import { ENGINES } from "./engines.mjs";
import { measure } from "./measure.mjs";
import { SCENES } from "./scenes.mjs";

const browses = process.argv.includes("--browser");
const [first, second, third, fourth] = process.argv.slice(2).filter((argument) => !argument.startsWith("--"));

function processorTime() {
    const { user, system } = process.cpuUsage();
    return (user + system) / 1000;
}

function measureInNode(...what) {
    const output = execFileSync(process.execPath, [fileURLToPath(import.meta.url), "measure", ...what], { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
    return Number(output.trim().split("\n").at(-1));
}

function print(dimension, engines, times) {
    console.log(`\n| ${dimension}D, ms per step, ${browses ? "Chromium" : "Node.js"} | ${engines.join(" | ")} |`);
    console.log(`|---|${engines.map(() => "--:|").join("")}`);
    for (const [scene, row] of Object.entries(times)) {
        console.log(`| ${scene} | ${row.map((time) => (Number.isFinite(time) ? time.toFixed(time < 1 ? 3 : time < 10 ? 2 : 1) : "failed")).join(" | ")} |`);
    }
}

async function compare(dimension, rounds, take) {
    const engines = Object.keys(ENGINES[dimension]);
    const times = Object.fromEntries(Object.keys(SCENES).map((scene) => [scene, engines.map(() => Infinity)]));
    for (let round = 0; round < rounds; round += 1) {
        for (const [scene, row] of Object.entries(times)) {
            for (const [column, engine] of engines.entries()) {
                try {
                    row[column] = Math.min(row[column], await take(dimension, engine, scene));
                } catch (error) {
                    console.error(`${engine}, ${scene}: ${error.stderr || error.message}`);
                }
            }
        }
        print(dimension, engines, times);
    }
}

if (first === "measure") {
    const time = await measure(Number(second), third, fourth, processorTime);
    process.stdout.write(String(time), () => process.exit(0));
} else {
    const browser = browses ? await openBrowser() : null;
    for (const dimension of first ? [Number(first)] : [3, 2]) {
        await compare(dimension, Number(second ?? 3), browser ? browser.measure : measureInNode);
    }
    await browser?.close();
}
