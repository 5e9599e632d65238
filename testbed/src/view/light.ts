// Light of 3D scenes: a sky that lights surfaces from all sides, and a sun whose shadow map covers just the bodies in view.

import {
    Color,
    DataTexture,
    DirectionalLight,
    EquirectangularReflectionMapping,
    LightProbe,
    LinearFilter,
    SphericalHarmonics3,
    SRGBColorSpace,
    Vector3,
    type Scene,
} from "three";
import type { Theme } from "./theme.ts";

/** Samples of the sky from pole to pole. */
const SKY_HEIGHT = 64;
/** Softboxes of the sky: direction (angles about the vertical and above the horizon), half size in radians, brightness. */
const SOFTBOXES = [
    { around: 2.3, above: 0.75, half: 0.45, light: 5 },
    { around: -0.6, above: 0.5, half: 0.35, light: 2.5 },
] as const;

const SHADOW_MAP = 2048;
/**
 * Place of the sun relative to the target, in units of the view's reach: height, distance, and angle to the left of the eye
 * of the scene. Shadows fall to the right, where the eye sees them.
 */
const SUN_HEIGHT = 1.1;
const SUN_DISTANCE = 0.8;
const SUN_ANGLE = 1.7;
/** Half width of the shadow map at most, and depths, in units of the reach. */
const SIDE_MAX = 1.1;
const [NEAR, FAR] = [0.3, 2.7];
/** Width of soft edges in metres, and the largest one in texels: a wider one is grainy. */
const SOFTNESS = 0.07;
const RADIUS_MAX = 4.5;
/** Ratio of neighbouring widths of the map. Steps instead of a continuous width keep edges still while bodies move. */
const WIDTH_RATIO = 1.25;

/** Something that casts a shadow: its centre, and the radius around it. */
export type Sphere = readonly [x: number, y: number, z: number, radius: number];

/**
 * Light from all directions, as spherical harmonics of the second order: they cost a few multiplications a pixel, and reflections
 * of a map would double the time of a frame in software. `shade` receives the angles about the vertical and above the horizon.
 */
function harmonics(shade: (around: number, above: number, color: Color) => void): SphericalHarmonics3 {
    const sum = new SphericalHarmonics3();
    const [basis, direction, color] = [Array<number>(9).fill(0), new Vector3(), new Color()];
    const step = Math.PI / SKY_HEIGHT;
    for (let index = 0; index < 2 * SKY_HEIGHT * SKY_HEIGHT; index++) {
        const around = ((index % (2 * SKY_HEIGHT)) + 0.5) * step - Math.PI;
        const above = (Math.floor(index / (2 * SKY_HEIGHT)) + 0.5) * step - Math.PI / 2;
        direction.set(Math.sin(around) * Math.cos(above), Math.sin(above), Math.cos(around) * Math.cos(above));
        SphericalHarmonics3.getBasisAt(direction, basis);
        shade(around, above, color);
        const light = new Vector3(color.r, color.g, color.b).multiplyScalar(step * step * Math.cos(above));
        sum.coefficients.forEach((coefficient, order) => coefficient.addScaledVector(light, basis[order] ?? 0));
    }
    return sum;
}

/** The colour of the horizon below it, and a gradient above. */
function gradient(horizon: Color, zenith: Color): DataTexture {
    const data = new Uint8Array(4 * SKY_HEIGHT);
    for (let row = 0; row < SKY_HEIGHT; row++) {
        const above = ((row + 0.5) / SKY_HEIGHT - 0.5) * Math.PI;
        const { r, g, b } = horizon.clone().lerp(zenith, smooth(above / 0.9)).convertLinearToSRGB();
        data.set([r, g, b, 1].map((value) => Math.round(255 * value)), 4 * row);
    }
    const texture = new DataTexture(data, 1, SKY_HEIGHT);
    texture.colorSpace = SRGBColorSpace;
    texture.mapping = EquirectangularReflectionMapping;
    texture.minFilter = texture.magFilter = LinearFilter;
    texture.needsUpdate = true;
    return texture;
}

const smooth = (value: number): number => {
    const t = Math.min(1, Math.max(0, value));
    return t * t * (3 - 2 * t);
};

/** The sky of a theme: what is seen behind the scene, and what lights it. */
export class Sky {
    private readonly backdrop: DataTexture;
    private readonly room: SphericalHarmonics3;

