// News from the server become what the page knows of the scene, and words about what others did.
import {effect} from "@preact/signals";
import {hearEvents, type ServerEvent} from "../api/events";
import {author} from "../api/identity";
import {say} from "./messages";
import {hear, isOwn, listScenes, openScene, refresh, revision, scene} from "./session";

interface Change { revision: number; kind: string; author: string; ops?: string[] }
interface Opened { revision: number; model_id: string }

function heard(id: string, event: ServerEvent) {
  if (scene.value?.id !== id) return;
  if (event.name === "removed") {
    say("This scene was removed.", "Choose another one under Files.", "error");
    scene.value = null;
    return void listScenes();
  }
  if (event.name === "scene") {
    const opened = JSON.parse(event.data) as Opened;
    if (scene.value.model_id !== opened.model_id) return void openScene(id);
    return hear(opened.revision);
  }
  if (event.name !== "change") return;
  const change = JSON.parse(event.data) as Change;
  if (change.author !== author.value && change.revision > revision.value && !isOwn(change.revision)) {
    say(`${change.author || "Somebody"}: ${(change.ops ?? []).join(", ") || change.kind}`);
  }
  if (change.revision > revision.value) hear(change.revision);
  else if (!isOwn(change.revision)) void refresh();
}

/** Hears of the open scene, and of the next one once it is opened. */
export function followNews(): () => void {
  let stop: AbortController | null = null;
  let id = "";
  return effect(() => {
    const open = scene.value?.id ?? "";
    if (open === id) return;
    id = open;
    stop?.abort();
    if (!open) return;
    stop = new AbortController();
    void hearEvents(open, (event) => heard(open, event), stop.signal);
  });
}
