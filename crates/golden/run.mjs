// Runs the golden scenes as WebAssembly and compares their hashes with the expected ones:
// node run.mjs golden.wasm
// With --time it prints the median processor time of a step in a pile of 1,000 boxes instead:
// node run.mjs --time golden.wasm

import { readFile } from "node:fs/promises";

const paths = process.argv.slice(2).filter((argument) => argument !== "--time");
if (paths.length !== 1) {
    console.error("usage: node run.mjs [--time] golden.wasm");
    process.exit(2);
}
const [path] = paths;
// Processor time does not depend on other programs, wall time does.
function now() {
    const { user, system } = process.cpuUsage();
    return (user + system) / 1000;
}
const { instance } = await WebAssembly.instantiate(await readFile(path), { golden: { now } });
const golden = instance.exports;

function text(length) {
    return new TextDecoder().decode(new Uint8Array(golden.memory.buffer, golden.golden_text(), length));
}

function compare() {
    const expected = new Set(text(golden.golden_expected()).split("\n"));
    const count = golden.golden_count();
    const wrong = [];
    for (let scene = 0; scene < count; scene += 1) {
        const line = text(golden.golden_run(scene));
        if (!expected.has(line)) {
            wrong.push(line);
        }
    }
    console.log(`wasm32, ${path}: ${count - wrong.length} of ${count} as expected`);
    wrong.forEach((line) => console.log(`  ${line}`));
    process.exitCode = wrong.length === 0 ? 0 : 1;
}

function time() {
    for (let pile = 0, length; (length = golden.golden_time(pile)) > 0; pile += 1) {
        console.log(text(length));
    }
}

if (process.argv.includes("--time")) {
    time();
} else {
    compare();
}
