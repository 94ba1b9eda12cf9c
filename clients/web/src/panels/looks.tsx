// Looks to start with, chosen by picture. They are loaded when the panel is first opened.
import {signal} from "@preact/signals";
import {useEffect} from "preact/hooks";
import type {Command} from "../api/types";
import {sayError} from "../scene/messages";
import {groomed_coat, run} from "../scene/session";
import type {Look} from "../scene/looks";

const looks = signal<Look[]>([]);

/** Returns a look's commands for the coat that the tools work on. */
const forChosen = (commands: Command[]) => commands.map((one) => (one.op === "set_coat" && groomed_coat.value ? {...one, name: groomed_coat.value} : one));

export function Looks() {
  useEffect(() => {
    if (looks.value.length === 0) import("../scene/looks").then((loaded) => { looks.value = loaded.looks; }, sayError);
  }, []);
  return (
    <div class="looks" role="group" aria-label="Looks to begin with">
      {looks.value.map(({name, picture, commands}) => (
        <button key={name} type="button" onClick={() => void run(...forChosen(commands))}>
          <img src={picture} alt="" width="84" height="84" loading="lazy" /><span>{name}</span>
        </button>
      ))}
    </div>
  );
}
