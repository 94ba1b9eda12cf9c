// The picture of a patch of the coat: a quick one after each change, then a finer one.
import {useSignal} from "@preact/signals";
import {useEffect} from "preact/hooks";
import {Aborted, Refusal} from "../api/client";
import type {Coat, Settings} from "../api/types";
import {dressPatch, drawPatch, forgetPatch} from "../scene/coat_preview";
import {coat, look} from "../scene/live_setting";

const size = {width: 288, height: 160};
const wait = 120;     // ms without a change before the patch is drawn
const rest = 700;     // ms until it is drawn finer

const sleep = (ms: number) => new Promise((wake) => setTimeout(wake, ms));

export function Patch() {
  const address = useSignal("");
  const drawing = useSignal(false);
  const shown = coat.value.value, shading = look.value.value;
  const present = (bytes: Blob | null) => {
    if (!bytes) return;
    URL.revokeObjectURL(address.peek());
    address.value = URL.createObjectURL(bytes);
  };
  const draw = async (dressed: Coat, shaded: Settings["look"], stopped: AbortSignal) => {
    await sleep(wait);
    if (stopped.aborted) return;
    drawing.value = true;
    try {
      const patch = await dressPatch(dressed, shaded);
      present(await drawPatch(patch, false, size, stopped));
      drawing.value = false;
      await sleep(rest);
      if (!stopped.aborted) present(await drawPatch(patch, true, size, stopped));
    } catch (error) {
      const newer_asked = error instanceof Aborted || (error instanceof Refusal && error.status === 409);
      if (!newer_asked) forgetPatch();  // the patch's scene may be gone; the next change creates it again
    }
  };
  useEffect(() => {
    if (!shown || !shading) return;
    const stop = new AbortController();
    void draw(shown, shading, stop.signal);
    return () => stop.abort();
  }, [JSON.stringify([shown, shading])]);
  useEffect(() => () => URL.revokeObjectURL(address.peek()), []);
  return (
    <div class="patch" aria-busy={drawing.value}>
      {address.value ? <img src={address.value} alt="A patch of this coat" {...size} /> : <p class="help">A patch of this coat is being drawn.</p>}
    </div>
  );
}
