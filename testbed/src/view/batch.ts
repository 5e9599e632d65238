// Instances of one geometry with one material: a scene of thousands of boxes is one draw call.

import { Color, DynamicDrawUsage, InstancedMesh, Matrix4, type BufferGeometry, type Material, type Object3D } from "three";

export class Batch {
    mesh: InstancedMesh;
    private count = 0;
    /** For each instance, the function that receives its new index when instances move. */
    private readonly owners: ((index: number) => void)[] = [];

    constructor(
        private readonly parent: Object3D,
        readonly geometry: BufferGeometry,
        private readonly material: Material,
        private readonly casts: boolean,
        private readonly layer: number,
    ) {
        this.mesh = this.create(16);
        parent.add(this.mesh);
    }

    private create(capacity: number): InstancedMesh {
        const mesh = new InstancedMesh(this.geometry, this.material, capacity);
        mesh.instanceMatrix.setUsage(DynamicDrawUsage);
        mesh.setColorAt(0, new Color(1, 1, 1));
        mesh.frustumCulled = false;
        mesh.castShadow = this.casts;
        mesh.receiveShadow = true;
        mesh.renderOrder = this.layer;
        mesh.count = 0;
        return mesh;
    }

    add(owner: (index: number) => void): number {
        if (this.count === this.mesh.instanceMatrix.count) this.grow();
        const index = this.count;
        this.owners[index] = owner;
        this.count += 1;
        this.mesh.count = this.count;
        return index;
    }

    private grow(): void {
        const old = this.mesh;
        const mesh = this.create(2 * old.instanceMatrix.count);
        mesh.instanceMatrix.array.set(old.instanceMatrix.array);
        if (mesh.instanceColor && old.instanceColor) mesh.instanceColor.array.set(old.instanceColor.array);
        this.parent.remove(old);
        old.dispose();
        this.parent.add(mesh);
        this.mesh = mesh;
    }

    /** Removes an instance; the last one takes its place. */
    remove(index: number): void {
        const last = this.count - 1;
        const owner = this.owners[last];
        if (index !== last && owner) {
            const { instanceMatrix, instanceColor } = this.mesh;
            instanceMatrix.array.copyWithin(16 * index, 16 * last, 16 * last + 16);
            instanceColor?.array.copyWithin(3 * index, 3 * last, 3 * last + 3);
            this.owners[index] = owner;
            owner(index);
        }
        this.owners.length = last;
        this.count = last;
        this.mesh.count = last;
        this.touch();
        if (this.mesh.instanceColor) this.mesh.instanceColor.needsUpdate = true;
    }

    setMatrix(index: number, matrix: Matrix4): void {
        matrix.toArray(this.mesh.instanceMatrix.array, 16 * index);
    }

    setColor(index: number, color: Color): void {
        this.mesh.setColorAt(index, color);
        if (this.mesh.instanceColor) this.mesh.instanceColor.needsUpdate = true;
    }

    /** Uploads the matrices at the next frame. */
    touch(): void {
        this.mesh.instanceMatrix.needsUpdate = true;
    }

    dispose(): void {
        this.parent.remove(this.mesh);
        this.mesh.dispose();
        this.geometry.dispose();
    }
}
