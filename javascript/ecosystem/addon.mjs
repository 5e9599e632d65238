// A scene as users of three.js's addon write it.

import { BoxGeometry, InstancedMesh, Mesh, MeshBasicMaterial, Scene, SphereGeometry, Vector3 } from "three";
import { RapierPhysics } from "three/addons/physics/RapierPhysics.js";

/** Runs two seconds of the scene. Returns the heights at its end. */
export async function run() {
    const physics = await RapierPhysics();
    const [scene, material] = [new Scene(), new MeshBasicMaterial()];
    const floor = new Mesh(new BoxGeometry(20, 2, 20), material);
    floor.position.y = -1;
    floor.userData.physics = { mass: 0 };
    const ball = new Mesh(new SphereGeometry(0.5), material);
    ball.position.y = 3;
    ball.userData.physics = { mass: 1, restitution: 0 };
    const boxes = new InstancedMesh(new BoxGeometry(1, 1, 1), material, 3);
    boxes.userData.physics = { mass: 1 };
    scene.add(floor, ball, boxes);
    physics.addScene(scene);
    for (let index = 0; index < 3; index += 1) {
        physics.setMeshPosition(boxes, new Vector3(3 * index - 8, 2, 4), index);
    }
    // The addon removes bodies before their colliders.
    const stones = new InstancedMesh(new BoxGeometry(1, 1, 1), material, 2);
    for (const gone of [new Mesh(new SphereGeometry(0.5), material), stones]) {
        gone.position.set(0, 5, 0);
        physics.addMesh(gone, 1);
        await new Promise((resolve) => setTimeout(resolve, 100));
        physics.removeMesh(gone);
        physics.removeMesh(gone);
    }
    await new Promise((resolve) => setTimeout(resolve, 2500));
    return { ball: ball.position.y, boxes: [0, 1, 2].map((index) => boxes.instanceMatrix.array[16 * index + 13]) };
}
