// Moving pictures of docs/images, each with the first frame that scripts/prepare.mjs takes from it.

import dominoes from "@repository/docs/images/dominoes-moving.png";
import ragdollStairs from "@repository/docs/images/ragdoll_stairs-moving.png";
import vehicle from "@repository/docs/images/vehicle-moving.png";
import wreckingBall from "@repository/docs/images/wrecking_ball-moving.png";
import dominoesStill from "@site/generated/images/dominoes-moving.png";
import ragdollStairsStill from "@site/generated/images/ragdoll_stairs-moving.png";
import vehicleStill from "@site/generated/images/vehicle-moving.png";
import wreckingBallStill from "@site/generated/images/wrecking_ball-moving.png";

export interface Moving {
    /** Address of the picture. */
    readonly moving: string;
    /** Address of its first frame. */
    readonly still: string;
}

/** By name of the scene in the native gallery. */
export const MOVING = {
    vehicle: { moving: vehicle, still: vehicleStill },
    wrecking_ball: { moving: wreckingBall, still: wreckingBallStill },
    ragdoll_stairs: { moving: ragdollStairs, still: ragdollStairsStill },
    dominoes: { moving: dominoes, still: dominoesStill },
} satisfies Record<string, Moving>;
