// Prints the time from the request of a page to the first steps of its scene: start.mjs [ADDRESS], http://localhost:3000 by default (`yarn start`). A server
// compiles a page at its first visit, so that is a visit of its own.

import { chromium } from "playwright-core";
import { FLAGS, RENDERING, requireChromium } from "../../testbed/tools/chromium.mjs";

/** Visits of a page, each with an empty cache. */
const VISITS = 5;
const PAGES = ["/", "/gallery"];
/** Time for a scene to start while the server compiles (ms). */
const START_TIME = 300_000;

/** Runs in the page: the time when the scene has made its first steps (ms), of which its figures tell. */
function noteFirstSteps() {
    const observer = new MutationObserver(() => {
        if (!/\d bodies, .* ms a step/.test(document.body?.textContent ?? "")) return;
        globalThis.firstSteps = performance.now();
        observer.disconnect();
    });
    observer.observe(document, { childList: true, subtree: true, characterData: true });
}

/** The time of one visit (s). */
async function visit(browser, address) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
    await context.addInitScript(noteFirstSteps);
    const page = await context.newPage();
    await page.goto(address, { waitUntil: "commit", timeout: START_TIME });
    const time = await page.waitForFunction(() => globalThis.firstSteps, null, { timeout: START_TIME });
    const seconds = (await time.jsonValue()) / 1000;
    await context.close();
    return seconds;
}

const address = (process.argv[2] ?? "http://localhost:3000").replace(/\/$/, "");
const browser = await chromium.launch({ executablePath: requireChromium(), args: [...FLAGS, ...RENDERING] });
for (const path of PAGES) {
    const first = await visit(browser, address + path);
    const times = [];
    for (let index = 0; index < VISITS; index += 1) times.push(await visit(browser, address + path));
    console.log(`${path}: first steps after ${times.map((time) => time.toFixed(2)).join(", ")} s (first visit: ${first.toFixed(2)} s)`);
}
await browser.close();
