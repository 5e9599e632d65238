// Runs the tests of a package: node test.mjs DIMENSION. The package must be built.

import { execFileSync, spawnSync } from "node:child_process";
import { readdirSync } from "node:fs";
import { join } from "node:path";

const [dimension] = process.argv.slice(2);
const here = import.meta.dirname;
if (here === undefined) {
    console.error(`The JavaScript packages need Node.js 20.11 or later. Here: ${process.version}`);
    process.exit(1);
}
const tests = readdirSync(join(here, "tests")).filter((name) => name.endsWith(".test.mjs")).map((name) => join(here, "tests", name));
const result = spawnSync(process.execPath, ["--expose-gc", "--test", ...tests], {
    stdio: "inherit",
    env: { ...process.env, DIMENSION: dimension },
});
process.exitCode = result.status ?? 1;
