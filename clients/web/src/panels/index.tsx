// The panels on the right, in the order of their tabs.
import type {ComponentType} from "preact";
import {useErrorBoundary} from "preact/hooks";
import {panel} from "../shell/ui_state";
import {Icon, type Sign} from "../tools/icons";
import {ToolPanel} from "../tools/tool_panel";
import {CoatPanel} from "./coat";
import {FilesPanel} from "./files";
import {HistoryPanel} from "./history";
import {LayersPanel} from "./layers";
import {LightPanel} from "./light";
import {LookPanel} from "./look";
import {WindPanel} from "./wind";

interface Panel { id: string; label: string; sign: Sign; show: ComponentType }

const panels: Panel[] = [
  {id: "tool", label: "Tool", sign: "tool", show: ToolPanel},
  {id: "layers", label: "Layers", sign: "layers", show: LayersPanel},
  {id: "coat", label: "Coat", sign: "coat", show: CoatPanel},
  {id: "look", label: "Look", sign: "look", show: LookPanel},
  {id: "light", label: "Light", sign: "light", show: LightPanel},
  {id: "wind", label: "Wind", sign: "wind", show: WindPanel},
  {id: "history", label: "History", sign: "history", show: HistoryPanel},
  {id: "files", label: "Files", sign: "files", show: FilesPanel},
];

/** Arrow keys move between tabs. */
function arrows(event: KeyboardEvent) {
  const step = {ArrowLeft: -1, ArrowRight: 1, ArrowUp: -1, ArrowDown: 1}[event.key];
  if (!step) return;
  event.preventDefault();
  const at = panels.findIndex(({id}) => id === panel.value);
  panel.value = panels[(at + step + panels.length) % panels.length]!.id;
  document.getElementById(`tab-${panel.value}`)?.focus();
}

/** An error boundary: a panel that fails shows the error, while the others and the picture keep working. */
function Guarded({show: Show}: {show: ComponentType}) {
  const [error] = useErrorBoundary((thrown: unknown) => { console.error(thrown); });
  return error ? <p class="help" role="alert">This panel failed: {String(error)}. Reload the page. Your groom is safe on the server.</p> : <Show />;
}

export function Panels() {
  const open = panels.find(({id}) => id === panel.value) ?? panels[0]!;
  return (
    <aside class="panels" aria-label="Panels">
      <div class="tabs" role="tablist" aria-label="Panels" onKeyDown={arrows}>
        {panels.map(({id, label, sign}) => (
          <button key={id} id={`tab-${id}`} type="button" role="tab" aria-selected={id === open.id} aria-controls="panel" title={label} aria-label={label}
                  tabIndex={id === open.id ? 0 : -1} onClick={() => { panel.value = id; }}><Icon sign={sign} /><span>{label}</span></button>
        ))}
      </div>
      <div key={open.id} class="panel" id="panel" role="tabpanel" aria-labelledby={`tab-${open.id}`} tabIndex={0}><Guarded key={open.id} show={open.show} /></div>
    </aside>
  );
}
