// Combines pictures: a contact sheet, before and after, two scenes side by side; and a turntable as a film.
import {signal} from "@preact/signals";
import {drawFrame} from "../api/client";
import {page_id} from "../api/identity";
import type {FrameRequest, Scene} from "../api/types";
import {first_revision} from "../scene/steps";
import {log_read, refresh, wants_log} from "../scene/session";
import {framed, orbit, pinholeOf, type Orbit} from "../view/camera";
import {plain_request, rest_quality} from "../view/quality";
import {fileName, make, making, save} from "./download";

/** A finished sheet or film; the dialog shows the latest one. */
export interface Sheet { address: string; bytes: Blob; name: string; is_film: boolean }
export const sheet = signal<Sheet | null>(null);

interface Cell { scene: Scene; orbit: Orbit; label: string; revision?: number }

const cell = {width: 640, height: 520};
const label_height = 34, film_frames = 72, film_rate = 24;
const film_size = {width: 800, height: 640};

export function closeSheet() {
  if (sheet.value) URL.revokeObjectURL(sheet.value.address);
  sheet.value = null;
}

function show(bytes: Blob, name: string, is_film = false) {
  closeSheet();
  sheet.value = {bytes, name, is_film, address: URL.createObjectURL(bytes)};
}

const fileNameOf = (of: string, what: string, ending: string) => fileName({name: `${of} ${what}`}, ending);

async function pictureOf({scene, orbit: from, revision}: Cell, size: {width: number; height: number}, signal: AbortSignal): Promise<ImageBitmap> {
  const request: FrameRequest = {...plain_request.value, ...rest_quality.value, ...size, camera: pinholeOf(from), view: `${page_id}-sheet`, ...(revision === undefined ? {} : {revision})};
  const picture = await drawFrame(scene.id, request, null, signal);
  return createImageBitmap(picture!.bytes);
}

/** Draws the cells in rows, each with its label below. */
async function composeSheet(cells: Cell[], columns: number, says: string, stop: AbortController): Promise<Blob> {
  const canvas = document.createElement("canvas");
  canvas.width = columns * cell.width, canvas.height = Math.ceil(cells.length / columns) * (cell.height + label_height);
  const pen = canvas.getContext("2d")!;
  pen.fillStyle = "#17181a";
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.font = "18px system-ui, sans-serif", pen.textBaseline = "middle", pen.fillStyle = "#e9e7e3";
  for (const [k, one] of cells.entries()) {
    making.value = {says, share: k / cells.length, stop};
    const [x, y] = [(k % columns) * cell.width, Math.floor(k / columns) * (cell.height + label_height)];
    pen.drawImage(await pictureOf(one, cell, stop.signal), x, y);
    pen.fillText(one.label, x + 14, y + cell.height + label_height / 2);
  }
  return new Promise((done) => canvas.toBlob((bytes) => done(bytes!), "image/png"));
}

const orbitAt = (scene: Scene, yaw: number): Orbit => ({...framed(scene, "three_quarter", cell.width / cell.height), yaw});

export const contactSheet = () => make("Drawing the contact sheet", async (scene, stop) => {
  const aspect = cell.width / cell.height;
  const cells: Cell[] = [
    {scene, orbit: framed(scene, "three_quarter", aspect), label: scene.name}, {scene, orbit: framed(scene, "front", aspect), label: "Front"},
    {scene, orbit: framed(scene, "left", aspect), label: "Left"}, {scene, orbit: orbitAt(scene, 0.6 + Math.PI), label: "From behind"},
    {scene, orbit: framed(scene, "back", aspect), label: "Back"}, {scene, orbit: framed(scene, "top", aspect), label: "From above"},
  ];
  show(await composeSheet(cells, 3, "Drawing the contact sheet", stop), fileNameOf(scene.name, "contact sheet", "png"));
});

export const beforeAndAfter = () => make("Drawing before and after", async (scene, stop) => {
  if (!log_read.value) {
    wants_log.value = true;
    await refresh();
  }
  const cells: Cell[] = [{scene, orbit: orbit.value, label: "The first groom", revision: first_revision.value}, {scene, orbit: orbit.value, label: "Now"}];
  show(await composeSheet(cells, 2, "Drawing before and after", stop), fileNameOf(scene.name, "before and after", "png"));
});

export const sideBySide = (other: Scene) => make(`Drawing ${other.name} beside the open scene`, async (scene, stop) => {
  const aspect = cell.width / cell.height;
  const cells: Cell[] = [scene, other].map((one) => ({scene: one, orbit: framed(one, "three_quarter", aspect), label: one.name}));
  show(await composeSheet(cells, 2, `Drawing ${other.name} beside the open scene`, stop), fileNameOf(scene.name, `and ${other.name}`, "png"));
});

/** Draws all pictures before it records them, so that the film has no pauses. */
export const turntable = () => make("Drawing the turntable", async (scene, stop) => {
  const pictures: ImageBitmap[] = [];
  for (let k = 0; k < film_frames; ++k) {
    making.value = {says: "Drawing the turntable", share: k / film_frames, stop};
    pictures.push(await pictureOf({scene, orbit: {...orbit.value, yaw: orbit.value.yaw + (2 * Math.PI * k) / film_frames}, label: ""}, film_size, stop.signal));
  }
  making.value = {says: "Encoding the film", share: null, stop};
  show(await filmOf(pictures), fileNameOf(scene.name, "turntable", "webm"), true);
});

async function filmOf(pictures: ImageBitmap[]): Promise<Blob> {
  const canvas = document.createElement("canvas");
  canvas.width = film_size.width, canvas.height = film_size.height;
  const pen = canvas.getContext("2d")!, parts: Blob[] = [];
  const recorder = new MediaRecorder(canvas.captureStream(film_rate), {mimeType: "video/webm", videoBitsPerSecond: 8e6});
  recorder.ondataavailable = ({data}) => parts.push(data);
  const ended = new Promise((done) => { recorder.onstop = done; });
  recorder.start();
  for (const picture of pictures) {
    pen.drawImage(picture, 0, 0);
    await new Promise((wake) => setTimeout(wake, 1000 / film_rate));
  }
  recorder.stop();
  await ended;
  return new Blob(parts, {type: "video/webm"});
}

export const keepSheet = () => { if (sheet.value) save(sheet.value.bytes, sheet.value.name); };
