// The Chromium of the machine, for everything that drives one: tests of the testbeds and of the website,
// comparisons.

import { existsSync } from "node:fs";

const PLACES = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

/** No traffic of the browser's own. */
export const FLAGS = [
    "--no-sandbox",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
];

/** WebGL in software. */
export const RENDERING = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];

/** The path of the program, or undefined. The environment variable CHROMIUM names another one. */
export function findChromium() {
    return process.env.CHROMIUM ?? PLACES.find((place) => existsSync(place));
}

/** The path of the program. Fails without one. */
export function requireChromium() {
    const path = findChromium();
    if (path === undefined) {
        throw new Error("no Chromium: install the package `chromium`, or set CHROMIUM");
    }
    return path;
}
