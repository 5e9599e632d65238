// Type-checks and runs the programs that were written for the published packages: with these, and with ours.
// Both packages must be built.

import { build } from "esbuild";
import { execFileSync } from "node:child_process";
import { mkdirSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const here = import.meta.dirname;
const require = createRequire(import.meta.url);
const out = join(here, "node_modules/.compat");
mkdirSync(out, { recursive: true });

let failed = false;
for (const dimension of process.argv[2] ? [process.argv[2]] : ["2", "3"]) {
    const ours = join(here, `../../rapier${dimension}d/pkg`);
    const published = join(here, `node_modules/@dimforge/rapier${dimension}d-compat`);
    const packages = {
        published: { types: join(published, "dist/rapier.d.ts"), module: join(published, "dist/rapier.mjs") },
        ours: { types: join(ours, `types/rapier${dimension}.d.ts`), module: join(ours, "rapier.node.mjs") },
    };
    for (const [name, { types, module }] of Object.entries(packages)) {
        const label = `compat${dimension}d with the ${name === "ours" ? "package of this repository" : "published package"}`;
        try {
            const configuration = join(out, `tsconfig.${name}${dimension}.json`);
            writeFileSync(configuration, JSON.stringify({
                compilerOptions: {
                    target: "es2022", module: "esnext", moduleResolution: "bundler", lib: ["es2023", "dom", "esnext.disposable"], types: [],
                    strict: true, noEmit: true, skipLibCheck: name !== "ours", paths: { rapier: [types] },
                },
                files: [join(here, `compat${dimension}d.ts`)],
            }));
            execFileSync(process.execPath, [require.resolve("typescript/bin/tsc"), "-p", configuration], { encoding: "utf8" });
            const outfile = join(out, `${name}${dimension}.mjs`);
            await build({
                entryPoints: [join(here, `compat${dimension}d.ts`)], outfile, bundle: true, format: "esm", platform: "node",
                external: [pathToFileURL(module).href], logLevel: "error",
                plugins: [{ name: "rapier", setup: (setup) => setup.onResolve({ filter: /^rapier$/ }, () => ({ path: pathToFileURL(module).href, external: true })) }],
            });
            const { run } = await import(pathToFileURL(outfile));
            console.log(`${label}: version ${await run()}, type-checks and runs`);
        } catch (error) {
            failed = true;
            console.error(`${label}: ${error.stdout || error.stack}`);
        }
    }
}
process.exitCode = Number(failed);
