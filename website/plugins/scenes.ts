// Adds scenes of the testbed to sections of the guide. The documents stay plain Markdown.

import type { Heading, Root, RootContent } from "mdast";
import { element } from "./elements";

/** Scenes by document and heading. The scene stands at the end of the section. */
const SCENES: Readonly<Record<string, Readonly<Record<string, string>>>> = {
    bodies: {
        "Forces and impulses": "explosions",
        "Locked axes, damping, gravity, dominance": "locked-axes",
        "Platforms and lifts": "platforms",
        "Spinning rods": "t-handle",
    },
    colliders: {
        Shapes: "shapes",
        "Friction and restitution": "restitution",
        "Collision filtering": "collision-groups",
        Sensors: "sensors",
    },
    "contacts-and-events": { Events: "collision-events" },
    hooks: { Hooks: "one-way" },
    multibodies: { Multibodies: "multibody" },
    queries: { "After a step": "radar", "Hits of shape casts": "shape-cast" },
};

function isHeading(node: RootContent): node is Heading {
    return node.type === "heading";
}

function titleOf({ children }: Heading): string {
    return children.map((child) => ("value" in child ? child.value : "")).join("");
}

/** Inserts the scenes of a document. Fails if a heading does not exist: the document has changed. */
export function showScenes(tree: Root, document: string): void {
    for (const [title, scene] of Object.entries(SCENES[document] ?? {})) {
        const start = tree.children.findIndex((node) => isHeading(node) && titleOf(node) === title);
        if (start < 0) throw new Error(`plugins/scenes.ts: docs/guide/${document}.md has no heading "${title}"`);
        const next = tree.children.findIndex((node, index) => index > start && isHeading(node));
        tree.children.splice(next < 0 ? tree.children.length : next, 0, element("SceneCard", { scene }, []));
    }
}
