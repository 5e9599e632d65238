// The elements of documents: tables scroll, and pictures of scenes run them.

import MDXComponents from "@theme-original/MDXComponents";
import TabItem from "@theme/TabItem";
import Tabs from "@theme/Tabs";
import ScrollTable from "@site/src/components/ScrollTable";
import ScenePicture from "@site/src/live/ScenePicture";

export default { ...MDXComponents, table: ScrollTable, img: ScenePicture, TabItem, Tabs };
