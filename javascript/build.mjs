// Builds the JavaScript of a package: node build.mjs DIMENSION PKG [64]. The folder holds the WebAssembly
// modules already.

import { copyFileSync, cpSync, existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { execFileSync } from "node:child_process";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { deflateSync } from "node:zlib";

const [dimension, pkg, bits = "32"] = process.argv.slice(2);
const here = import.meta.dirname;
const home = resolve(pkg, "..");
const require = createRequire(pathToFileURL(join(home, "package.json")));
const { build } = require("esbuild");
const manifest = JSON.parse(readFileSync(join(home, "package.json"), "utf8"));
const source = (name) => join(here, "src", name);

execFileSync(process.execPath, [join(here, "generate.mjs"), source("functions.ts")]);

const alias = Object.fromEntries(
    ["dim", "rigid_body", "collider_desc", "shape", "world"].map((name) => [`#${name}`, source(`${name}${dimension}.ts`)]),
);
alias["#real"] = source(`real${bits}.ts`);
alias["#entry"] = source(`rapier${dimension}.ts`);

const hasThreads = existsSync(join(pkg, "rapier_threads.wasm"));
/** The program of the workers, as a text. */
const { outputFiles: [threadProgram] } = await build({
    entryPoints: [source("thread_worker.ts")], bundle: true, minify: true, format: "iife", target: "es2022", write: false, logLevel: "warning",
});

async function bundle(entry, outfile, options = {}) {
    await build({
        entryPoints: [source(entry)],
        outfile: join(pkg, outfile),
        bundle: true,
        minify: true,
        keepNames: false,
        format: "esm",
        target: "es2022",
        alias,
        legalComments: "none",
        logLevel: "warning",
        ...options,
        define: {
            VERSION: JSON.stringify(manifest.version),
            HAS_THREADS: String(hasThreads),
            THREAD_PROGRAM: JSON.stringify(threadProgram.text),
            ...options.define,
        },
    });
}

const MODULE = JSON.stringify(deflateSync(readFileSync(join(pkg, "rapier_simd.wasm")), { level: 9 }).toString("base64"));
await bundle("entry_node.ts", "rapier.node.mjs", { platform: "node", define: { MODULE } });
const cjs = { format: "cjs", banner: { js: 'const MODULE_URL = require("node:url").pathToFileURL(__filename);' } };
await bundle("entry_node.ts", "rapier.node.cjs", { platform: "node", ...cjs, define: { MODULE, "import.meta.url": "MODULE_URL" } });
await bundle("entry_web.ts", "rapier.mjs", { define: { MODULE } });
await bundle("entry_file.ts", "rapier.file.mjs");

// Definitions: one file per source, with the names of the dimension and the precision.
const types = join(pkg, "types");
mkdirSync(types, { recursive: true });
const configuration = join(home, "node_modules", ".tsconfig.json");
writeFileSync(configuration, JSON.stringify({
    extends: join(here, `tsconfig.dim${dimension}.json`),
    compilerOptions: {
        rootDir: join(here, "src"), outDir: resolve(types), declaration: true, emitDeclarationOnly: true,
        paths: Object.fromEntries(Object.entries(alias).map(([name, path]) => [name, [path]])),
    },
}));
execFileSync(process.execPath, [require.resolve("typescript/bin/tsc"), "-p", configuration], { stdio: "inherit" });
const own = { entry: `rapier${dimension}`, real: `real${bits}` };
for (const file of readdirSync(types)) {
    const path = join(types, file);
    const text = readFileSync(path, "utf8");
    writeFileSync(path, text.replace(/"#(\w+)"/g, (_, name) => `"./${own[name] ?? name + dimension}.js"`));
}

// Programs that are CommonJS modules need definitions of such.
const typesOfCommonJs = join(pkg, "types-commonjs");
cpSync(types, typesOfCommonJs, { recursive: true });
writeFileSync(join(typesOfCommonJs, "package.json"), `${JSON.stringify({ type: "commonjs" })}\n`);

const { name, version, description, license, keywords, engines, sideEffects, exports } = manifest;
if (!hasThreads) {
    delete exports["./rapier_threads.wasm"];
}
writeFileSync(join(pkg, "package.json"), `${JSON.stringify({
    name, version, description, license, keywords, engines, sideEffects, type: "module",
    files: ["rapier*.mjs", "rapier*.cjs", "rapier*.wasm", "types", "types-commonjs", "docs", "LICENSE-*"],
    main: "./rapier.node.cjs", module: "./rapier.mjs", types: `./types/rapier${dimension}.d.ts`,
    exports,
}, null, 4)}\n`);
copyFileSync(join(home, "README.md"), join(pkg, "README.md"));
for (const file of ["LICENSE-MIT", "LICENSE-APACHE"]) {
    copyFileSync(join(here, "..", file), join(pkg, file));
}
