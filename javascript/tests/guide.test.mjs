// Runs the programs of docs/guide/javascript.md, those of this dimension. A failed `console.assert` fails the
// test.

import assert from "node:assert/strict";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { pathToFileURL } from "node:url";
import { DIM, PKG } from "./setup.mjs";

const page = readFileSync(join(import.meta.dirname, "../../docs/guide/javascript.md"), "utf8");
const programs = [...page.matchAll(/^```js\n([\s\S]*?)^```/gm)].map(([, program]) => program);
const name = `"rapier${DIM}d"`;
const ours = programs.filter((program) => program.includes(name));
const folder = join(PKG, "../node_modules/.guide");
mkdirSync(folder, { recursive: true });

test("the page has programs of this dimension", () => {
    assert.ok(ours.length > 0);
    assert.ok(programs.every((program) => /"rapier[23]d"/.test(program)));
});

for (const [index, program] of ours.entries()) {
    test(`program ${index + 1} of the guide runs`, async () => {
        const file = join(folder, `program${index}.mjs`);
        const entry = pathToFileURL(join(PKG, "rapier.node.mjs")).href;
        writeFileSync(file, program.replaceAll(name, JSON.stringify(entry)));
        const { assert: original } = console;
        console.assert = (condition, message) => assert.ok(condition, message);
        try {
            await import(`${pathToFileURL(file)}?${Date.now()}`);
        } finally {
            console.assert = original;
        }
    });
}
