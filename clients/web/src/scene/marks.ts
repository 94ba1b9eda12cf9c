// Dispatches events on the window for measurements of timing; nothing stores them.
export type Mark = "frame" | "part" | "ring" | "palette" | "proxy";

export function mark(name: Mark, detail: Record<string, unknown> = {}) {
  dispatchEvent(new CustomEvent(`pelage:${name}`, {detail}));
}
