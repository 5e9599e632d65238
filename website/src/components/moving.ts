// Moving pictures of docs/images, each with the first frame that scripts/prepare.mjs takes from it.

import dominoes from "@repository/docs/images/dominoes-moving.png";
import strider from "@repository/docs/images/strider-moving.png";
import washer from "@repository/docs/images/washer-moving.png";
import dominoesStill from "@site/generated/images/dominoes-moving.png";
import striderStill from "@site/generated/images/strider-moving.png";
import washerStill from "@site/generated/images/washer-moving.png";

export interface Moving {
    /** Address of the picture. */
    readonly moving: string;
    /** Address of its first frame. */
    readonly still: string;
}

/** By name of the scene in the native gallery. */
export const MOVING = {
    washer: { moving: washer, still: washerStill },
    strider: { moving: strider, still: striderStill },
    dominoes: { moving: dominoes, still: dominoesStill },
} satisfies Record<string, Moving>;
