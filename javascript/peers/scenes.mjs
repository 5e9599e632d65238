// The scenes of the comparison as data: bodies with one shape each, and joints that hold points together.
// A position has three numbers. Two dimensions leave out the last one.

const box = (...half) => ({ kind: "box", half });
const ball = (radius) => ({ kind: "ball", radius });
const capsule = (halfHeight, radius) => ({ kind: "capsule", halfHeight, radius });
const ground = () => ({ fixed: true, at: [0, -1, 0], shape: box(200, 1, 200) });

/** A block of boxes with gaps, which falls and becomes a pile. */
function boxes(dimension, count) {
    const bodies = [ground()];
    const side = Math.round(dimension === 2 ? Math.sqrt(count) : Math.cbrt(count / 1.25));
    for (let number = 0; number < count; number += 1) {
        const column = number % side;
        const row = dimension === 2 ? 0 : Math.floor(number / side) % side;
        const layer = Math.floor(number / (dimension === 2 ? side : side * side));
        const shift = (layer % 3) * 0.1;
        bodies.push({ at: [(column - side / 2) * 1.1 + shift, layer * 1.1 + 1, (row - side / 2) * 1.1 + shift], shape: box(0.5, 0.5, 0.5) });
    }
    return { bodies, joints: [] };
}

/** Ragdolls of eleven capsules that fall on one another. */
function ragdolls(dimension, count) {
    const bodies = [ground()];
    const joints = [];
    const parts = [
        { at: [0, 0], size: [0.25, 0.2] },
        { at: [0, 0.75], size: [0.2, 0.15], parent: 0, pin: [0, 0.45] },
        { at: [0, 1.25], size: [0.05, 0.2], parent: 1, pin: [0, 1.0] },
        ...[-1, 1].flatMap((side, index) => [
            { at: [side * 0.55, 0.75], size: [0.25, 0.1], parent: 1, pin: [side * 0.3, 0.75], lying: true },
            { at: [side * 1.2, 0.75], size: [0.25, 0.1], parent: 3 + 4 * index, pin: [side * 0.87, 0.75], lying: true },
            { at: [side * 0.2, -0.8], size: [0.3, 0.12], parent: 0, pin: [side * 0.2, -0.35] },
            { at: [side * 0.2, -1.6], size: [0.3, 0.12], parent: 5 + 4 * index, pin: [side * 0.2, -1.2] },
        ]),
    ];
    for (let number = 0; number < count; number += 1) {
        const [x, y, z] = [(number % 5) * 1.5 - 3, 2.5 + Math.floor(number / 5) * 3.5, ((number * 7) % 5) * 0.4];
        const first = bodies.length;
        for (const { at, size, parent, pin, lying } of parts) {
            bodies.push({ at: [x + at[0], y + at[1], z], shape: capsule(...size), turned: lying ? Math.PI / 2 : 0 });
            if (parent !== undefined) {
                joints.push({ bodies: [first + parent, bodies.length - 1], at: [x + pin[0], y + pin[1], z] });
            }
        }
    }
    return { bodies, joints };
}

/** A net of balls that hangs from one edge. */
function jointGrid(_dimension, side) {
    const bodies = [];
    const joints = [];
    for (let row = 0; row < side; row += 1) {
        for (let column = 0; column < side; column += 1) {
            const at = [column, 0 - row, 0];
            const number = bodies.push({ fixed: row === 0 && column % 4 === 0, at, shape: ball(0.25) }) - 1;
            if (column > 0) joints.push({ bodies: [number - 1, number], at: [column - 0.5, -row, 0] });
            if (row > 0) joints.push({ bodies: [number - side, number], at: [column, -row + 0.5, 0] });
        }
    }
    return { bodies, joints };
}

/** Boxes and balls on a hilly mesh (a chain of segments in 2D). */
function meshGround(dimension, count) {
    const cells = 40;
    const height = (x, z) => Math.sin(x * 0.9) * 0.8 + (dimension === 2 ? 0 : Math.cos(z * 0.7) * 0.8);
    const [vertices, indices] = [[], []];
    for (let i = 0; i <= cells; i += 1) {
        const x = i - cells / 2;
        if (dimension === 2) {
            vertices.push([x, height(x, 0), 0]);
            if (i > 0) indices.push([i - 1, i]);
            continue;
        }
        for (let j = 0; j <= cells; j += 1) {
            const z = j - cells / 2;
            vertices.push([x, height(x, z), z]);
            if (i > 0 && j > 0) {
                const [a, b, c, d] = [(i - 1) * (cells + 1) + j - 1, (i - 1) * (cells + 1) + j, i * (cells + 1) + j - 1, i * (cells + 1) + j];
                indices.push([a, b, c], [b, d, c]);
            }
        }
    }
    const bodies = [{ fixed: true, at: [0, 0, 0], shape: { kind: "mesh", vertices, indices } }];
    const side = dimension === 2 ? 25 : 16;
    for (let number = 0; number < count; number += 1) {
        const column = number % side;
        const row = dimension === 2 ? 0 : Math.floor(number / side) % side;
        const layer = Math.floor(number / (dimension === 2 ? side : side * side));
        bodies.push({
            at: [(column - side / 2) * 1.2, 4 + layer * 1.2, (row - side / 2) * 1.2],
            shape: number % 2 === 0 ? box(0.4, 0.4, 0.4) : ball(0.4),
        });
    }
    return { bodies, joints: [] };
}

/** Chains of balls that hang from a point each, and swing down from the horizontal. */
function chains(_dimension, count) {
    const [bodies, joints] = [[], []];
    for (let chain = 0; chain < count; chain += 1) {
        const x = chain * 12;
        let last = bodies.push({ fixed: true, at: [x, 10, 0], shape: ball(0.1) }) - 1;
        for (let link = 1; link <= 5; link += 1) {
            const next = bodies.push({ at: [x + link, 10, 0], shape: ball(0.3) }) - 1;
            joints.push({ bodies: [last, next], at: [x + (link === 1 ? 0 : link - 0.5), 10, 0] });
            last = next;
        }
    }
    return { bodies, joints, steps: 2000, warm: 3000 };
}

/** The scenes by name. */
export const SCENES = {
    "1000 boxes": (dimension) => boxes(dimension, 1000),
    "5000 boxes": (dimension) => boxes(dimension, 5000),
    "50 ragdolls": (dimension) => ragdolls(dimension, 50),
    "joint grid": (dimension) => jointGrid(dimension, 30),
    "a chain of 5": (dimension) => chains(dimension, 1),
    "10 chains of 5": (dimension) => chains(dimension, 10),
    "mesh ground": (dimension) => meshGround(dimension, 500),
};
