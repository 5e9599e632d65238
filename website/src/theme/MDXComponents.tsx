// The elements of documents: tables scroll, and scenes run in place of their pictures.

import MDXComponents from "@theme-original/MDXComponents";
import TabItem from "@theme/TabItem";
import Tabs from "@theme/Tabs";
import HeaderCell from "@site/src/components/HeaderCell";
import ScrollTable from "@site/src/components/ScrollTable";
import SceneCard from "@site/src/live/SceneCard";
import ScenePicture from "@site/src/live/ScenePicture";

export default { ...MDXComponents, table: ScrollTable, th: HeaderCell, img: ScenePicture, SceneCard, TabItem, Tabs };
