// A button that opens the file chooser. Files may also be dropped anywhere on the page (shell/drop_target.tsx).
import type {ComponentChildren} from "preact";
import {useSignal} from "@preact/signals";
import {useRef} from "preact/hooks";

export function FileButton({accept, take, children}: {accept: string; take: (file: File) => Promise<unknown>; children: ComponentChildren}) {
  const input = useRef<HTMLInputElement>(null);
  const busy = useSignal(false);
  const taken = (file: File | undefined) => {
    if (!file) return;
    busy.value = true;
    void take(file).finally(() => { busy.value = false; });
  };
  return (
    <>
      <button type="button" class="wide" disabled={busy.value} onClick={() => input.current!.click()}>{busy.value ? "Sending…" : children}</button>
      <input ref={input} type="file" hidden accept={accept} onChange={(event) => { taken(event.currentTarget.files?.[0]); event.currentTarget.value = ""; }} />
    </>
  );
}
