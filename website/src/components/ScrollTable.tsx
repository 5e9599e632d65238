// A table that scrolls sideways in narrow windows, by touch, wheel or keys.

import { type ComponentProps, type ReactNode, useEffect, useRef, useState } from "react";

interface ScrollTableProps extends ComponentProps<"table"> {
    /** Name of the table for screen readers; the caption, or the number in the page and the names of the columns, replace a missing one. */
    readonly label?: string;
}

function nameOf(table: HTMLTableElement): string {
    const columns = Array.from(table.rows[0]?.cells ?? [], (cell) => cell.textContent ?? "");
    // Two tables may have equal columns, and names of regions differ.
    const number = Array.from(document.querySelectorAll(".scroll-table > table")).indexOf(table) + 1;
    return table.caption?.textContent ?? `Table ${number}: ${columns.filter((name) => name !== "").join(", ")}`;
}

/** Returns the name of the table while it is wider than its frame, and null otherwise. */
function useScrollName(label: string | undefined) {
    const frame = useRef<HTMLDivElement>(null);
    const table = useRef<HTMLTableElement>(null);
    const [name, setName] = useState<string | null>(null);
    useEffect(() => {
        const [outer, inner] = [frame.current, table.current];
        if (outer === null || inner === null) return undefined;
        const observer = new ResizeObserver(() =>
            setName(outer.scrollWidth > outer.clientWidth ? (label ?? nameOf(inner)) : null),
        );
        observer.observe(outer);
        observer.observe(inner);
        return () => observer.disconnect();
    }, [label]);
    return { frame, table, name };
}

export default function ScrollTable({ label, ...props }: ScrollTableProps): ReactNode {
    const { frame, table, name } = useScrollName(label);
    // A table that fits is no stop of the Tab key and no landmark.
    const region = name === null ? {} : { role: "region", "aria-label": name, tabIndex: 0 };
    return (
        <div ref={frame} className="scroll-table" {...region}>
            <table {...props} ref={table} />
        </div>
    );
}
