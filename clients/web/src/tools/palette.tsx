// The palette of all tools, with icons and names, grouped by kind.
import {useEffect} from "preact/hooks";
import type {Op} from "../api/types";
import {mark} from "../scene/marks";
import {current, in_hand} from "./state";
import {tools, type Tool} from "./catalogue";
import {ToolIcon} from "./icons";
import {shortcutOf} from "../shell/keys";

/** Groups of tools; tools that are in no group, such as new ones of the contract, come last, with paint. */
const groups: {label: string; of: Op[]}[] = [
  {label: "Direction", of: ["comb", "blow", "attract", "interpolate", "flow"]},
  {label: "Order", of: ["smooth", "noise", "unify", "part", "whorl"]},
  {label: "Length", of: ["length", "trim", "lift", "erase"]},
  {label: "Shape", of: ["clump", "curl"]},
  {label: "Paint", of: []},
];
const groupOf = (op: Op) => groups.find(({of}) => of.includes(op)) ?? groups[groups.length - 1]!;

function ToolButton({tool: {op, name, says}}: {tool: Tool}) {
  const key = shortcutOf(op);
  return (
    <button type="button" class="tool" aria-pressed={current.value === op} data-tool={op}
            data-held={in_hand.value === op && current.value !== op ? "" : undefined}
            title={`${name}${key ? ` (${key})` : ""}. ${says}`} aria-label={name} onClick={() => { current.value = op; }}>
      <ToolIcon op={op} /><span>{name}</span>
    </button>
  );
}

export function Palette() {
  const all = tools.value;
  useEffect(() => { if (all.length) mark("palette", {at: performance.now()}); }, [all]);
  return (
    <nav class="palette" aria-label="Tools">
      {groups.map((group) => (
        <div key={group.label} class="tool-group" role="group" aria-label={group.label}>
          {all.filter(({op}) => groupOf(op) === group).map((tool) => <ToolButton key={tool.op} tool={tool} />)}
        </div>
      ))}
    </nav>
  );
}
