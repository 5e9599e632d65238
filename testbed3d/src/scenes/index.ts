// All scenes of the 3D gallery, in the order of the gallery.

import type { Scene } from "../rapier.ts";
import { BULLETS } from "./bullets.ts";
import { CHARACTERS } from "./characters.ts";
import { EVENTS } from "./events.ts";
import { JOINTS } from "./joints.ts";
import { MOTORS } from "./motors.ts";
import { QUERIES } from "./queries.ts";
import { RAGDOLLS } from "./ragdolls.ts";
import { STACKS } from "./stacks.ts";
import { VEHICLES } from "./vehicles.ts";

export const SCENES: readonly Scene[] = [
    ...STACKS,
    ...JOINTS,
    ...MOTORS,
    ...RAGDOLLS,
    ...VEHICLES,
    ...CHARACTERS,
    ...BULLETS,
    ...QUERIES,
    ...EVENTS,
];
