// Pictures of the open scene's fur before and after the current tool with its settings.
import {useEffect} from "preact/hooks";
import {Aborted} from "../api/client";
import {scene} from "../scene/session";
import {resting} from "../view/frames";
import type {Tool} from "./catalogue";
import {commandOf} from "./state";
import {drawPair, pairs} from "./tool_trial";

const wait = 700;  // ms without a change of tool, settings or picture before the server is asked

export function ToolPicture({tool}: {tool: Tool}) {
  const {op, name} = tool;
  const id = scene.value?.id ?? "", command = commandOf(op);
  const key = `${id} ${JSON.stringify(command)}`;
  const pair = pairs.value.get(key);
  useEffect(() => {
    if (!id || !resting.value || pairs.value.has(key)) return;
    const stop = new AbortController();
    const timer = setTimeout(() => drawPair(key, id, op, command, stop.signal).catch((error: unknown) => {
      if (!(error instanceof Aborted)) console.info(`No picture of ${name}: ${String(error)}`);
    }), wait);
    return () => { clearTimeout(timer); stop.abort(); };
  }, [key, resting.value]);
  return (
    <figure class="tool-picture" aria-label={`Fur before and after ${name}`} data-drawn={pair ? "" : undefined}>
      {pair ? <><img src={pair.before} alt="Before" /><img src={pair.after} alt="After" /></> : <span role="status">Drawn on your animal in a moment…</span>}
    </figure>
  );
}
