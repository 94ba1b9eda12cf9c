// Every tool of the contract, as icons.
import {current, in_hand} from "./state";
import {tools} from "./catalogue";
import {ToolIcon} from "./icons";
import {plain, words} from "./schema";
import {shortcutOf} from "../shell/keys";

export function Palette() {
  return (
    <nav class="palette" aria-label="Tools">
      {tools.value.map((tool) => (
        <button key={tool.op} type="button" class="tool" aria-pressed={current.value === tool.op} data-tool={tool.op}
                data-held={in_hand.value === tool.op && current.value !== tool.op ? "" : undefined}
                title={`${words(tool.op)}${shortcutOf(tool.op) ? ` (${shortcutOf(tool.op)})` : ""}. ${plain(tool.says)}`} aria-label={words(tool.op)}
                onClick={() => { current.value = tool.op; }}>
          <ToolIcon op={tool.op} />
        </button>
      ))}
    </nav>
  );
}
