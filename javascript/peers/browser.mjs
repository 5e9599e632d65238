// Chromium for the comparison: a page that imports the engines from this repository.

import { createReadStream, existsSync } from "node:fs";
import { createServer } from "node:http";
import { FLAGS, requireChromium } from "../../testbed/tools/chromium.mjs";
import { extname, join, normalize } from "node:path";

const root = join(import.meta.dirname, "../..");
const here = "/javascript/peers";
const TYPES = { ".mjs": "text/javascript", ".js": "text/javascript", ".wasm": "application/wasm" };
/** Import map of the page, by package name. */
const IMPORTS = {
    "#load": `${here}/load_web.mjs`,
    "@dimforge/rapier2d-compat": `${here}/node_modules/@dimforge/rapier2d-compat/dist/rapier.mjs`,
    "@dimforge/rapier3d-compat": `${here}/node_modules/@dimforge/rapier3d-compat/dist/rapier.mjs`,
    "@dimforge/rapier3d-simd-compat": `${here}/node_modules/@dimforge/rapier3d-simd-compat/dist/rapier.mjs`,
    "jolt-physics/wasm-compat": `${here}/node_modules/jolt-physics/dist/jolt-physics.wasm-compat.js`,
    "box2d3-wasm": `${here}/node_modules/box2d3-wasm/build/dist/es/entry.mjs`,
};
const PAGE = `<!doctype html><link rel="icon" href="data:,"><script type="importmap">${JSON.stringify({ imports: IMPORTS })}</script>
<script type="module">
    import { measure } from "${here}/measure.mjs";
    window.measure = (...what) => measure(...what, () => performance.now());
</script>`;

function serve(request, response) {
    response.setHeader("Cross-Origin-Opener-Policy", "same-origin");
    response.setHeader("Cross-Origin-Embedder-Policy", "require-corp");
    const path = normalize(new URL(request.url, "http://page").pathname);
    const file = join(root, path);
    if (path === "/") {
        response.setHeader("Content-Type", "text/html").end(PAGE);
    } else if (TYPES[extname(file)] && existsSync(file)) {
        response.setHeader("Content-Type", TYPES[extname(file)]);
        createReadStream(file).pipe(response);
    } else {
        response.writeHead(404).end();
    }
}

/** Starts Chromium. */
export async function openBrowser() {
    const { chromium } = await import("playwright-core");
    const server = createServer(serve);
    await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
    const address = `http://127.0.0.1:${server.address().port}/`;
    const browser = await chromium.launch({ executablePath: requireChromium(), args: FLAGS });
    return {
        async measure(...what) {
            const page = await browser.newPage();
            try {
                await page.goto(address);
                await page.waitForFunction(() => "measure" in window);
                return await page.evaluate((arguments_) => window.measure(...arguments_), what);
            } finally {
                await page.close();
            }
        },
        /**
         * Runs a program in a worker. Returns its first message. The program imports files of this repository
         * from the address that it is called with.
         */
        async runWorker(program) {
            const page = await browser.newPage();
            try {
                await page.goto(address);
                return await page.evaluate((text) => new Promise((resolve, reject) => {
                    const worker = new Worker(URL.createObjectURL(new Blob([text], { type: "text/javascript" })), { type: "module" });
                    worker.onmessage = ({ data }) => resolve(data);
                    worker.onerror = ({ message }) => reject(new Error(message));
                    setTimeout(() => reject(new Error("the worker does not answer")), 60_000);
                }), program(address));
            } finally {
                await page.close();
            }
        },
        async close() {
            await browser.close();
            server.close();
        },
    };
}
