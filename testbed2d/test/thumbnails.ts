// Pictures of the 2D gallery.

import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { createServer } from "vite";
import { drawThumbnails } from "../../testbed/tools/thumbnails.ts";
import { SCENES } from "../src/scenes/index.ts";

await drawThumbnails(dirname(dirname(fileURLToPath(import.meta.url))), { chromium, createServer }, SCENES);
