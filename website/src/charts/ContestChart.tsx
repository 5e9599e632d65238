// All engines in all scenes, one bar each.

import clsx from "clsx";
import { type ReactNode, useState } from "react";
import Choice from "./Choice";
import { type Contest, type Measure, contests } from "./contests";
import { colour } from "./engines";
import Legend from "./Legend";
import styles from "./charts.module.css";

const MEASURES = [
    ["time", "Time"],
    ["memory", "Memory"],
    ["overlap", "Overlap"],
] as const;

const UNITS: Record<Measure, { caption: string; write: (value: number) => string }> = {
    time: { caption: "Milliseconds per step", write: (value) => `${value.toPrecision(3)} ms` },
    memory: { caption: "Memory of the world per dynamic body", write: (value) => `${(value / 1024).toPrecision(3)} KiB` },
    overlap: { caption: "Deepest overlap of two bodies at the end, in metres", write: (value) => `${value.toFixed(4)} m` },
};

function Row({ contest, measure }: { readonly contest: Contest; readonly measure: Measure }): ReactNode {
    const values = contest.entries.map(({ value }) => value);
    const [largest, least] = [Math.max(...values), Math.min(...values)];
    return (
        <tr>
            <th scope="row">{contest.scene}</th>
            <td>
                {contest.entries.map(({ engine, value }) => (
                    <div key={engine} className={clsx(styles.bar, value === least && styles.best)} title={engine}>
                        <span
                            className={styles.fill}
                            style={{ width: `${largest > 0 ? (70 * value) / largest : 0}%`, background: colour(engine) }}
                        />
                        <span className="visually-hidden">{engine}:</span>
                        <span>{UNITS[measure].write(value)}</span>
                    </div>
                ))}
            </td>
        </tr>
    );
}

export default function ContestChart(): ReactNode {
    const [dimension, setDimension] = useState<"2d" | "3d">("3d");
    const [threads, setThreads] = useState(1);
    const [measure, setMeasure] = useState<Measure>("time");
    const rows = contests(dimension, threads, measure);
    const engines = [...new Set(rows.flatMap(({ entries }) => entries.map(({ engine }) => engine)))];
    return (
        <>
            <div className={styles.choices}>
                <Choice
                    label="Dimension"
                    options={[
                        ["3d", "3D"],
                        ["2d", "2D"],
                    ]}
                    value={dimension}
                    choose={setDimension}
                />
                <Choice
                    label="Threads"
                    options={[
                        [1, "1"],
                        [2, "2"],
                    ]}
                    value={threads}
                    choose={setThreads}
                />
                <Choice label="Measure" options={MEASURES} value={measure} choose={setMeasure} />
            </div>
            <Legend entries={engines.map((name) => ({ name, colour: colour(name) }))} />
            <table className={styles.bars}>
                <caption>{UNITS[measure].caption}: less is better. Each scene has its own scale.</caption>
                <tbody>
                    {rows.map((contest) => (
                        <Row key={contest.scene} contest={contest} measure={measure} />
                    ))}
                </tbody>
            </table>
        </>
    );
}
