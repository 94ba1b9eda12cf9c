import {Dialog} from "./dialog";
import {shortcuts} from "./keys";
import {dialog} from "./ui_state";

const held = [["drag on fur", "use the tool"], ["drag beside it, or Alt+drag", "turn the view"], ["middle or right drag", "turn the view"], ["Shift+middle drag, Alt+Shift+drag", "move the picture"],
  ["wheel, pinch", "zoom"], ["two fingers", "turn (trackpad), or move and zoom (touch screen)"], ["Ctrl+drag", "the tool's opposite"], ["Shift+drag", "smooth"],
  ["hold F, move", "size of the brush"], ["hold Shift+F, move", "its strength"], ["hold Space, move", "choose a tool around the pointer"]] as const;

export function KeySheet() {
  if (dialog.value !== "keys") return null;
  return (
    <Dialog title="Shortcuts" close={() => { dialog.value = null; }}>
      <div class="key-sheet">
        <section><h3>Hand</h3><dl>{held.map(([keys, says]) => <div key={keys}><dt>{keys}</dt><dd>{says}</dd></div>)}</dl></section>
        {(["Brush", "View", "Groom", "Tools"] as const).map((group) => (
          <section key={group}>
            <h3>{group}</h3>
            <dl>{shortcuts.filter((one) => one.group === group).map(({keys, says}) => (
              <div key={keys}><dt><kbd>{keys}</kbd></dt><dd>{says}</dd></div>))}</dl>
          </section>
        ))}
      </div>
    </Dialog>
  );
}
