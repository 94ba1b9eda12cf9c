// A temporary copy of the scene that previews settings while a slider is dragged; the scene itself gets one step at the end.
// The server shares baked coats between scenes, so a copy draws as fast as its scene.
import {signal} from "@preact/signals";
import * as api from "../api/client";
import {page_id} from "../api/identity";
import type {Command, Scene} from "../api/types";
import {isStale, trialName} from "./scratch";
import {revision, run, scene} from "./session";

/** The copy to draw in place of the scene; null while nothing is tried. */
export const trial = signal<{scene: string; revision: number; of: string} | null>(null);

const command_interval = 60;  // ms between two commands
const idle_timeout = 15000;   // ms that an unused copy is kept for the next preview
const removal_delay = 8000;   // ms until a dropped copy is removed, so that its last pictures can be drawn

let serial = 0;

class Copy {
  private readonly made: Promise<Scene>;
  private id = "";
  private waiting: Command | null = null;
  private busy = false;

  /** Copies the scene `of` at its revision `at`. */
  constructor(readonly of: string, public at: number) {
    this.made = api.branchScene(of, {name: trialName(), revision: at});
    this.made.then(({id}) => { this.id = id; }, () => undefined);  // the server is full: no preview
  }

  show(command: Command) {
    this.waiting = command;
    if (!this.busy) void this.work();
  }

  private async work() {
    this.busy = true;
    try {
      const {id} = await this.made;
      for (let command = this.waiting; command; command = this.waiting) {
        this.waiting = null;
        const answer = await api.change(id, "commands", command, `${page_id}-trial-${++serial}`);
        if (trying && current === this) trial.value = {scene: id, revision: answer.revision, of: this.of};
        await new Promise((wake) => setTimeout(wake, command_interval));
      }
    } catch {
      // the error appears when the command is sent to the scene
    }
    this.busy = false;
  }

  /** Applies a command that the scene just ran as revision `at`, so that the copy matches the scene. */
  follow(command: Command, at: number) {
    this.at = at;
    this.show(command);
  }

  async remove() {
    this.waiting = null;
    await this.made.then(({id}) => api.removeScene(id)).catch(() => undefined);
  }

  /** Sends the removal without waiting, because the page is being closed. */
  removeNow() {
    if (this.id) api.removeScene(this.id).catch(() => undefined);
  }
}

let current: Copy | null = null;
let trying = false;
let timer = 0;
const removing = new Set<Copy>();

function drop() {
  const left = current;
  current = null;
  if (!left) return;
  removing.add(left);
  setTimeout(() => void left.remove().then(() => removing.delete(left)), removal_delay);
}

/** Removes the copies that crashed pages left. */
async function removeStale() {
  for (const {id, name} of await api.listScenes()) if (isStale(name)) await api.removeScene(id);
}

function begin(of: string): Copy {
  removeStale().catch(() => undefined);
  return new Copy(of, revision.value);
}

/** Previews a command in the copy. */
export function tryOut(command: Command) {
  if (!scene.value) return;
  if (current && (current.of !== scene.value.id || current.at !== revision.value)) drop();
  current ??= begin(scene.value.id);
  trying = true;
  clearTimeout(timer);
  current.show(command);
}

/** Ends the preview: pictures show the scene again. The copy is kept for a while. */
export function endTrial() {
  if (!trying) return;
  trying = false;
  trial.value = null;
  clearTimeout(timer);
  timer = window.setTimeout(drop, idle_timeout);
}

/** Runs a command in the scene, as one step, and shows the scene again. */
export async function commit(command: Command) {
  const answer = await run(command);
  if (answer && current && current.at + 1 === answer.revision) current.follow(command, answer.revision);
  endTrial();
}

addEventListener("pagehide", () => {
  for (const copy of [...removing, ...(current ? [current] : [])]) copy.removeNow();
  removing.clear();
  current = null;
});
