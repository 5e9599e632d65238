// Pictures of scenes.

import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { createServer } from "vite";
import { takeShots } from "../../testbed/tools/shots.ts";
import { SCENES } from "../src/scenes/index.ts";

await takeShots(dirname(dirname(fileURLToPath(import.meta.url))), { chromium, createServer }, SCENES);
