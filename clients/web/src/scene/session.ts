// The state of the open scene, as the server last reported it. Every change goes through run() and move().
import {batch, computed, signal} from "@preact/signals";
import * as api from "../api/client";
import {send} from "../api/outbox";
import {storedSignal} from "../api/identity";
import type {Command, CommandAnswer, EditLayer, LogEntry, Scene, Settings} from "../api/types";
import {sayError} from "./messages";
import {isScratch} from "./scratch";

export const scenes = signal<Scene[]>([]);
export const scene = signal<Scene | null>(null);
/** The log's entries; empty until `log_read`. */
export const log = signal<LogEntry[]>([]);
/** True while the log is needed. It grows with every stroke, so it is read only then. */
export const wants_log = signal(false);
/** True if `log` belongs to the current description of the scene. */
export const log_read = signal(false);
/** Everything in the scene except its fields: coat, look, lights, ... */
export const settings = signal<Settings | null>(null);
/** The newest known revision; frames are drawn of it. */
export const revision = signal(0);
/** Id of the model. When it changes, camera and proxy mesh are reset. Scenes of the same model, such as branches, share it. */
export const model_id = computed(() => scene.value?.model_id ?? "");
/** Identifies a scene with its model; pictures and revisions are valid only for one value. */
export const shown_model = computed(() => (scene.value ? `${scene.value.id} ${scene.value.model_id}` : ""));
export const last_scene = storedSignal("last-scene", "");
export const edit_layer = signal("");  // name of the layer that tools write to; "" for the base groom
export const groomed_coat = signal("");  // name of the coat that tools work on; "" for all

/** Revisions that this page made, to distinguish them from other users' changes. */
const own_revisions = new Set<number>();
const max_own_revisions = 1000;  // the events of older ones have arrived
export const isOwn = (of: number) => own_revisions.has(of);

export function layers(): EditLayer[] { return scene.value?.edit_layers ?? []; }

export const coats = (): Settings["coats"] => settings.value?.coats ?? [];

/** Returns true if this scene is still open; to be checked after each wait for the server. */
export const isOpen = (id: string) => scene.value?.id === id;

let reading: Promise<void> | null = null;
let read_again = false;

async function readOnce(id: string) {
  const entries_read = wants_log.value ? api.readLog(id) : null;
  const [description, entries, all] = await Promise.all([api.describeScene(id), entries_read, api.readSettings(id)]);
  if (!isOpen(id)) return;
  batch(() => {
    scene.value = description;
    log.value = entries ?? [];
    log_read.value = entries !== null;
    settings.value = all;
    revision.value = Math.max(revision.value, description.revision);
  });
}

/** Reads description, log and settings again. Calls during the read cause one more read after it. */
export function refresh(): Promise<void> {
  const id = scene.value?.id;
  if (!id) return Promise.resolve();
  if (reading) {
    read_again = true;
    return reading;
  }
  reading = readOnce(id).catch((error) => { if (isOpen(id)) sayError(error); }).then(() => {
    reading = null;
    if (!read_again) return;
    read_again = false;
    return refresh();
  });
  return reading;
}

let openings = 0;

/** Opens a scene. If several calls overlap, the last one wins. */
export async function openScene(id: string) {
  const opening = ++openings;
  const description = await api.describeScene(id);
  if (opening !== openings) return;
  batch(() => {
    scene.value = description;
    revision.value = description.revision;
    log.value = [];
    log_read.value = false;
    settings.value = null;
    edit_layer.value = "";
    groomed_coat.value = "";
    last_scene.value = id;
  });
  own_revisions.clear();
  await refresh();
}

export async function listScenes() {
  scenes.value = (await api.listScenes()).filter(({name}) => !isScratch(name));
}

/** Records a change that this page made. */
export function accept(answer: CommandAnswer) {
  own_revisions.add(answer.revision);
  if (own_revisions.size > max_own_revisions) own_revisions.delete(own_revisions.values().next().value!);
  revision.value = Math.max(revision.value, answer.revision);
}

/** Runs commands as one undo step. Returns null if the server refused them; the error was shown. */
export async function run(...commands: Command[]): Promise<CommandAnswer | null> {
  return change("commands", commands.length === 1 ? commands[0] : {commands});
}

/** Sends a change to a path of the scene. Refreshes the page's state unless `quiet`. */
export async function change(path: string, body: unknown, quiet = false): Promise<CommandAnswer | null> {
  const id = scene.value?.id;
  if (!id) return null;
  try {
    const answer = await send(id, path, body);
    if (!isOpen(id)) return answer;
    accept(answer);
    if (!quiet) await refresh();
    return answer;
  } catch (error) {
    sayError(error);
    return null;
  }
}

export const undo = (steps = 1) => change("undo", {steps});
export const redo = (steps = 1) => change("redo", {steps});
export const revertTo = (to: number) => change("revert", {revision: to});

const news_pause = 200;  // ms without events before a refresh; another user's stroke makes many revisions
let news_timer = 0;

/** Handles a revision that the server announced and that this page may not know. */
export function onServerRevision(news: number) {
  if (news < (scene.value?.revision ?? 0)) return;
  revision.value = Math.max(revision.value, news);
  clearTimeout(news_timer);
  news_timer = window.setTimeout(() => void refresh(), news_pause);
}
