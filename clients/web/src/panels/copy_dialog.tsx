// Copies text to the clipboard; if the browser does not allow it, shows the text to be copied by hand.
import {signal} from "@preact/signals";
import {useEffect, useRef} from "preact/hooks";
import {say} from "../scene/messages";
import {Dialog} from "../shell/dialog";

const by_hand = signal<string | null>(null);

export async function copyToClipboard(text: string, what: string) {
  try {
    await navigator.clipboard.writeText(text);
    say(`Copied ${what}.`);
  } catch {
    by_hand.value = text;  // not allowed, or not a secure context
  }
}

export function CopyDialog() {
  const field = useRef<HTMLTextAreaElement>(null);
  useEffect(() => { field.current?.select(); }, [by_hand.value]);
  if (by_hand.value === null) return null;
  return (
    <Dialog title="Copy this text" close={() => { by_hand.value = null; }}>
      <textarea class="copy-text" ref={field} readOnly rows={14} cols={80} aria-label="Text to copy" value={by_hand.value} />
    </Dialog>
  );
}
