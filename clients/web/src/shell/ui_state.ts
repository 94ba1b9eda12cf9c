// Which panel and dialog are open, and the colour theme.
import {signal} from "@preact/signals";
import {storedSignal} from "../api/identity";

export const panel = storedSignal("panel", "tool");
export const dialog = signal<"keys" | "welcome" | "compare" | "reference" | null>(null);
export const theme = storedSignal<"system" | "dark" | "light">("theme", "system");
