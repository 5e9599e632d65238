// Names and colours of curves.

import type { ReactNode } from "react";
import styles from "./charts.module.css";

interface Entry {
    readonly name: string;
    readonly colour: string;
    /** Lengths of dashes and gaps of a line; a box of the colour without them. */
    readonly dashes?: string;
}

function Mark({ colour, dashes }: Entry): ReactNode {
    if (dashes === undefined) return <span style={{ background: colour }} />;
    return (
        <svg width="32" height="8" aria-hidden="true">
            <line x1="0" x2="32" y1="4" y2="4" stroke={colour} strokeWidth="2.5" strokeDasharray={dashes} />
        </svg>
    );
}

export default function Legend({ entries }: { readonly entries: readonly Entry[] }): ReactNode {
    return (
        <ul className={styles.legend}>
            {entries.map((entry) => (
                <li key={entry.name}>
                    <Mark {...entry} />
                    {entry.name}
                </li>
            ))}
        </ul>
    );
}
