// The earlier revision that the picture is compared with; null while none is.
import {signal} from "@preact/signals";

export const compared = signal<{revision: number; label: string} | null>(null);
