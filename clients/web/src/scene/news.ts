// Applies the server's events to the page's state of the scene, and shows messages about other users' changes.
import {effect} from "@preact/signals";
import {followEvents, type ServerEvent} from "../api/events";
import {author} from "../api/identity";
import {unsent} from "../api/outbox";
import type {ChangeEvent, Op, SceneEvent} from "../api/types";
import {toolNames} from "../tools/artist_words";
import {words} from "../tools/schema";
import {say} from "./messages";
import {onServerRevision, isOwn, listScenes, openScene, scene} from "./session";


function handleEvent(id: string, event: ServerEvent) {
  if (scene.value?.id !== id) return;
  if (event.name === "removed") {
    say("This scene was removed.", "Choose another one under Files.", "error");
    scene.value = null;
    return void listScenes();
  }
  if (event.name === "scene") {
    const opened = JSON.parse(event.data) as SceneEvent;
    if (scene.value.model_id !== opened.model_id) return void openScene(id);
    return onServerRevision(opened.revision);
  }
  if (event.name === "change") changed(JSON.parse(event.data) as ChangeEvent);
}

/** Handles a change event. Ignores our own edits: their answers report them, and may be on their way while any are unsent. */
function changed(change: ChangeEvent) {
  if (isOwn(change.revision) || (change.author === author.value && unsent.value > 0)) return;
  if (change.author !== author.value && change.kind !== "join") {
    say(`${change.author || "Somebody"}: ${change.ops.map((op) => toolNames[op as Op] ?? words(op.replace(/^set_/, ""))).join(", ") || change.kind}`);
  }
  onServerRevision(change.revision);
}

/** Follows the events of whichever scene is open. */
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
    void followEvents(open, (event) => handleEvent(open, event), stop.signal);
  });
}
