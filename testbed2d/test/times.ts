// Step times of the 2D scenes in each engine.

import * as RAPIER from "@dimforge/rapier2d-compat";
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import { loadEngines } from "../../testbed/test/scenes.ts";
import { compareTimes } from "../../testbed/tools/times.ts";
import { DIMENSION_2 } from "../src/dimension.ts";
import type { Rapier } from "../src/rapier.ts";
import { SCENES } from "../src/scenes/index.ts";

const engines = await loadEngines<Rapier>(RAPIER, dirname(dirname(fileURLToPath(import.meta.url))), 2);
compareTimes(DIMENSION_2, engines, SCENES);
