// Shows a program in 3D and its twin in 2D side by side: a program, a paragraph that ends with a colon, a program of `rapier2d`.

import type { Code, Paragraph, Root, RootContent } from "mdast";
import { element } from "./elements";

function isProgram(node: RootContent | undefined, crate: string): node is Code {
    return node?.type === "code" && node.lang === "rust" && node.value.includes(`use ${crate}::prelude::*;`);
}

function endsWithColon(node: RootContent | undefined): node is Paragraph {
    const last = node?.type === "paragraph" ? node.children.at(-1) : undefined;
    return last?.type === "text" && last.value.endsWith(":");
}

/** Replaces each pair of programs with tabs. All tabs of a page change together, and the choice is kept. */
export function showDimensions(tree: Root): void {
    const shown: RootContent[] = [];
    const { children } = tree;
    for (let index = 0; index < children.length; index += 1) {
        const [solid, words, flat] = children.slice(index, index + 3);
        if (!isProgram(solid, "rapier3d") || !endsWithColon(words) || !isProgram(flat, "rapier2d")) {
            shown.push(children[index]);
            continue;
        }
        const tabs = [
            element("TabItem", { value: "3d", label: "3D" }, [solid]),
            element("TabItem", { value: "2d", label: "2D" }, [words, flat]),
        ];
        shown.push(element("Tabs", { groupId: "dimension" }, tabs));
        index += 2;
    }
    tree.children = shown;
}
