// Names and colours of curves.

import type { ReactNode } from "react";
import styles from "./charts.module.css";

interface Entry {
    readonly name: string;
    readonly colour: string;
}

export default function Legend({ entries }: { readonly entries: readonly Entry[] }): ReactNode {
    return (
        <ul className={styles.legend}>
            {entries.map(({ name, colour }) => (
                <li key={name}>
                    <span style={{ background: colour }} />
                    {name}
                </li>
            ))}
        </ul>
    );
}
