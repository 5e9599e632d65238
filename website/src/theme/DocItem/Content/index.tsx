// Documents; long pages of the reference begin with a filter of their names.

import { useDoc } from "@docusaurus/plugin-content-docs/client";
import Content from "@theme-original/DocItem/Content";
import type ContentType from "@theme/DocItem/Content";
import { type ComponentProps, type ReactNode, useRef } from "react";
import NameFilter from "@site/src/components/NameFilter";

export default function DocItemContent(props: ComponentProps<typeof ContentType>): ReactNode {
    const page = useRef<HTMLDivElement>(null);
    const { metadata, toc } = useDoc();
    const filtered = /\/api\//.test(metadata.permalink) && toc.length >= NameFilter.NAMES_MIN;
    return (
        <div ref={page}>
            {filtered && <NameFilter page={page} />}
            <Content {...props} />
        </div>
    );
}
