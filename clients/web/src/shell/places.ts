// Which panel and dialog are open, and the colour theme.
import {signal} from "@preact/signals";
import {kept} from "../api/identity";

export const panel = kept("panel", "tool");
export const dialog = signal<"keys" | "welcome" | "compare" | "reference" | null>(null);
export const theme = kept<"system" | "dark" | "light">("theme", "system");
