// Visits every page of the build in headless Chromium. Fails at an error of the console, a request without an answer, or a page
// that is too heavy or wider than a phone, at a squashed, cut or empty picture, and at a finding of axe. Sample pages are also checked and photographed in
// all sizes and colours: the pictures go to `shots/`. With `--shots`, only the sample pages are visited.

import { mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { chromium } from "playwright-core";
import { FLAGS, RENDERING, requireChromium } from "../../testbed/tools/chromium.mjs";
import { LIVE, SAMPLES, visitedPages } from "./pages.mjs";
import { checkPictures } from "./pictures.mjs";
import { serve } from "./server.mjs";

const WEBSITE = dirname(import.meta.dirname);
const BUILD = join(WEBSITE, "build");
const SHOTS = join(WEBSITE, "shots");

/** Bytes of a page of text before compression. */
const WEIGHT_MAX = 2_000_000;
/** Bytes of pages with a scene, whose engine has 3.3 MB alone, of the page that loads the whole index of the search, and of the longest tables. */
const WEIGHTS_MAX = { "/": 9_000_000, "/gallery": 9_000_000, "/gallery/3d/car": 9_000_000, "/gallery/2d/washer": 9_000_000, "/search": 6_000_000, "/docs/fidelity/mechanics": 2_500_000 };
/** Bytes of a page with a scene before the scene starts. */
const FIRST_WEIGHT_MAX = 2_000_000;
/** Time for the page to measure its tables (ms): wide ones become stops of the Tab key. */
const MEASURING_TIME = 10_000;

/** Time for a page to load (ms), on a machine that does other work too. */
const LOADING_TIME = 120_000;

/** Findings of axe that belong to others: the page of the search plugin has no main part. */
const FOREIGN_FINDINGS = { "/search": ["landmark-one-main", "region"] };

/** Pages that are open at the same time: most of a visit is waiting. */
const VISITORS = 4;

const SIZES = {
    desktop: { viewport: { width: 1280, height: 800 } },
    phone: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 },
};

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const failures = [];

function fail(page, message) {
    failures.push(`${page}: ${message}`);
    console.error(`✗ ${page}: ${message}`);
}

/** Opens a page and records its errors and its weight. A scene is awaited if it `starts`. */
async function open(context, address, path, starts = LIVE.has(path)) {
    const page = await context.newPage();
    const sizes = [];
    page.on("console", (message) => message.type() === "error" && fail(path, message.text()));
    page.on("pageerror", (error) => fail(path, String(error)));
    page.on(
        "requestfailed",
        (request) => !request.failure()?.errorText.includes("ABORTED") && fail(path, `no answer to ${request.url()}`),
    );
    page.on("response", (response) => {
        if (response.status() >= 400) fail(path, `${response.status()} for ${response.url()}`);
        const body = response.body().catch(() => Buffer.alloc(0));
        sizes.push(body.then(({ length }) => length));
    });
    await page.goto(address + path, { waitUntil: "networkidle", timeout: LOADING_TIME });
    if (starts) await page.waitForSelector('[data-live="running"]', { timeout: 60_000 });
    const weigh = async () => (await Promise.all(sizes)).reduce((sum, size) => sum + size, 0);
    return { page, weigh };
}

/** Fails if the page scrolls sideways. `innerWidth` includes the overflow: a phone zooms out until the page fits. */
async function checkWidth(page, path) {
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    if (overflow > 0) fail(path, `${overflow} pixels wider than the window`);
}

/** Visits the pages that are left, and returns the heaviest one with the ordinary limit. */
async function visit(context, address, left) {
    let heaviest = { path: "", weight: 0 };
    for (let path = left.pop(); path !== undefined; path = left.pop()) {
        const { page, weigh } = await open(context, address, path);
        const weight = await weigh();
        if (weight > (WEIGHTS_MAX[path] ?? WEIGHT_MAX)) fail(path, `${weight} bytes`);
        if (path in WEIGHTS_MAX) console.log(`${path}: ${weight} bytes`);
        else if (weight > heaviest.weight) heaviest = { path, weight };
        await checkWidth(page, path);
        await checkAccess(page, path);
        await checkPictures(page, (message) => fail(path, message));
        await page.close();
    }
    return heaviest;
}

