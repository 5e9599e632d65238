// Time of a step over the number of bodies, on logarithmic axes.

import { type ReactNode, useState } from "react";
import data from "@site/generated/data/growth.json";
import Choice from "./Choice";
import { colour } from "./engines";
import Legend from "./Legend";
import styles from "./charts.module.css";

const WIDTH = 760;
const HEIGHT = 400;
const MARGIN = { left: 62, right: 16, top: 12, bottom: 44 };

/** The curves whose horizontal axis is the number of bodies. */
const CURVES = data.filter(({ title }) => /^(Bodies that are awake|Fixed bodies|Sleeping bodies)/.test(title));

interface Point {
    readonly bodies: number;
    readonly time: number;
}

/** Powers of ten that enclose the values. */
function decades(values: readonly number[]): number[] {
    const low = Math.floor(Math.log10(Math.min(...values)) + 1e-9);
    const high = Math.ceil(Math.log10(Math.max(...values)) - 1e-9);
    return Array.from({ length: high - low + 1 }, (_, index) => 10 ** (low + index));
}

function scale(ticks: readonly number[], from: number, to: number): (value: number) => number {
    const [low, high] = [Math.log(ticks[0]), Math.log(ticks[ticks.length - 1])];
    return (value) => from + ((Math.log(value) - low) / (high - low)) * (to - from);
}

function write(value: number): string {
    return value >= 1000 ? value.toLocaleString("en").replaceAll(",", " ") : String(Number(value.toPrecision(3)));
}

function Plot({ rows }: { readonly rows: (typeof CURVES)[number]["rows"] }): ReactNode {
    const points = rows.filter((row): row is typeof row & Point => row.bodies !== null && row.time !== null);
    const columns = decades(points.map(({ bodies }) => bodies));
    const lines = decades(points.map(({ time }) => time));
    const x = scale(columns, MARGIN.left, WIDTH - MARGIN.right);
    const y = scale(lines, HEIGHT - MARGIN.bottom, MARGIN.top);
    const engines = [...new Set(points.map(({ engine }) => engine))];
    return (
        <>
            <Legend engines={engines} />
            <svg
                className={styles.plot}
                viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
                role="img"
                aria-label="Milliseconds per step over the number of bodies"
            >
                {columns.map((tick) => (
                    <g key={tick}>
                        <line className={styles.grid} x1={x(tick)} x2={x(tick)} y1={MARGIN.top} y2={HEIGHT - MARGIN.bottom} />
                        <text x={x(tick)} y={HEIGHT - MARGIN.bottom + 18} textAnchor="middle">
                            {write(tick)}
                        </text>
                    </g>
                ))}
                {lines.map((tick) => (
                    <g key={tick}>
                        <line className={styles.grid} x1={MARGIN.left} x2={WIDTH - MARGIN.right} y1={y(tick)} y2={y(tick)} />
                        <text x={MARGIN.left - 8} y={y(tick) + 4} textAnchor="end">
                            {write(tick)}
                        </text>
                    </g>
                ))}
                <text x={(WIDTH + MARGIN.left) / 2} y={HEIGHT - 6} textAnchor="middle">
                    bodies
                </text>
                <text transform={`translate(14 ${HEIGHT / 2}) rotate(-90)`} textAnchor="middle">
                    ms per step
                </text>
                {engines.map((engine) => {
                    const curve = points.filter((point) => point.engine === engine);
                    return (
                        <g key={engine} style={{ color: colour(engine) }}>
                            <polyline
                                fill="none"
                                stroke="currentColor"
                                strokeWidth={2.5}
                                points={curve.map((point) => `${x(point.bodies)},${y(point.time)}`).join(" ")}
                            />
                            {curve.map((point) => (
                                <circle key={point.bodies} cx={x(point.bodies)} cy={y(point.time)} r={5} fill="currentColor">
                                    <title>{`${engine}, ${write(point.bodies)} bodies: ${write(point.time)} ms`}</title>
                                </circle>
                            ))}
                        </g>
                    );
                })}
            </svg>
        </>
    );
}

export default function GrowthChart(): ReactNode {
    const [title, setTitle] = useState(CURVES[0].title);
    const curve = CURVES.find((candidate) => candidate.title === title) ?? CURVES[0];
    return (
        <>
            <div className={styles.choices}>
                <Choice
                    label="World"
                    options={CURVES.map((each) => [each.title, each.title] as const)}
                    value={title}
                    choose={setTitle}
                />
            </div>
            <p>{curve.note}</p>
            <Plot rows={curve.rows} />
        </>
    );
}
