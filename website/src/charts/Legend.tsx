// Engines and their colours.

import type { ReactNode } from "react";
import { colour } from "./engines";
import styles from "./charts.module.css";

export default function Legend({ engines }: { readonly engines: readonly string[] }): ReactNode {
    return (
        <ul className={styles.legend}>
            {engines.map((engine) => (
                <li key={engine}>
                    <span style={{ background: colour(engine) }} />
                    {engine}
                </li>
            ))}
        </ul>
    );
}
