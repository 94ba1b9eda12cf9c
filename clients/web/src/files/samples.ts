// Sample scenes: the built-in creature with a look, and one with a whole groom.
import {signal} from "@preact/signals";
import {change, createScene, expandRecipe} from "../api/client";
import {page_id} from "../api/identity";
import {sayError} from "../scene/messages";
import {listScenes, openScene} from "../scene/session";
import type {Scene} from "../api/types";
import type {Step} from "./steps";

/** A sample without look and recipe is the plain creature in its own colours. */
export interface Sample { name: string; look?: string; recipe?: string; length?: number }

/** The first visit shows the first sample. */
export const samples: Sample[] = [
  {name: "Fox"}, {name: "Shaggy fox", look: "fox"}, {name: "Best in show", recipe: "creature"}, {name: "Leopard", look: "leopard"}, {name: "Tabby", look: "shorthair_cat", length: 0.02},
  {name: "Zebra", look: "zebra", length: 0.018}, {name: "Bear", look: "bear"}, {name: "Rabbit", look: "rabbit"}, {name: "Sheep", look: "sheep"},
  {name: "Wet dog", look: "wet_dog"}, {name: "Plush", look: "toy_plush", length: 0.02},
];

/** Text about the sample being prepared; "" if there is none. */
export const preparing = signal("");

const sample_triangles = 20000;

async function stepsOf({look, recipe}: Sample, made: Scene): Promise<Step[]> {
  if (!look && !recipe) return [];
  const {looks, recipes} = await import("./sample_grooms");
  return look ? [looks[look]!] : expandRecipe(made.id, {recipe: recipes[`${recipe}.json`], files: recipes});
}

/** Creates a sample's scene on the server and opens it. */
export async function makeSample(sample: Sample) {
  if (preparing.value) return;
  try {
    preparing.value = "Growing the creature's fur";
    const made = await createScene({name: sample.name, model: {builtin: "creature", triangles: sample_triangles}, fur: {form: "animal", length: sample.length ?? 0.03}, ground: true});
    const steps = await stepsOf(sample, made);
    let done = 0;
    for (const step of steps) {
      if (steps.length > 1) preparing.value = `Grooming, step ${done + 1} of ${steps.length}`;
      await change(made.id, "commands", {commands: step.commands}, `${page_id}-${made.id}-${done++}`);
    }
    preparing.value = "Drawing the first picture";
    await Promise.all([openScene(made.id), listScenes()]);
  } catch (error) {
    sayError(error);
  } finally {
    preparing.value = "";
  }
}
