// Planks of a bridge on an arc. Straight ones would need infinite tension to carry a load.

export interface Arc {
    /** Half of the distance of the ends. */
    readonly bank: number;
    /** Angle of a plank, and its centre relative to the middle of the line between the ends. */
    place(index: number): { angle: number; x: number; y: number };
}

/** An arc of this radius from end to end, below them, with planks whose joints are `pitch` apart. */
export function hangingArc(planks: number, pitch: number, radius: number): Arc {
    const step = 2 * Math.asin(pitch / 2 / radius);
    const side = (planks / 2) * step;
    const middle = radius * Math.cos(step / 2);
    return {
        bank: radius * Math.sin(side),
        place(index) {
            const angle = (index + 0.5) * step - side;
            return { angle, x: middle * Math.sin(angle), y: radius * Math.cos(side) - middle * Math.cos(angle) };
        },
    };
}
