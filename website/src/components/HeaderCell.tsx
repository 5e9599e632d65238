// A cell over a column. One without a text heads nothing, so it is an ordinary cell.

import { Children, type ComponentProps, type ReactNode } from "react";

export default function HeaderCell({ scope, ...props }: ComponentProps<"th">): ReactNode {
    return Children.count(props.children) === 0 ? <td {...props} /> : <th scope={scope} {...props} />;
}
