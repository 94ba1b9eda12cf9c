// Icons, 24 x 24, in the text's colour. Those of tools show strands on a strip of skin after the tool was used.
import type {ComponentChildren} from "preact";
import type {Op} from "../api/types";

const skin = <path d="M2 21h20" />;
const paths: Partial<Record<Op, ComponentChildren>> = {
  comb: <>{skin}<path d="M4 21c0-6 3-9 8-10M9 21c0-6 3-9 8-10M14 21c0-5 2-8 7-9" /><path d="M3 5h16M5 5v3M9 5v3M13 5v3M17 5v3" /></>,
  blow: <>{skin}<path d="M8 21c1-5 4-8 9-8M13 21c1-4 3-6 8-6M3 21c1-6 4-9 8-10" /><path d="M2 4h9a2 2 0 1 0-2-2M2 8h14a2 2 0 1 1-2 2" /></>,
  attract: <>{skin}<path d="M4 21C5 14 9 10 12 8M20 21c-1-7-5-11-8-13M12 21V8M8 21c1-6 3-10 4-13M16 21c-1-6-3-10-4-13" /><circle cx="12" cy="5" r="2.5" /></>,
  interpolate: <>{skin}<path d="M4 21V9M4 9l-2 3M4 9l2 3M20 21l-5-9M15 12l0 3.5M15 12l3 2" /><path d="M8 21l-.5-8M12 21l-1.5-8M16 21l-2.5-6" stroke-dasharray="2 2" /></>,
  flow: <>{skin}<path d="M2 15c5-8 8 3 12-3 2-3 4-4 8-4M19 5l3 3-3 3" /><path d="M4 21c0-2 1-3 3-3M11 21c0-2 1-3 3-3M18 21c0-2 1-3 3-3" /></>,
  smooth: <>{skin}<path d="M4 21c0-5 2-8 4-9M9 21c0-5 2-8 4-9M14 21c0-5 2-8 4-9M19 21c0-4 1-6 2-7" /><path d="M3 6c4-3 6 2 9 0s5-2 9-1" /></>,
  noise: <>{skin}<path d="M4 21c-1-5 2-6 0-10M8 21c2-4-1-7 2-12M12 21c-2-5 2-6 0-11M16 21c2-4-1-6 2-10M20 21c-2-3 1-5-1-8" /></>,
  unify: <>{skin}<path d="M4 21l3-10M9 21l3-10M14 21l3-10M19 21l2-8" /><path d="M5 6h14M5 3h14" /></>,
  part: <>{skin}<path d="M11 21c0-6-3-8-8-9M8 21c0-4-2-5-5-6M13 21c0-6 3-8 8-9M16 21c0-4 2-5 5-6" /><path d="M12 3v6" stroke-dasharray="2 2" /></>,
  whorl: <><path d="M12 12c0-2 3-2 3 .5 0 3-6 3.500-6-1C9 6 18 6 18 12.500 18 19 6 20 5 12 4 5 12 2 18 4" /></>,
  length: <>{skin}<path d="M5 21v-4M9 21v-7M13 21v-10M17 21V7" /><path d="M21 19V5M21 5l-2 2.500M21 5l2 2.500" /></>,
  trim: <>{skin}<path d="M4 21v-7M8 21v-7M12 21v-7M16 21v-7M20 21v-7" /><path d="M3 11h6M12 11l9-5M12 9l9 5" /><circle cx="10.500" cy="11.500" r="1.500" /><circle cx="10.500" cy="8.500" r="1.500" /></>,
  lift: <>{skin}<path d="M4 21c2-3 4-4 7-4M12 21V9M12 9l-3 3M12 9l3 3M16 21c1-2 3-3 5-3" /></>,
  erase: <>{skin}<path d="M6 15l8-9 6 5-7 8H9z" /><path d="M10 10.500l6 5" /></>,
  clump: <>{skin}<path d="M3 21c2-4 4-8 5-12 1 4 3 8 5 12M8 21V9M13 21c1-4 3-8 4-12 1 4 3 8 4 12M17 21V9" /></>,
  curl: <>{skin}<path d="M7 21c0-3 4-3 4-6s-5-3-5 0 6 2 6-3-6-4-6-1 5 2 7-2M16 21c0-3 4-3 4-6s-4-3-4 0 5 1 5-4" /></>,
  paint: <><path d="M20 3l-9 9M11 12c-3 0-4 2-4 4s-2 3-4 3c1 2 3 2 5 2 4 0 6-2 6-5z" /><path d="M14 15l7-10-1-2-2 0" /></>,
};

