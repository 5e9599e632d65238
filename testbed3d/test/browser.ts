// Tests of the 3D page in a browser.

import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { createServer } from "vite";
import { testPage } from "../../testbed/test/browser.ts";

await testPage({
    testbed: dirname(dirname(fileURLToPath(import.meta.url))),
    tools: { chromium, createServer },
    scenes: ["pyramid", "pile", "bridge", "robot-arm", "ragdoll-stairs", "car", "character", "radar", "sensors", "heightfield"],
    pick: { scene: "tower", x: 0.5, y: 0.45 },
});
