// Coloured line segments, or dots, that change each frame.

import {
    BufferAttribute,
    BufferGeometry,
    DynamicDrawUsage,
    LineBasicMaterial,
    LineSegments,
    Points,
    PointsMaterial,
    type Color,
    type Object3D,
} from "three";

/** Pixels of a dot. */
const DOT_SIZE = 7;

export class Lines {
    private readonly object: LineSegments<BufferGeometry, LineBasicMaterial> | Points<BufferGeometry, PointsMaterial>;
    private positions = new Float32Array(3 * 1024);
    private colors = new Float32Array(3 * 1024);
    private count = 0;

    constructor(parent: Object3D, overlay: boolean, dots = false) {
        const look = { vertexColors: true, depthTest: !overlay, transparent: overlay, fog: false };
        this.object = dots
            ? new Points(new BufferGeometry(), new PointsMaterial({ ...look, size: DOT_SIZE, sizeAttenuation: false }))
            : new LineSegments(new BufferGeometry(), new LineBasicMaterial(look));
        this.object.frustumCulled = false;
        this.object.renderOrder = 10;
        parent.add(this.object);
        this.attach();
    }

    private attach(): void {
        const { geometry } = this.object;
        geometry.dispose();
        geometry.setAttribute("position", new BufferAttribute(this.positions, 3).setUsage(DynamicDrawUsage));
        geometry.setAttribute("color", new BufferAttribute(this.colors, 3).setUsage(DynamicDrawUsage));
    }

    clear(): void {
        this.count = 0;
    }

    point(x: number, y: number, z: number, r: number, g: number, b: number): void {
        const at = 3 * this.count;
        if (at + 3 > this.positions.length) this.grow();
        this.positions[at] = x;
        this.positions[at + 1] = y;
        this.positions[at + 2] = z;
        this.colors[at] = r;
        this.colors[at + 1] = g;
        this.colors[at + 2] = b;
        this.count += 1;
    }

    line(from: readonly [number, number, number], to: readonly [number, number, number], color: Color): void {
        this.point(...from, color.r, color.g, color.b);
        this.point(...to, color.r, color.g, color.b);
    }

    private grow(): void {
        const [positions, colors] = [new Float32Array(2 * this.positions.length), new Float32Array(2 * this.colors.length)];
        positions.set(this.positions);
        colors.set(this.colors);
        this.positions = positions;
        this.colors = colors;
        this.attach();
    }

    /** Shows the lines since `clear`. */
    flush(): void {
        const { geometry } = this.object;
        geometry.setDrawRange(0, this.count);
        this.object.visible = this.count > 0;
        for (const name of ["position", "color"]) geometry.getAttribute(name).needsUpdate = true;
    }

    dispose(): void {
        this.object.removeFromParent();
        this.object.geometry.dispose();
        this.object.material.dispose();
    }
}
