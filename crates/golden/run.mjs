// Runs the golden scenes as WebAssembly and compares their hashes with the expected ones: node run.mjs golden.wasm

import { readFile } from "node:fs/promises";

const [path] = process.argv.slice(2);
if (!path) {
    console.error("usage: node run.mjs golden.wasm");
    process.exit(2);
}
const { instance } = await WebAssembly.instantiate(await readFile(path), {});
const golden = instance.exports;

function text(length) {
    return new TextDecoder().decode(new Uint8Array(golden.memory.buffer, golden.golden_text(), length));
}

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
