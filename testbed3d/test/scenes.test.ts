// Tests of the 3D scenes.

import * as RAPIER from "@dimforge/rapier3d-compat";
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import { loadEngines, testGallery } from "../../testbed/test/scenes.ts";
import { DIMENSION_3 } from "../src/dimension.ts";
import type { Rapier } from "../src/rapier.ts";
import { SCENES } from "../src/scenes/index.ts";

const testbed = dirname(dirname(fileURLToPath(import.meta.url)));
const engines = await loadEngines<Rapier>(RAPIER, testbed, 3);
testGallery({ dimension: DIMENSION_3, scenes: SCENES, engines, minimum: 30, repeated: "pyramid" });