/** Visits all pages in a window as wide as a phone. */
async function visitAll(browser, address) {
    const context = await browser.newContext({ viewport: SIZES.phone.viewport });
    const left = visitedPages(BUILD);
    const count = left.length;
    const found = await Promise.all(Array.from({ length: VISITORS }, () => visit(context, address, left)));
    await context.close();
    const heaviest = found.reduce((a, b) => (a.weight > b.weight ? a : b));
    console.log(`${count} pages; the heaviest with the ordinary limit is ${heaviest.path} with ${heaviest.weight} bytes`);
}

async function checkAccess(page, path) {
    const areMeasured = () =>
        [...document.querySelectorAll(".scroll-table")].every((table) => table.scrollWidth <= table.clientWidth || table.tabIndex === 0);
    // axe reports a table that stays without a stop.
    await page.waitForFunction(areMeasured, null, { timeout: MEASURING_TIME }).catch(() => {});
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
    for (const { id, impact, nodes } of violations.filter(({ id }) => !FOREIGN_FINDINGS[path]?.includes(id))) {
        const places = nodes.map(({ target }) => target.join(" ")).slice(0, 3);
        fail(path, `axe ${id} (${impact}): ${places.join("; ")}`);
    }
}

async function photograph(browser, address) {
    mkdirSync(SHOTS, { recursive: true });
    for (const [size, options] of Object.entries(SIZES)) {
        for (const scheme of ["light", "dark"]) {
            const context = await browser.newContext({ ...options, colorScheme: scheme });
            for (const [name, path] of Object.entries(SAMPLES)) {
                const { page } = await open(context, address, path);
                if (LIVE.has(path)) await page.waitForTimeout(2500);
                await checkAccess(page, `${path} (${size}, ${scheme})`);
                await checkPictures(page, (message) => fail(`${path} (${size}, ${scheme})`, message));
                await checkWidth(page, `${path} (${size})`);
                await page.screenshot({ path: join(SHOTS, `${name}-${size}-${scheme}.png`) });
                await page.close();
            }
            await context.close();
        }
    }
}

/** Presses the pointer at points of the scene until it holds a body: they fall while the test looks for one. */
async function grabBody(page) {
    const canvas = page.locator("canvas");
    const cursor = () => canvas.evaluate((element) => element.style.cursor);
    const { x, y, width, height } = await canvas.boundingBox();
    for (let attempt = 0; attempt < 60; attempt += 1) {
        await page.mouse.move(x + width * (0.4 + 0.05 * (attempt % 5)), y + height * (0.75 - 0.03 * (attempt % 12)));
        await page.mouse.down();
        if ((await cursor()) === "grabbing") return true;
        await page.mouse.up();
    }
    return false;
}

/** Pages with a scene are light until the scene starts, which is when its canvas comes into view. */
async function checkFirstWeight(browser, address) {
    for (const path of ["/", "/gallery"]) {
        const context = await browser.newContext(SIZES.desktop);
        await context.addInitScript(() => {
            globalThis.IntersectionObserver = class extends IntersectionObserver {
                observe(target) {
                    if (!(target instanceof HTMLCanvasElement)) super.observe(target);
                }
            };
        });
        const { weigh } = await open(context, address, path, false);
        const weight = await weigh();
        console.log(`${path} before its scene starts: ${weight} bytes`);
        if (weight > FIRST_WEIGHT_MAX) fail(path, `${weight} bytes before its scene starts`);
        await context.close();
    }
}

/** The scene of the first page steps, and its bodies can be taken. */
async function checkScene(browser, address) {
    const context = await browser.newContext(SIZES.desktop);
    const { page } = await open(context, address, "/");
    const figures = page.getByText(/bodies, .* ms a step/);
    await figures.waitFor({ timeout: 30_000 });
    console.log(`first page: ${await figures.textContent()}`);
    if (!(await grabBody(page))) fail("/", "the pointer takes no body");
    await page.mouse.up();
    await context.close();
}