export function ToolIcon({op}: {op: Op}) {
  return (
    <svg class="icon" viewBox="0 0 24 24" width="24" height="24" aria-hidden="true">
      {paths[op] ?? <circle cx="12" cy="12" r="7" />}
    </svg>
  );
}

const signs = {
  undo: "M8 5L3 10l5 5M3 10h11a6 6 0 0 1 0 12H9", redo: "M16 5l5 5-5 5M21 10H10a6 6 0 0 0 0 12h5",
  history: "M3 12a9 9 0 1 0 3-6.700L3 8M3 3v5h5M12 7v5l4 2", layers: "M12 3l9 5-9 5-9-5zM3 12l9 5 9-5M3 16l9 5 9-5",
  coat: "M4 20c0-7 2-10 5-13M9 20c0-7 2-10 5-13M14 20c0-7 2-10 5-13M3 20h18", look: "M12 4a8 8 0 1 0 0 16zM12 4a8 8 0 0 1 0 16",
  wind: "M2 9h11a3 3 0 1 0-3-3M2 13h16a3 3 0 1 1-3 3M2 17h8a2.500 2.500 0 1 1-2.500 2.500",
  light: "M12 7a5 5 0 1 0 0 10 5 5 0 0 0 0-10zM12 1v3M12 20v3M1 12h3M20 12h3M4 4l2 2M18 18l2 2M4 20l2-2M18 6l2-2",
  files: "M3 6h7l2 3h9v11H3z", tool: "M4 20l9-9M13 11l2-6 5-2-2 5-5 3", mirror: "M12 2v20M9 6L3 18h6zM15 6l6 12h-6z",
  help: "M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18zM9 10a3 3 0 1 1 4 3c-1 .4-1 1-1 2M12 17.500v.5", theme: "M20 14A8 8 0 1 1 10 4a7 7 0 0 0 10 10z",
  eye: "M2 12s4-7 10-7 10 7 10 7-4 7-10 7S2 12 2 12zM12 9a3 3 0 1 0 0 6 3 3 0 0 0 0-6z", close: "M5 5l14 14M19 5L5 19",
  compare: "M12 2v20M4 5h5v14H4zM15 5h5v14h-5", mask: "M3 6c6-2 12-2 18 0 0 8-4 12-9 12S3 14 3 6zM8 10h.1M16 10h.1", plus: "M12 4v16M4 12h16",
  flag: "M5 22V3M5 4h13l-3 4 3 4H5", edit: "M4 20l1-5L16 4l4 4L9 19zM13 7l4 4", more: "M5 12h.1M12 12h.1M19 12h.1", fold: "M5 9l7 7 7-7", merge: "M12 3v12M7 10l5 5 5-5M4 20h16M4 3h3M17 3h3",
  trash: "M4 7h16M9 7V4h6v3M6 7l1 14h10l1-14M10 11v6M14 11v6", solo: "M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zM12 8.500a3.500 3.500 0 1 0 0 7 3.500 3.500 0 0 0 0-7z",
  grip: "M9 6h.1M15 6h.1M9 12h.1M15 12h.1M9 18h.1M15 18h.1", eye_off: "M4 4l16 16M10 5.500c8-1.500 12 6.500 12 6.500s-1 2-3 4M6 7.500C3.500 9.500 2 12 2 12s4 7 10 7c1.500 0 3-.4 4-1",
  download: "M12 3v12M7 10l5 5 5-5M4 20h16", people: "M8 11a3 3 0 1 0 0-6 3 3 0 0 0 0 6zM2 20c0-4 3-6 6-6s6 2 6 6M16 5a3 3 0 0 1 0 6M17 14c3 0 5 2 5 6",
} as const;
export type Sign = keyof typeof signs;

export function Icon({sign}: {sign: Sign}) {
  return <svg class="icon" viewBox="0 0 24 24" width="18" height="18" aria-hidden="true"><path d={signs[sign]} /></svg>;
}
