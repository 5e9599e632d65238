// Curves over logarithmic axes.

import { type ReactNode, useEffect, useRef, useState } from "react";
import styles from "./charts.module.css";

const MARGIN = { left: 84, right: 28, top: 12, bottom: 44 };

export interface Point {
    readonly x: number;
    readonly y: number;
    /** The text that appears under the pointer. */
    readonly note: string;
}

export interface Curve {
    readonly name: string;
    readonly colour: string;
    /** Lengths of dashes and gaps; a full line without them. */
    readonly dashes?: string;
    readonly points: readonly Point[];
}

interface LogPlotProps {
    readonly curves: readonly Curve[];
    /** The text for readers without the picture. */
    readonly label: string;
    readonly x: string;
    readonly y: string;
    /** Width until the page is active (pixels). */
    readonly width?: number;
    readonly height?: number;
    /** The marks of the horizontal axis; powers of ten by default. */
    readonly columns?: readonly number[];
}

/** Powers of ten that enclose the values. */
function decades(values: readonly number[]): number[] {
    const low = Math.floor(Math.log10(Math.min(...values)) + 1e-9);
    const high = Math.max(low + 1, Math.ceil(Math.log10(Math.max(...values)) - 1e-9));
    return Array.from({ length: high - low + 1 }, (_, index) => 10 ** (low + index));
}

function scale(ticks: readonly number[], from: number, to: number): (value: number) => number {
    const [low, high] = [Math.log(ticks[0]), Math.log(ticks[ticks.length - 1])];
    return (value) => from + ((Math.log(value) - low) / (high - low)) * (to - from);
}

/** A number with three digits at most. */
export function write(value: number): string {
    return value >= 1000 ? value.toLocaleString("en").replaceAll(",", " ") : String(Number(value.toPrecision(3)));
}

/** The values of the curves for readers without the picture. */
function Values({ curves, label }: Pick<LogPlotProps, "curves" | "label">): ReactNode {
    return (
        <ul className="visually-hidden" aria-label={label}>
            {curves.flatMap((curve) => curve.points.map((point) => <li key={`${curve.name} ${point.x}`}>{point.note}</li>))}
        </ul>
    );
}

/** The width of the page's column: one unit of the picture is one pixel, and text keeps its size on a phone. */
function useWidth(initial: number) {
    const frame = useRef<HTMLDivElement>(null);
    const [width, setWidth] = useState(initial);
    useEffect(() => {
        if (frame.current === null) return undefined;
        const observer = new ResizeObserver(([entry]) => entry.contentRect.width > 0 && setWidth(Math.round(entry.contentRect.width)));
        observer.observe(frame.current);
        return () => observer.disconnect();
    }, []);
    return { frame, width };
}

export default function LogPlot({ curves, label, x, y, width: initial = 760, height = 400, columns }: LogPlotProps): ReactNode {
    const { frame, width } = useWidth(initial);
    const points = curves.flatMap((curve) => curve.points);
    const marks = columns ?? decades(points.map((point) => point.x));
    const lines = decades(points.map((point) => point.y));
    const across = scale(marks, MARGIN.left, width - MARGIN.right);
    const up = scale(lines, height - MARGIN.bottom, MARGIN.top);
    return (
        <div ref={frame}>
            <svg className={styles.plot} viewBox={`0 0 ${width} ${height}`} role="img" aria-label={label}>
                {marks.map((tick) => (
                    <g key={tick}>
                        <line className={styles.grid} x1={across(tick)} x2={across(tick)} y1={MARGIN.top} y2={height - MARGIN.bottom} />
                        <text x={across(tick)} y={height - MARGIN.bottom + 18} textAnchor="middle">
                            {write(tick)}
                        </text>
                    </g>
                ))}
                {lines.map((tick) => (
                    <g key={tick}>
                        <line className={styles.grid} x1={MARGIN.left} x2={width - MARGIN.right} y1={up(tick)} y2={up(tick)} />
                        <text x={MARGIN.left - 8} y={up(tick) + 4} textAnchor="end">
                            {write(tick)}
                        </text>
                    </g>
                ))}
                <text x={(width + MARGIN.left) / 2} y={height - 6} textAnchor="middle">
                    {x}
                </text>
                <text transform={`translate(14 ${height / 2}) rotate(-90)`} textAnchor="middle">
                    {y}
                </text>
                {curves.map((curve) => (
                    <g key={curve.name} style={{ color: curve.colour }}>
                        <polyline
                            fill="none"
                            stroke="currentColor"
                            strokeWidth={2.5}
                            strokeDasharray={curve.dashes}
                            points={curve.points.map((point) => `${across(point.x)},${up(point.y)}`).join(" ")}
                        />
                        {curve.points.map((point) => (
                            <circle key={point.x} cx={across(point.x)} cy={up(point.y)} r={5} fill="currentColor">
                                <title>{point.note}</title>
                            </circle>
                        ))}
                    </g>
                ))}
            </svg>
            <Values curves={curves} label={label} />
        </div>
    );
}
