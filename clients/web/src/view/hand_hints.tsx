// Hints below the picture on what pointer and keys do now.
import {toolOf} from "../tools/catalogue";
import {current, inverting, smoothing} from "../tools/state";

function Hint({keys, does, held = false}: {keys: string; does: string; held?: boolean}) {
  return <span class={held ? "hint-held" : undefined}><b>{keys}</b> {does}</span>;
}

export function HandHints() {
  const op = current.value;
  const tool = toolOf(op);
  if (!tool) return null;
  return (
    <div class="hand-hints" aria-hidden="true">
      <Hint keys="Drag" does={tool.name.toLowerCase()} />
      <Hint keys="Ctrl" does="opposite" held={inverting.value} />
      <Hint keys="Shift" does="smooth" held={smoothing.value} />
      <Hint keys="Alt" does="turn" />
      <Hint keys="[ ]" does="size" />
    </div>
  );
}