/** The pile of the page about determinism has the same hashes here as in Node.js. */
async function checkDeterminism(browser, address) {
    const context = await browser.newContext(SIZES.desktop);
    const { page } = await open(context, address, "/determinism");
    await page.getByRole("button", { name: /^Run/ }).click();
    const verdict = page.getByRole("status").filter({ hasText: /hashes/ });
    await verdict.waitFor({ timeout: 120_000 });
    const text = await verdict.textContent();
    if (!text.includes("Equal bits")) fail("/determinism", text);
    await context.close();
}

/** The search suggests a type of the reference first, and the guide before methods. Its index is loaded on use. */
async function checkSearch(browser, address) {
    for (const [words, wanted] of [
        ["RevoluteJointBuilder", /^RevoluteJointBuilder/],
        ["sleeping", /Guide/],
        ["rotation", /Guide/],
    ]) {
        const context = await browser.newContext(SIZES.desktop);
        let loaded = false;
        context.on("request", (request) => (loaded ||= request.url().includes("search-index")));
        const { page } = await open(context, address, "/docs/guide");
        if (loaded) fail("/docs/guide", "the index of the search is loaded before its use");
        await page.getByRole("combobox", { name: "Search" }).or(page.getByPlaceholder("Search")).first().fill(words);
        const found = page.locator("[class*=suggestion]").first();
        const text = await found.textContent({ timeout: 20_000 }).catch(() => "nothing");
        console.log(`search for ${words}: ${text}`);
        if (!wanted.test(text)) fail("/docs/guide", `the search for ${words} finds ${text}`);
        await context.close();
    }
}

/** Unknown addresses have a page with ways out, and three short addresses lead to pages. */
async function checkAddresses(browser, address) {
    const context = await browser.newContext(SIZES.desktop);
    const page = await context.newPage();
    await page.goto(`${address}/nowhere`, { waitUntil: "networkidle" });
    await page.getByRole("heading", { name: "No page has this address" }).waitFor({ timeout: 20_000 });
    for (const [from, to] of [
        ["/docs", "/docs/guide"],
        ["/api", "/api/rust"],
        ["/docs/benchmarks", "/benchmarks"],
        ["/gallery#washer", "/gallery/3d/washer"],
    ]) {
        await page.goto(address + from, { waitUntil: "networkidle" });
        const arrives = ({ pathname }) => pathname.replace(/\/$/, "") === to;
        await page.waitForURL(arrives, { timeout: 20_000 }).catch(() => fail(from, `leads to ${page.url()}`));
    }
    await context.close();
}

/** The filter of a long page of the reference hides the other names. */
async function checkFilter(browser, address) {
    const path = "/api/rust/rigid-body/RigidBody";
    const context = await browser.newContext(SIZES.desktop);
    const { page } = await open(context, address, path);
    const visible = () => page.locator("article h2:visible").count();
    const before = await visible();
    await page.getByPlaceholder("Filter the names of this page").fill("linvel");
    const after = await visible();
    if (after === 0 || after > before / 4) fail(path, `the filter shows ${after} of ${before} names`);
    await context.close();
}

/** A failure of the module leads to a message, and the button works again. */
async function checkFailure(browser, address) {
    const context = await browser.newContext(SIZES.desktop);
    const page = await context.newPage();
    await page.route(/\.wasm$/, (route) => route.abort());
    await page.goto(`${address}/determinism`, { waitUntil: "networkidle" });
    const button = page.getByRole("button", { name: /^Run/ });
    await button.click();
    const message = page.getByRole("status").filter({ hasText: "did not run" });
    await message.waitFor({ timeout: 60_000 }).catch(() => fail("/determinism", "no message without the module"));
    if (await button.isDisabled()) fail("/determinism", "the button stays disabled after a failure");
    await context.close();
}

