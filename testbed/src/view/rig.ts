// Cameras: an orbit in 3D, panning and zooming in 2D.

import { MOUSE, OrthographicCamera, PerspectiveCamera, Raycaster, TOUCH, Vector2, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Vec } from "../core/engine.ts";
import type { Camera, Point } from "../core/scene.ts";

export interface PickRay {
    origin: Vec;
    direction: Vec;
}

/** Eye of 3D scenes without one. */
const EYE = [14, 10, 18] as const;
const HEIGHT = 16;

export class Rig {
    readonly camera: PerspectiveCamera | OrthographicCamera;
    readonly controls: OrbitControls;
    private readonly caster = new Raycaster();
    private height = HEIGHT;
    private followed: Vector3 | null = null;
    /** Angle of the scene's eye about the vertical, from the z axis to the x axis. */
    around = 0;

    constructor(
        canvas: HTMLCanvasElement,
        readonly flat: boolean,
    ) {
        this.camera = flat ? new OrthographicCamera(-1, 1, 1, -1, 0.1, 100) : new PerspectiveCamera(45, 1, 0.1, 500);
        this.controls = new OrbitControls(this.camera, canvas);
        this.controls.enableDamping = true;
        this.controls.dampingFactor = 0.12;
        this.controls.zoomToCursor = true;
        if (flat) this.makeFlat();
        else this.controls.maxPolarAngle = 0.52 * Math.PI;
    }

    private makeFlat(): void {
        const { controls } = this;
        controls.enableRotate = false;
        controls.mouseButtons = { LEFT: MOUSE.PAN, MIDDLE: MOUSE.DOLLY, RIGHT: MOUSE.PAN };
        controls.touches = { ONE: TOUCH.PAN, TWO: TOUCH.DOLLY_PAN };
    }

    /** Places the camera for a scene. */
    frame(view: Camera): void {
        const [x, y, z] = view.target;
        this.controls.target.set(x, y, this.flat ? 0 : z);
        this.followed = null;
        this.height = view.height ?? HEIGHT;
        if (this.flat) this.camera.position.set(x, y, 50);
        else this.camera.position.set(...(view.eye ?? EYE));
        this.around = Math.atan2(this.camera.position.x - x, this.camera.position.z - z);
        this.camera.zoom = 1;
        this.controls.update();
    }

    /** Fits the camera to a viewport. Narrow viewports see the same width as a square one. */
    fit(width: number, height: number): void {
        const aspect = width / Math.max(1, height);
        if (this.camera instanceof PerspectiveCamera) {
            this.camera.aspect = aspect;
            this.camera.fov = aspect >= 1.2 ? 45 : Math.min(75, (2 * Math.atan(Math.tan(0.3927) * (1.2 / aspect)) * 180) / Math.PI);
        } else {
            const half = 0.5 * this.height * Math.max(1, 1.5 / aspect);
            this.camera.top = half;
            this.camera.bottom = -half;
            this.camera.left = -half * aspect;
            this.camera.right = half * aspect;
        }
        this.camera.updateProjectionMatrix();
    }

    /** Moves eye and target with a point that the scene names. */
    follow(point: Point | null): void {
        if (point === null) {
            this.followed = null;
            return;
        }
        const at = new Vector3(point.x, point.y, point.z ?? 0);
        if (this.followed) {
            const way = at.clone().sub(this.followed);
            this.controls.target.add(way);
            this.camera.position.add(way);
        }
        this.followed = at;
    }

    update(): void {
        this.controls.update();
    }

    /** The ray through a point of a viewport, in the range -1 to 1. */
    ray(x: number, y: number): PickRay {
        this.camera.updateMatrixWorld();
        this.caster.setFromCamera(new Vector2(x, y), this.camera);
        const { origin, direction } = this.caster.ray;
        return { origin, direction };
    }

    /** The point of a ray at the depth of another point. */
    atDepthOf(ray: PickRay, point: Vec): Vec {
        const normal = this.camera.getWorldDirection(new Vector3());
        const [origin, direction] = [vector(ray.origin), vector(ray.direction)];
        const along = vector(point).sub(origin).dot(normal) / Math.max(1e-6, direction.dot(normal));
        return origin.addScaledVector(direction, along);
    }

    /** Size of a metre's worth of view: distance in 3D, visible height in 2D. */
    get reach(): number {
        if (this.flat) return this.height / this.camera.zoom;
        return this.camera.position.distanceTo(this.controls.target);
    }

    dispose(): void {
        this.controls.dispose();
    }
}

function vector({ x, y, z }: Vec): Vector3 {
    return new Vector3(x, y, z);
}
