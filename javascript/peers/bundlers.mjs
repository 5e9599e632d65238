// Bundles a program with the package as `npm pack` makes it, by each bundler, and runs the results: those for
// pages in Chromium, the others in Node.js. Development servers serve the program from an installed package and
// from a linked one. All must compute the same hash. Prints a table of Markdown. The package must be built.
//     node bundlers.mjs [2|3] [BUNDLER]

import { execFile, execFileSync, spawn } from "node:child_process";
import { createReadStream, existsSync, mkdirSync, mkdtempSync, rmSync, statSync, symlinkSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { createServer as createSocket } from "node:net";
import { tmpdir } from "node:os";
import { extname, join, resolve } from "node:path";
import { promisify } from "node:util";
import { chromium } from "playwright-core";
import { FLAGS, requireChromium } from "../../testbed/tools/chromium.mjs";

const VERSIONS = { vite6: "6.4.6", vite7: "7.3.8", vite8: "8.3.8", webpack: "5.113.0", esbuild: "0.28.2", rollup: "4.68.8", parcel: "2.16.4" };
const [dimension = "3", only] = process.argv.slice(2);
const name = `rapier${dimension}d`;
const pkg = resolve(import.meta.dirname, `../../${name}/pkg`);
const root = mkdtempSync(join(tmpdir(), "bundlers-"));
const project = join(root, "project");
const linked = join(root, "linked");
const at = (...components) => components.slice(0, Number(dimension)).join(", ");

/** The program: some steps, and an error, whose name must survive. */
const program = (load) => `${load}
const done = (text) => { if (typeof document === "undefined") console.log(text); else document.body.dataset.result = text; };
async function run() {
    await RAPIER.init();
    const world = new RAPIER.PhysicsWorld();
    world.insert(RAPIER.RigidBodyDesc.fixed(), RAPIER.ColliderDesc.cuboid(${at(9, 1, 9)}));
    for (let n = 0; n < 9; n += 1) {
        world.insert(RAPIER.RigidBodyDesc.dynamic().setTranslation(${at("n * 0.375", "2 + n", "n * 0.125")}), RAPIER.ColliderDesc.ball(0.5));
    }
    for (let n = 0; n < 100; n += 1) world.step();
    try {
        world.timestep = NaN;
    } catch (error) {
        return world.hash().toString(16) + " " + error.constructor.name;
    }
}
run().then(done, (error) => done(error.name + ": " + error.message));
`;
const page = (script) => `<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,"><body>${script}</body>`;

function prepare() {
    mkdirSync(join(project, "src"), { recursive: true });
    const { filename } = JSON.parse(execFileSync("npm", ["pack", "--json", "--pack-destination", root], { cwd: pkg, encoding: "utf8" }))[0];
    const vites = ["vite6", "vite7", "vite8"].map((vite) => [vite, `npm:vite@${VERSIONS[vite]}`]);
    const others = ["webpack", "esbuild", "rollup", "parcel"].map((tool) => [tool, VERSIONS[tool]]);
    writeFileSync(join(project, "package.json"), JSON.stringify({
        private: true,
        type: "module",
        dependencies: { [name]: `file:../${filename}`, ...Object.fromEntries([...vites, ...others]), "@rollup/plugin-node-resolve": "16.0.3" },
    }));
    execFileSync("npm", ["install", "--no-fund", "--no-audit", "--loglevel=error"], { cwd: project, stdio: "inherit" });
    for (const folder of [project, linked]) {
        mkdirSync(join(folder, "src"), { recursive: true });
        writeFileSync(join(folder, "src/main.js"), program(`import RAPIER from "${name}";`));
        writeFileSync(join(folder, "src/file.js"), program(`import RAPIER from "${name}/file";`));
        writeFileSync(join(folder, "main.mjs"), program(`import RAPIER from "${name}";`));
        writeFileSync(join(folder, "main.cjs"), program(`const RAPIER = require("${name}");`));
        writeFileSync(join(folder, "index.html"), page('<script type="module" src="./src/main.js"></script>'));
        writeFileSync(join(folder, "file.html"), page('<script type="module" src="./src/file.js"></script>'));
    }
    writeFileSync(join(linked, "package.json"), JSON.stringify({ private: true, type: "module", dependencies: { [name]: `link:${pkg}` } }));
    mkdirSync(join(linked, "node_modules"));
    symlinkSync(pkg, join(linked, "node_modules", name));
}

// ---- Runs ----

const TYPES = { ".js": "text/javascript", ".mjs": "text/javascript", ".html": "text/html", ".wasm": "application/wasm" };

/** Serves a folder. Returns the address and a function that ends it. */
async function serve(folder) {
    const server = createServer((request, response) => {
        const file = join(folder, new URL(request.url, "http://page").pathname);
        if (!existsSync(file) || !statSync(file).isFile()) {
            response.writeHead(404).end();
            return;
        }
        response.setHeader("Content-Type", TYPES[extname(file)] ?? "application/octet-stream");
        createReadStream(file).pipe(response);
    });
    await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
    return { address: `http://127.0.0.1:${server.address().port}`, end: () => server.close() };
}

const browser = await chromium.launch({ executablePath: requireChromium(), args: FLAGS });

/** The result of a page. */
async function visit(address) {
    const tab = await browser.newPage();
    const messages = [];
    tab.on("console", (message) => message.type() === "error" && messages.push(message.text()));
    tab.on("pageerror", (error) => messages.push(error.message));
    try {
        await tab.goto(address);
        await tab.waitForFunction(() => document.body.dataset.result, null, { timeout: 60_000 });
        return await tab.evaluate(() => document.body.dataset.result);
    } catch (error) {
        return `${messages.join("; ") || error.message}`;
    } finally {
        await tab.close();
    }
}

async function visitFolder(folder, path = "index.html") {
    const { address, end } = await serve(folder);
    try {
        return await visit(`${address}/${path}`);
    } finally {
        end();
    }
}

/** The output of a process in the project. */
async function output(path, ...options) {
    const { stdout } = await promisify(execFile)(path, options, { cwd: project, timeout: 300_000, maxBuffer: 1 << 26 });
    return stdout.trim();
}

const runNode = (...options) => output(process.execPath, ...options);

async function freePort() {
    const socket = createSocket();
    await new Promise((ready) => socket.listen(0, "127.0.0.1", ready));
    const { port } = socket.address();
    await new Promise((closed) => socket.close(closed));
    return port;
}

// ---- Bundlers ----

const out = (folder) => join(project, "dist", folder);

/** A page of a bundle, in the folder of the bundle. */
function writePage(folder, script) {
    writeFileSync(join(out(folder), "index.html"), page(script));
    return out(folder);
}

async function esbuild(platform, format) {
    const folder = `esbuild-${platform}-${format}`;
    const outfile = join(out(folder), format === "cjs" ? "main.cjs" : "main.mjs");
    writeFileSync(join(project, `${folder}.mjs`), `import { build } from "esbuild";
await build({ entryPoints: ["src/main.js"], bundle: true, minify: true, platform: "${platform}", format: "${format}", outfile: ${JSON.stringify(outfile)}, logLevel: "error" });
`);
    await runNode(`${folder}.mjs`);
    return platform === "node" ? runNode(outfile) : visitFolder(writePage(folder, '<script type="module" src="./main.mjs"></script>'));
}

async function rollup(platform) {
    const folder = `rollup-${platform}`;
    writeFileSync(join(project, `${folder}.mjs`), `import resolve from "@rollup/plugin-node-resolve";
import { rollup } from "rollup";
const bundle = await rollup({ input: "src/main.js", external: [/^node:/], onwarn() {}, plugins: [resolve({ ${platform === "node" ? 'exportConditions: ["node"]' : "browser: true"} })] });
await bundle.write({ file: ${JSON.stringify(join(out(folder), "main.mjs"))}, format: "es" });
`);
    await runNode(`${folder}.mjs`);
    return platform === "node" ? runNode(join(out(folder), "main.mjs")) : visitFolder(writePage(folder, '<script type="module" src="./main.mjs"></script>'));
}

async function webpack(target, entry = "main") {
    const folder = `webpack-${target}-${entry}`;
    const configuration = { mode: "production", target, entry: `./src/${entry}.js`, output: { path: out(folder), filename: "main.cjs" }, performance: { hints: false } };
    writeFileSync(join(project, `${folder}.cjs`), `require("webpack")(${JSON.stringify(configuration)}, (error, stats) => {
    if (error || stats.hasErrors()) { console.error(error ?? stats.toString("errors-only")); process.exitCode = 1; }
});
`);
    await runNode(`${folder}.cjs`);
    return target === "node" ? runNode(join(out(folder), "main.cjs")) : visitFolder(writePage(folder, '<script src="./main.cjs"></script>'));
}

async function parcel() {
    await runNode("node_modules/parcel/lib/bin.js", "build", "index.html", "--dist-dir", out("parcel"), "--no-source-maps", "--log-level=error", "--no-cache");
    return visitFolder(out("parcel"));
}

async function viteBuild(vite, entry = "index.html") {
    const folder = `${vite}-${entry}`;
    writeFileSync(join(project, `${folder}.mjs`), `import { build } from ${JSON.stringify(vite)};
await build({ configFile: false, logLevel: "error", base: "./", build: { outDir: ${JSON.stringify(out(folder))}, rollupOptions: { input: ${JSON.stringify(entry)} } } });
`);
    await runNode(`${folder}.mjs`);
    return visitFolder(out(folder), entry);
}

/** Starts a development server in a folder, and visits its page. */
async function viteServe(vite, folder, path = "") {
    const port = await freePort();
    const bin = join(project, "node_modules", vite, "bin/vite.js");
    const server = spawn(process.execPath, [bin, "--port", port, "--strictPort", "--host", "127.0.0.1"], { cwd: folder, stdio: "ignore" });
    try {
        const address = `http://127.0.0.1:${port}/${path}`;
        for (let tries = 0; tries < 100 && !(await fetch(address).catch(() => null)); tries += 1) {
            await new Promise((later) => setTimeout(later, 200));
        }
        return await visit(address);
    } finally {
        server.kill();
    }
}

async function importMap() {
    const imports = { [name]: `./node_modules/${name}/rapier.mjs` };
    writeFileSync(join(project, "map.html"), page(`<script type="importmap">${JSON.stringify({ imports })}</script><script type="module" src="./src/main.js"></script>`));
    return visitFolder(project, "map.html");
}

const RUNS = [
    ["Node.js", "`import`", () => runNode("main.mjs")],
    ["Node.js", "`require`", () => runNode("main.cjs")],
    ["a page", "import map", importMap],
    ...["vite6", "vite7", "vite8"].flatMap((vite) => [
        [vite, "development, installed", () => viteServe(vite, project)],
        [vite, "development, linked", () => viteServe(vite, linked)],
        [vite, "build", () => viteBuild(vite)],
        [vite, `build of \`${name}/file\``, () => viteBuild(vite, "file.html")],
    ]),
    ["webpack", "page", () => webpack("web")],
    ["webpack", `page, \`${name}/file\``, () => webpack("web", "file")],
    ["webpack", "Node.js", () => webpack("node")],
    ["esbuild", "page", () => esbuild("browser", "esm")],
    ["esbuild", "Node.js, modules", () => esbuild("node", "esm")],
    ["esbuild", "Node.js, CommonJS", () => esbuild("node", "cjs")],
    ["rollup", "page", () => rollup("browser")],
    ["rollup", "Node.js", () => rollup("node")],
    ["parcel", "page", () => parcel()],
];

let failed = false;
try {
    prepare();
    let expected;
    console.log(`| bundler | version | target | ${name} |\n|---|---|---|---|`);
    for (const [tool, target, run] of RUNS.filter(([tool]) => !only || tool === "Node.js" || tool.startsWith(only))) {
        const result = await run().catch((error) => `${error.stderr || error.message}`);
        expected ??= result;
        const works = result === expected && result.endsWith("RapierError");
        failed ||= !works;
        const version = VERSIONS[tool] ?? (tool === "Node.js" ? process.version.slice(1) : "");
        console.log(`| ${tool.replace(/\d$/, "")} | ${version} | ${target} | ${works ? "works" : result.replaceAll(/\s+/g, " ").slice(0, 300)} |`);
    }
} finally {
    await browser.close();
    rmSync(root, { recursive: true, force: true });
}
process.exitCode = Number(failed);
