// Accepts files that are dropped anywhere on the page.
import {signal} from "@preact/signals";
import {take} from "../files/import";
import {takeDropped} from "../files/take";
import {sayError} from "../scene/messages";

const over = signal(false);

const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;

/** Listens to drops on the whole page. Without a handler, the browser would replace the page by the dropped file. */
export function listenToDrops(): () => void {
  const stops = new AbortController();
  const {signal: until} = stops;
  addEventListener("dragover", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    event.dataTransfer!.dropEffect = "copy";
    over.value = true;
  }, {signal: until});
  addEventListener("dragleave", (event) => { if (!event.relatedTarget) over.value = false; }, {signal: until});
  addEventListener("drop", (event) => {
    over.value = false;
    if (!hasFiles(event)) return;
    event.preventDefault();
    takeDropped(event.dataTransfer!).then(take).catch(sayError);
  }, {signal: until});
  return () => stops.abort();
}

export function DropTarget() {
  if (!over.value) return null;
  return <div class="drop-target" aria-hidden="true"><p>Drop a model, its folder, a recipe, a skin texture, or light from all around (HDR, EXR)</p></div>;
}
