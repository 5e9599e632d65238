// How far this engine is ahead of its fastest peer, scene by scene.

import type { ReactNode } from "react";
import { contests, geometricMean } from "./contests";
import styles from "./charts.module.css";

/** The chart's left and right edges as ratios; its axis is logarithmic. */
const EDGES = [0.5, 8] as const;
const TICKS = [0.5, 1, 2, 4, 8];

function place(ratio: number): number {
    const [low, high] = EDGES.map(Math.log);
    return (100 * (Math.log(ratio) - low)) / (high - low);
}

interface LeadChartProps {
    readonly dimension: "2d" | "3d";
}

export default function LeadChart({ dimension }: LeadChartProps): ReactNode {
    const rows = contests(dimension, 1, "time");
    const mean = geometricMean(rows.map(({ lead }) => lead));
    return (
        <table className={styles.lead}>
            <caption>
                {dimension.toUpperCase()}: {mean.toFixed(2)} × as fast as the fastest peer (geometric mean of {rows.length}{" "}
                scenes)
            </caption>
            <tbody>
                {rows.map(({ scene, lead }) => {
                    const [from, to] = [Math.min(1, lead), Math.max(1, lead)].map(place);
                    return (
                        <tr key={scene}>
                            <th scope="row">{scene}</th>
                            <td>
                                <span className={styles.axis} style={{ left: `${place(1)}%` }} />
                                <span
                                    className={lead >= 1 ? styles.ahead : styles.behind}
                                    style={{ left: `${from}%`, width: `${to - from}%` }}
                                />
                                <span className={styles.value} style={{ left: `${to}%` }}>
                                    {lead.toFixed(2)}
                                </span>
                            </td>
                        </tr>
                    );
                })}
                <tr aria-hidden="true" className={styles.ticks}>
                    <th />
                    <td>
                        {TICKS.map((tick) => (
                            <span key={tick} style={{ left: `${place(tick)}%` }}>
                                {tick} ×
                            </span>
                        ))}
                    </td>
                </tr>
            </tbody>
        </table>
    );
}
