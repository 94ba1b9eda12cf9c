// Turns a model that lies on its side or faces the wrong direction, together with its fur.
import {call, scenePath} from "../api/client";
import type {TurnModel} from "../api/types";
import {sayError} from "./messages";
import {scene} from "./session";

type Turn = TurnModel & {says: string; title: string};

/** Quarter turns, given by the model's axes that point up and forward afterwards. */
export const turns: Turn[] = [
  {says: "Tip forward", title: "Turns the model so that its back points up", up: "-z", front: "y"},
  {says: "Roll over", title: "Turns the model so that its left side points up", up: "x", front: "z"},
  {says: "Turn round", title: "Turns the model so that its left side points forward", up: "y", front: "x"},
];

export async function turnModel({up, front}: Turn) {
  const open = scene.value;
  if (!open) return;
  try {
    await call(`${scenePath(open.id)}/turn`, {json: {up, front} satisfies TurnModel});
  } catch (error) {
    sayError(error);
  }
}