/** A card of the guide runs its scene, and the scene takes the focus of the button. */
async function checkCard(browser, address) {
    const path = "/docs/guide/bodies";
    const context = await browser.newContext(SIZES.desktop);
    const { page } = await open(context, address, path);
    await page.getByRole("button", { name: "Run the scene: T-handle in space" }).click();
    await page.waitForSelector('[data-live="running"]', { timeout: 60_000 });
    const focused = await page.evaluate(() => document.activeElement?.getAttribute("aria-label"));
    if (focused !== "Live scene") fail(path, `the focus is on ${focused}`);
    await context.close();
}

/** Moving pictures pause, and stand still where the system reduces motion. */
async function checkMotion(browser, address) {
    for (const [reducedMotion, first, second] of [
        ["no-preference", "Pause", "Play"],
        ["reduce", "Play", "Pause"],
    ]) {
        const context = await browser.newContext({ ...SIZES.desktop, reducedMotion });
        const page = await context.newPage();
        await page.goto(`${address}/`, { waitUntil: "networkidle" });
        const picture = page.locator("figure").first();
        const source = () => picture.locator("img").getAttribute("src");
        const before = await source();
        await picture.getByRole("button", { name: new RegExp(`^${first}: `) }).click({ timeout: 20_000 });
        await picture.getByRole("button", { name: new RegExp(`^${second}: `) }).waitFor({ timeout: 20_000 });
        if ((await source()) === before) fail("/", `"${first}" does not change the picture`);
        await context.close();
    }
}

/** Every thumbnail has a strip of pictures, and shows it under the pointer. */
async function checkThumbnails(browser, address) {
    for (const dimension of ["3D", "2D"]) {
        const context = await browser.newContext({ ...SIZES.desktop, reducedMotion: "no-preference" });
        const { page } = await open(context, address, "/gallery");
        await page.getByRole("button", { name: dimension, exact: true }).click();
        const thumbnails = page.locator(`a[href^="/gallery/${dimension.toLowerCase()}/"]`).filter({ has: page.locator("img") });
        const count = await thumbnails.count();
        for (let index = 0; index < count; index += 1) {
            const thumbnail = thumbnails.nth(index);
            await thumbnail.hover();
            const strip = thumbnail.locator(".moving");
            const fault = await strip.evaluate(stripFault, null, { timeout: 10_000 }).catch(() => "does not appear");
            if (fault !== null) fail("/gallery", `the strip of ${await thumbnail.getAttribute("href")} ${fault}`);
        }
        console.log(`/gallery: the pointer was on ${count} thumbnails in ${dimension}`);
        if (count === 0) fail("/gallery", `no thumbnails in ${dimension}`);
        await context.close();
    }
}

/** Runs in the page. Returns a message if the strip does not load, is no row of eight pictures, or does not move. */
async function stripFault(strip) {
    const { backgroundImage, animationName } = getComputedStyle(strip);
    const image = new Image();
    image.src = /url\("(.*)"\)/.exec(backgroundImage)?.[1] ?? "";
    if (!(await image.decode().then(() => true, () => false))) return "does not load";
    const box = strip.getBoundingClientRect();
    const ratio = image.naturalWidth / 8 / image.naturalHeight / (box.width / box.height);
    if (Math.abs(ratio - 1) > 0.03) return "is squashed";
    return animationName === "none" ? "does not move" : null;
}

const samplesOnly = process.argv.includes("--shots");
const server = await serve(BUILD);
const browser = await chromium.launch({ executablePath: requireChromium(), args: [...FLAGS, ...RENDERING] });
try {
    await checkFirstWeight(browser, server.address);
    await checkScene(browser, server.address);
    await checkDeterminism(browser, server.address);
    await checkSearch(browser, server.address);
    await checkAddresses(browser, server.address);
    await checkFilter(browser, server.address);
    await checkFailure(browser, server.address);
    await checkCard(browser, server.address);
    await checkMotion(browser, server.address);
    await checkThumbnails(browser, server.address);
    if (!samplesOnly) await visitAll(browser, server.address);
    await photograph(browser, server.address);
} finally {
    await browser.close();
    server.close();
}
console.log(failures.length === 0 ? `${samplesOnly ? "the sample" : "all"} pages are sound` : `${failures.length} failures`);
process.exit(failures.length === 0 ? 0 : 1);
