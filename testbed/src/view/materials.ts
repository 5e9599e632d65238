// Materials of the picture, with lines that make shapes readable: edges of boxes, outlines in 2D, a grid on
// the ground. The lines are computed in the shader, so they cost no geometry and stay equally thick.

import { BackSide, DoubleSide, FrontSide, Material, MeshBasicMaterial, MeshStandardMaterial, type WebGLProgramParametersWithUniforms } from "three";
import type { Theme } from "./theme.ts";

export type Surface = "solid" | "ground" | "glass";

const BOX_VERTEX = `
varying vec3 vBoxHalf;
varying vec3 vBoxAt;
`;

const BOX_VERTEX_MAIN = `
vBoxHalf = 0.5 * vec3(length(instanceMatrix[0].xyz), length(instanceMatrix[1].xyz), length(instanceMatrix[2].xyz));
vBoxAt = position * 2.0 * vBoxHalf;
`;

/** On a face, the middle one of the three distances to the sides is the distance to the next edge. */
const BOX_FRAGMENT = `
vec3 side = vBoxHalf - abs(vBoxAt);
float edge = max(min(side.x, side.y), min(max(side.x, side.y), side.z));
float thick = clamp(0.05 * min(vBoxHalf.x, min(vBoxHalf.y, vBoxHalf.z)), 0.004, 0.03);
float soft = max(fwidth(edge), 1e-5);
float line = 1.0 - smoothstep(thick, thick + soft, edge);
line *= clamp(2.0 * thick / soft, 0.0, 1.0);
diffuseColor.rgb *= mix(1.0, EDGE, line);
`;

const GRID_VERTEX = `
varying vec3 vGridAt;
varying vec3 vGridNormal;
`;

const GRID_VERTEX_MAIN = `
vec4 gridAt = vec4(position, 1.0);
vec3 gridNormal = normal;
#ifdef USE_INSTANCING
gridAt = instanceMatrix * gridAt;
gridNormal = mat3(instanceMatrix) * gridNormal;
#endif
vGridAt = (modelMatrix * gridAt).xyz;
vGridNormal = normalize(gridNormal);
`;

const GRID_FRAGMENT = `
vec2 cell = vGridAt.xz;
vec2 width = max(fwidth(cell), vec2(1e-5));
vec2 near1 = abs(fract(cell - 0.5) - 0.5) / width;
vec2 near5 = abs(fract(cell / 5.0 - 0.5) - 0.5) * 5.0 / width;
float fine = (1.0 - min(min(near1.x, near1.y), 1.0)) * (1.0 - smoothstep(0.15, 0.5, max(width.x, width.y)));
float coarse = (1.0 - min(min(near5.x, near5.y) / 1.3, 1.0)) * (1.0 - smoothstep(0.6, 2.0, max(width.x, width.y)));
float level = smoothstep(0.9, 0.99, abs(normalize(vGridNormal).y));
diffuseColor.rgb = mix(diffuseColor.rgb, GRID, level * max(0.35 * fine, 0.6 * coarse));
`;

function insert(shader: WebGLProgramParametersWithUniforms, vertex: [string, string], fragment: [string, string]): void {
    shader.vertexShader = vertex[0] + shader.vertexShader.replace("#include <begin_vertex>", `#include <begin_vertex>\n${vertex[1]}`);
    shader.fragmentShader =
        fragment[0] + shader.fragmentShader.replace("#include <color_fragment>", `#include <color_fragment>\n${fragment[1]}`);
}

function vec3(color: { r: number; g: number; b: number }): string {
    return `vec3(${color.r.toFixed(4)}, ${color.g.toFixed(4)}, ${color.b.toFixed(4)})`;
}

/** A material of 3D shapes. */
export function solidMaterial(theme: Theme, surface: Surface, box: boolean): Material {
    const glass = surface === "glass";
    const material = new MeshStandardMaterial({
        roughness: surface === "ground" ? 0.95 : 0.62,
        metalness: 0,
        vertexColors: true,
        transparent: glass,
        opacity: glass ? 0.16 : 1,
        depthWrite: !glass,
        side: surface === "ground" ? DoubleSide : FrontSide,
        // Closed shapes cast the shadow of their far side, so that no face shades itself. Ground may be open.
        shadowSide: surface === "ground" ? DoubleSide : BackSide,
    });
    const grid = surface === "ground";
    material.onBeforeCompile = (shader) => {
        if (box) {
            const edge = BOX_FRAGMENT.replace("EDGE", theme.edge.toFixed(3));
            insert(shader, [BOX_VERTEX, BOX_VERTEX_MAIN], [BOX_VERTEX, edge]);
        }
        if (grid) {
            const lines = GRID_FRAGMENT.replace("GRID", vec3(theme.grid));
            insert(shader, [GRID_VERTEX, GRID_VERTEX_MAIN], [GRID_VERTEX, lines]);
        }
    };
    material.customProgramCacheKey = () => `${theme.name} ${surface} ${box}`;
    return material;
}

const RIM_FRAGMENT = `
float rimWidth = max(fwidth(vRim), 1e-6);
float inside = smoothstep(0.6, 1.7, vRim / rimWidth);
diffuseColor.rgb = mix(diffuseColor.rgb * EDGE, diffuseColor.rgb, inside);
diffuseColor.a = mix(max(diffuseColor.a, RIM_ALPHA), diffuseColor.a, inside);
`;

/** A material of 2D shapes. */
export function flatMaterial(theme: Theme, surface: Surface): Material {
    const glass = surface === "glass";
    const material = new MeshBasicMaterial({
        vertexColors: true,
        transparent: glass,
        opacity: glass ? 0.22 : 1,
        depthWrite: !glass,
        side: DoubleSide,
    });
    const edge = surface === "ground" && theme.name === "dark" ? 1.7 : theme.edge;
    material.onBeforeCompile = (shader) => {
        const fragment = RIM_FRAGMENT.replace("EDGE", edge.toFixed(3)).replace("RIM_ALPHA", glass ? "0.7" : "1.0");
        insert(shader, ["attribute float rim;\nvarying float vRim;\n", "vRim = rim;"], ["varying float vRim;\n", fragment]);
    };
    material.customProgramCacheKey = () => `flat ${theme.name} ${surface}`;
    return material;
}
