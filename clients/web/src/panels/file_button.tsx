// A button that asks for a file, and takes one that is dropped on it.
import type {ComponentChildren} from "preact";
import {useSignal} from "@preact/signals";
import {useRef} from "preact/hooks";

interface Props { accept: string; take: (file: File) => Promise<unknown>; children: ComponentChildren }

export function FileButton({accept, take, children}: Props) {
  const input = useRef<HTMLInputElement>(null);
  const busy = useSignal(false);
  const over = useSignal(false);
  const taken = (file: File | undefined) => {
    if (!file) return;
    busy.value = true;
    void take(file).finally(() => { busy.value = false; });
  };
  const drop = (event: DragEvent) => {
    event.preventDefault();
    over.value = false;
    taken(event.dataTransfer?.files[0]);
  };
  return (
    <>
      <button type="button" class="drop wide" disabled={busy.value} data-over={over.value ? "" : undefined} onClick={() => input.current!.click()}
              onDragOver={(event) => { event.preventDefault(); over.value = true; }} onDragLeave={() => { over.value = false; }} onDrop={drop}>
        {busy.value ? "Sending…" : children}
      </button>
      <input ref={input} type="file" hidden accept={accept} onChange={(event) => { taken(event.currentTarget.files?.[0]); event.currentTarget.value = ""; }} />
    </>
  );
}
