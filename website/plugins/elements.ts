// Elements of the theme in documents.

import type { RootContent } from "mdast";

/** An element of the theme, as the parser of MDX would write it. */
export function element(name: string, attributes: Record<string, string>, children: readonly RootContent[]): RootContent {
    return {
        type: "mdxJsxFlowElement",
        name,
        attributes: Object.entries(attributes).map(([key, value]) => ({ type: "mdxJsxAttribute", name: key, value })),
        children,
    } as unknown as RootContent;
}
