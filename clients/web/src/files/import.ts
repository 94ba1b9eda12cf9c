// Uploads a model into a scene, from the question about its axes to the report. Also takes dropped recipes and pictures.
import {signal} from "@preact/signals";
import {Aborted, Offline, Refusal, createScene, removeScene, scenePath} from "../api/client";
import {storedSignal} from "../api/identity";
import type {CommandAnswer, Repair, Scene} from "../api/types";
import {upload} from "../api/upload";
import {say, sayError} from "../scene/messages";
import {isPicture, takePicture} from "../scene/upload";
import {onServerRevision, isOpen, listScenes, openScene, run, scene} from "../scene/session";
import {panel} from "../shell/ui_state";
import {PlanError, planOf, type Plan} from "./plan";
import {brokenAssert} from "./asserts";
import {stepsOf} from "./steps";
import {endingOf, folderOf, type InputFile} from "./take";

/** A repeated upload with other axes may discard the scene's groom, but only if the scene is still at `revision`. */
export type Loss = {revision: number};

export type Import =
  | {stage: "reading"}
  | {stage: "asking"; plan: Plan; into: string; loss?: Loss}     // into: id of the target scene; "" for a new one
  | {stage: "sending" | "preparing"; plan: Plan; what: string; share: number; stop: AbortController}
  | {stage: "done"; plan: Plan; into: string; revision: number; triangles: number; repairs: Repair[]; notes: string[]}
  | {stage: "failed"; says: string; next: string; plan: Plan | null; into: string};

export const importing = signal<Import | null>(null);
export const leave = () => { importing.value = null; };

const max_name_bytes = 200;

/** Returns advice for the user on a refusal. */
function adviceOn(error: unknown): string {
  if (error instanceof Offline) return "Nothing was changed. Try again once the server answers.";
  if (!(error instanceof Refusal)) return "Try again, or export the model in another format.";
  const {limit} = error.problem;
  if (error.status === 413) return `Reduce the mesh${limit ? ` (${limit})` : ""} and try again.`;
  if (error.status === 429 || error.status === 503) return "The server is busy: try again in a moment.";
  return `${limit ? `Allowed: ${limit}. ` : ""}Repair the file, or export it again, preferably as GLB or OBJ.`;
}

function nameOf(plan: Plan): string {
  let name = plan.name.replace(/[\u0000-\u001f\u007f]/g, "") || "model";
  while (new TextEncoder().encode(name).length > max_name_bytes) name = name.slice(0, -1);
  return name;
}

const discardQuery = (loss: Loss | undefined): Record<string, string> => (loss ? {discard: "1"} : {});
const atRevision = (loss: Loss | undefined): Record<string, string> => (loss ? {"If-Match": `"${loss.revision}"`} : {});

async function send(plan: Plan, id: string, loss: Loss | undefined, stop: AbortController): Promise<{description: Scene; notes: string[]}> {
  const start = performance.now();
  const show = (what: string) => (share: number) => {
    const seconds = (performance.now() - start) / 1000, sent = share * plan.bytes.size;
    if (what === "the model" && seconds > 0.5) upload_speed.value = sent / seconds;
    importing.value = {stage: share < 1 ? "sending" : "preparing", plan, what, share, stop};
  };
  const query = new URLSearchParams(Object.entries({format: plan.format, ground: true, ...plan.options, ...discardQuery(loss)}).map(([name, value]) => [name, String(value)]));
  show("the model")(0);
  let description = await upload<Scene>(`${scenePath(id)}/model?${query}`, plan.bytes, show("the model"), stop.signal, atRevision(loss));
  const notes = [...plan.notes];
  if (plan.texture) {
    try {
      const answer = await upload<CommandAnswer>(`${scenePath(id)}/skin_texture`, plan.texture, show("the picture"), stop.signal);
      description = {...description, revision: answer.revision};
    } catch (error) {
      if (error instanceof Aborted) throw error;
      notes.push(`The texture was not applied: ${(error as Error).message}`);
    }
  }
  return {description, notes};
}

/** Returns the state of the card after an upload that failed or was aborted. */
function stateAfter(error: unknown, plan: Plan, into: string): Import {
  if (error instanceof Aborted) return {stage: "asking", plan, into};
  const says = error instanceof Offline ? "The connection to the server was lost." : (error as Error).message;
  return {stage: "failed", says, next: adviceOn(error), plan, into};
}

