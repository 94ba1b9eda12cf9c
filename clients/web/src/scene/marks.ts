// What happened when, for whoever measures: events of the window that nothing keeps.
export type Mark = "frame" | "part" | "ring" | "palette" | "proxy";

export function mark(name: Mark, detail: Record<string, unknown> = {}) {
  dispatchEvent(new CustomEvent(`pelage:${name}`, {detail}));
}
