// A table that scrolls sideways in narrow windows, by touch, wheel or keys.

import type { ComponentProps, ReactNode } from "react";

export default function ScrollTable(props: ComponentProps<"table">): ReactNode {
    return (
        <div className="scroll-table" tabIndex={0}>
            <table {...props} />
        </div>
    );
}
