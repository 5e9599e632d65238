// One of several values, as buttons.

import type { ReactNode } from "react";
import styles from "./charts.module.css";

interface ChoiceProps<T> {
    readonly label: string;
    readonly options: readonly (readonly [T, string])[];
    readonly value: T;
    readonly choose: (value: T) => void;
}

export default function Choice<T extends string | number>({ label, options, value, choose }: ChoiceProps<T>): ReactNode {
    return (
        <fieldset className={styles.choice}>
            <legend>{label}</legend>
            {options.map(([option, text]) => (
                <button key={option} type="button" aria-pressed={option === value} onClick={() => choose(option)}>
                    {text}
                </button>
            ))}
        </fieldset>
    );
}
