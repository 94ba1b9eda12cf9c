// The message while the server does not answer, and the warning before closing a page that would lose changes.
import {storage_works, offline, unsent} from "../api/outbox";

const counted = (count: number) => (count === 1 ? "1 change is" : `${count} changes are`);

function wordsOf(count: number): string {
  if (count === 0) return "Nothing is lost.";
  if (storage_works.value) return `${counted(count)} kept in this browser and will be sent when the server answers again.`;
  return `${counted(count)} waiting in this page. Leave it open: this browser cannot store any more.`;
}

export function OfflineBanner() {
  return (
    <div class="offline-place" role="status">
      {offline.value && <p class="offline">The server does not answer; trying again. {wordsOf(unsent.value)}</p>}
    </div>
  );
}

/** Asks before the page is closed, if that would lose changes. */
export function warnOfLoss(): () => void {
  const ask = (event: BeforeUnloadEvent) => { if (unsent.value > 0 && !storage_works.value) event.preventDefault(); };
  addEventListener("beforeunload", ask);
  return () => removeEventListener("beforeunload", ask);
}
