// The top bar: scene, undo and redo, mirror, brush, quality dial, download of the picture, help and colour theme.
import {author} from "../api/identity";
import {unsent} from "../api/outbox";
import {downloadPicture, making} from "../files/download";
import {redo, scene, undo} from "../scene/session";
import {BrushBar} from "../tools/brush_bar";
import {Icon} from "../tools/icons";
import {mirror} from "../tools/state";
import {DialControl} from "./dial";
import {toggleMirror} from "./keys";
import {dialog, panel, theme} from "./ui_state";

const next_theme = {system: "dark", dark: "light", light: "system"} as const;

export function TopBar() {
  const open = scene.value;
  return (
    <header class="top-bar">
      <h1>Pelage</h1>
      <button type="button" class="scene-name" title="Scenes and files" onClick={() => { panel.value = "files"; }}>{open?.name ?? "no scene"}</button>
      <div class="group" role="group" aria-label="History">
        <button type="button" aria-label="Undo" title="Undo (Ctrl+Z)" disabled={!open?.undo_steps} onClick={() => void undo()}><Icon sign="undo" /></button>
        <button type="button" aria-label="Redo" title="Redo (Ctrl+Shift+Z)" disabled={!open?.redo_steps} onClick={() => void redo()}><Icon sign="redo" /></button>
      </div>
      <button type="button" aria-pressed={mirror.value} aria-label="Mirror" title="Mirror across the middle (X)" disabled={!open} onClick={toggleMirror}><Icon sign="mirror" /><span class="word">Mirror</span></button>
      <span class="grow" />
      <BrushBar />
      <span class="grow" />
      <DialControl />
      <button type="button" aria-label="Download PNG" title="Download the picture as on the screen; the Files panel has other sizes and formats" disabled={!open || making.value !== null}
              onClick={() => void downloadPicture("png", "1x")}><Icon sign="download" /><span class="word">{making.value ? "Wait" : "PNG"}</span></button>
      {unsent.value > 3 && <span class="unsent" role="status">Sending {unsent.value} changes</span>}
      <label class="author" title="Others see this name beside your edits"><Icon sign="people" />
        <input type="text" aria-label="Your name" value={author.value} maxLength={40} size={Math.max(6, author.value.length)}
               onChange={(event) => { author.value = event.currentTarget.value.trim() || author.value; }} />
      </label>
      <button type="button" aria-label={`Colours of the page: ${theme.value}`} title={`Colours of the page: ${theme.value}`} onClick={() => { theme.value = next_theme[theme.value]; }}><Icon sign="theme" /></button>
      <button type="button" aria-label="Shortcuts" title="Shortcuts (?)" onClick={() => { dialog.value = "keys"; }}><Icon sign="help" /></button>
    </header>
  );
}
