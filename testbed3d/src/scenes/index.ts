// All scenes of the 3D gallery, in the order of the gallery.

import type { Scene } from "../rapier.ts";
import { BULLETS } from "./bullets.ts";
import { CHARACTERS } from "./characters.ts";
import { EVENTS } from "./events.ts";
import { FORCES } from "./forces.ts";
import { GROUND } from "./ground.ts";
import { JOINTS } from "./joints.ts";
import { MATERIALS } from "./materials.ts";
import { MOTORS } from "./motors.ts";
import { PLATFORMS } from "./platforms.ts";
import { QUERIES } from "./queries.ts";
import { RAGDOLLS } from "./ragdolls.ts";
import { SHAPES } from "./shapes.ts";
import { STACKS } from "./stacks.ts";
import { STRESS } from "./stress.ts";
import { VEHICLES } from "./vehicles.ts";

export const SCENES: readonly Scene[] = [
    ...STACKS,
    ...SHAPES,
    ...MATERIALS,
    ...FORCES,
    ...JOINTS,
    ...MOTORS,
    ...RAGDOLLS,
    ...VEHICLES,
    ...CHARACTERS,
    ...PLATFORMS,
    ...BULLETS,
    ...QUERIES,
    ...EVENTS,
    ...GROUND,
    ...STRESS,
];