/** Returns the card's notes on a loaded model. */
function notesOn({materials, carried}: Scene): string[] {
  const bare = materials.filter((material) => material.bare).map(({name}) => name);
  const notes = bare.length > 0 ? [`Left bare: ${bare.join(", ")}. To grow fur there, paint Bare skin with value 0.`] : [];
  if (!carried) return notes;
  const far = carried.far > 0 ? ` Check the new parts: ${carried.far.toLocaleString()} of ${carried.vertices.toLocaleString()} vertices are far from the previous model.` : "";
  return [...notes, `The groom was transferred.${far}`, "The previous scene, with its steps, is in the list."];
}

/** Speed of the latest upload in bytes per second; 0 before the first. */
export const upload_speed = storedSignal("upload-speed", 0);

/** Uploads the plan. A scene that was created for it is removed if the upload fails. */
export async function startImport(plan: Plan, into: string, loss?: Loss): Promise<void> {
  const stop = new AbortController();
  let made = "";
  importing.value = {stage: "sending", plan, what: "the model", share: 0, stop};
  try {
    const id = into || plan.version_of || (made = (await createScene({name: nameOf(plan), model: {builtin: "plane", triangles: 2}})).id);
    const {description, notes} = await send(plan, id, loss, stop);
    await Promise.all([openScene(id), listScenes()]);
    onServerRevision(description.revision);
    importing.value = {stage: "done", plan, into: id, revision: description.revision, triangles: description.triangles, repairs: description.repairs, notes: [...notes, ...notesOn(description)]};
  } catch (error) {
    if (made) await removeScene(made).then(listScenes).catch(() => undefined);
    if (error instanceof Refusal && error.status === 412) return startImport(plan, into);  // groomed meanwhile: keep the groom
    importing.value = stateAfter(error, plan, into);
  }
}

/** Returns the recipes that `main` can include, by path: the files dropped with it, and the built-in recipes. */
async function recipesBeside(main: InputFile, all: InputFile[]): Promise<Record<string, unknown>> {
  const own = Object.entries((await import("./sample_grooms")).recipes).map(([name, recipe]) => [`${folderOf(main.path)}${name}`, recipe]);
  const others = all.filter((one) => one !== main && endingOf(one.path) === "json");
  const dropped = await Promise.all(others.map(async ({path, file}) => [path, JSON.parse(await file.text()) as unknown]));
  return Object.fromEntries([...own, ...dropped]);
}

/** Runs the steps of a recipe or a log on the open scene, each as one undo step. */
async function runFile(main: InputFile, all: InputFile[]) {
  const open = scene.value;
  if (!open) return say("Open a scene first.", "A recipe runs on the open scene.", "error");
  const steps = await stepsOf(open.id, main.path, await main.file.text(), await recipesBeside(main, all));
  let done = 0, broken = "";
  for (const step of steps) {
    if (!isOpen(open.id)) break;  // the user opened another scene
    const answer = await run(...step.commands);
    if (!answer) break;
    ++done;
    broken = brokenAssert(step, answer);
    if (broken) break;
  }
  say(done === steps.length && !broken ? `${main.file.name}: ${done} steps are done.` : `${main.file.name} stopped after ${done} of ${steps.length} steps.`,
      [broken, "Each is one undo step."].filter(Boolean).join(" "), done === steps.length && !broken ? "info" : "error");
}

/** Handles files that were dropped or chosen: runs a recipe, uses a picture, or starts the upload of a model. */
export async function take(all: InputFile[]) {
  if (all.length === 0) return;
  const recipe = all.find(({path}) => ["json", "jsonl"].includes(endingOf(path)));
  const has_model = all.some(({path}) => ["glb", "gltf", "obj", "ply", "off", "stl", "3ds"].includes(endingOf(path)));
  if (recipe && !has_model) return runFile(recipe, all).catch((error: Error) => say(`${recipe.file.name}: ${error.message}`, "Drop the files that it includes together with it, in their folder. docs/recipes.md describes recipes.", "error"));
  const beside = has_model ? undefined : all.find(({path}) => isPicture(path));
  if (beside) return takePicture(beside.file);
  panel.value = "files";
  importing.value = {stage: "reading"};
  try {
    importing.value = {stage: "asking", plan: await planOf(all), into: ""};
  } catch (error) {
    if (!(error instanceof PlanError)) { leave(); return sayError(error); }
    importing.value = {stage: "failed", says: error.message, next: error.next, plan: null, into: ""};
  }
}