    constructor(private readonly theme: Theme) {
        const { sky, zenith, room } = theme;
        // The fog has the colour of the horizon, so floors end without an edge.
        this.backdrop = gradient(sky, zenith);
        this.room = harmonics((around, above, color) => {
            color.lerpColors(room.ground, room.sky, smooth(0.5 + above / 0.7));
            for (const box of SOFTBOXES) {
                const distance = Math.max(Math.abs(around - box.around) * Math.cos(above), Math.abs(above - box.above));
                color.multiplyScalar(1 + (box.light - 1) * smooth((box.half - distance) / 0.12));
            }
        });
    }

    light(scene: Scene): void {
        scene.background = this.backdrop;
        scene.add(new LightProbe(this.room, this.theme.room.intensity));
    }

    dispose(): void {
        this.backdrop.dispose();
    }
}

/** The sun of one view. */
export class Sun {
    readonly lamp: DirectionalLight;

    constructor(private readonly scene: Scene, theme: Theme) {
        this.lamp = new DirectionalLight(theme.sun.color, theme.sun.intensity);
        this.lamp.castShadow = true;
        this.lamp.shadow.mapSize.set(SHADOW_MAP, SHADOW_MAP);
        this.lamp.shadow.intensity = theme.shadow;
        scene.add(this.lamp, this.lamp.target);
    }

    /** Fits the shadow map to casters in view, or to the whole view without them. `eye` is the angle of the scene's eye. */
    aim(center: Vector3, reach: number, eye: number, casters: readonly Sphere[] | null): void {
        const { lamp } = this;
        const angle = eye - SUN_ANGLE;
        const place = new Vector3(SUN_DISTANCE * Math.sin(angle), SUN_HEIGHT, SUN_DISTANCE * Math.cos(angle));
        const forward = place.clone().normalize();
        const right = new Vector3(0, 1, 0).cross(forward).normalize();
        const up = forward.clone().cross(right);
        const limit = SIDE_MAX * reach;
        const [x, y] = [range(casters, right, center, limit), range(casters, up, center, limit)];
        const half = Math.min(limit, WIDTH_RATIO ** Math.ceil(Math.log(Math.max(x.half, y.half, 0.5)) / Math.log(WIDTH_RATIO)));
        const texel = (2 * half) / SHADOW_MAP;
        // The map moves by whole texels, which keeps edges of shadows still.
        const along = (axis: Vector3, middle: number): Vector3 => {
            const at = axis.dot(center) + middle;
            return axis.clone().multiplyScalar(Math.round(at / texel) * texel - axis.dot(center));
        };
        lamp.target.position.copy(center).add(along(right, x.middle)).add(along(up, y.middle));
        lamp.position.copy(lamp.target.position).addScaledVector(place, reach);
        const { camera } = lamp.shadow;
        camera.left = camera.bottom = -half;
        camera.right = camera.top = half;
        camera.near = NEAR * reach;
        camera.far = FAR * reach;
        camera.updateProjectionMatrix();
        lamp.shadow.radius = Math.min(RADIUS_MAX, Math.max(1, SOFTNESS / texel));
        // A bias along normals would fail for meshes whose triangles face away from the light.
        lamp.shadow.bias = (-1.5 * (lamp.shadow.radius + 1) * texel) / (camera.far - camera.near);
    }

    dispose(): void {
        this.scene.remove(this.lamp, this.lamp.target);
        this.lamp.dispose();
    }
}

/** The range of casters along an axis of the map: its middle relative to the centre, and its half. */
function range(casters: readonly Sphere[] | null, axis: Vector3, center: Vector3, limit: number): { middle: number; half: number } {
    let [low, high] = [Infinity, -Infinity];
    for (const [x, y, z, radius] of casters ?? []) {
        const at = axis.x * (x - center.x) + axis.y * (y - center.y) + axis.z * (z - center.z);
        if (Math.abs(at) > limit + radius) continue;
        low = Math.min(low, at - radius);
        high = Math.max(high, at + radius);
    }
    if (!(low < high)) return { middle: 0, half: limit };
    [low, high] = [Math.max(low, -limit), Math.min(high, limit)];
    return { middle: (low + high) / 2, half: (high - low) / 2 };
}
