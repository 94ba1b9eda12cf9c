// The page: tools on the left, the picture in the middle, panels on the right.
import {effect, signal, untracked} from "@preact/signals";
import {useEffect} from "preact/hooks";
import {listScenes, log_read, openScene, last_scene, refresh, scene, scenes, wants_log} from "./scene/session";
import {sayError, say} from "./scene/messages";
import {followNews} from "./scene/news";
import {sendLeftovers} from "./api/outbox";
import {makeSample, samples} from "./files/samples";
import {Panels} from "./panels";
import {followMask} from "./panels/mask";
import {DropTarget, listenToDrops} from "./shell/drop_target";
import {KeySheet} from "./shell/key_sheet";
import {listenToKeys} from "./shell/keys";
import {Messages} from "./shell/messages";
import {OfflineBanner, warnOfLoss} from "./shell/offline";
import {panel, theme} from "./shell/ui_state";
import {SheetDialog} from "./shell/sheet";
import {TokenDialog} from "./shell/token";
import {TopBar} from "./shell/top_bar";
import {NoScene, Welcome} from "./shell/welcome";
import {loadContract} from "./tools/schema";
import {Palette} from "./tools/palette";
import {current} from "./tools/state";
import {ReferenceCompare} from "./view/reference_compare";
import {Viewport} from "./view/viewport";

/** Reads the log only while it is needed: for the history panel, and for the tools that find their guides in it. */
function followLog(): () => void {
  return effect(() => {
    const wanted = panel.value === "history" || current.value === "flow" || current.value === "interpolate";
    untracked(() => {
      wants_log.value = wanted;
      if (wanted && !log_read.value) void refresh();
    });
  });
}

/** True once the list of scenes was read. */
const looked = signal(false);

/** Opens the scene in the URL, else the last open one, else the first; on a server without scenes, creates a fox. */
async function openFirst() {
  const left = sendLeftovers();
  if (left) say(`Sending ${left} changes from a page that was closed.`);
  await Promise.all([loadContract(), listScenes()]);
  const linked = new URLSearchParams(location.search).get("scene");
  const wanted = linked ?? last_scene.value;
  const found = scenes.value.find(({id, name}) => id === wanted || name === wanted) ?? scenes.value[0];
  if (linked && found?.id !== linked && found?.name !== linked) say("The scene of this link is not on the server.", "It was removed, or the link is for another server.", "error");
  if (found) await openScene(found.id);
  else await makeSample(samples[0]!);
  looked.value = true;
}

/** Puts the open scene into the page's URL, so that the URL can be shared. */
function followAddress() {
  const id = scene.value?.id;
  if (id) history.replaceState(null, "", `?scene=${encodeURIComponent(id)}`);
}

function useStart() {
  useEffect(() => {
    const stops = [listenToKeys(), listenToDrops(), warnOfLoss(), followNews(), followLog(), followMask(), effect(followAddress), effect(() => { document.documentElement.dataset["theme"] = theme.value; })];
    openFirst().catch(sayError);
    return () => stops.forEach((stop) => stop());
  }, []);
}

export function App() {
  useStart();
  return (
    <div class="app">
      <TopBar />
      <Palette />
      <main><Viewport /><NoScene looked={looked.value} /><Welcome /></main>
      <Panels />
      <Messages />
      <KeySheet />
      <ReferenceCompare />
      <SheetDialog />
      <TokenDialog />
      <OfflineBanner />
      <DropTarget />
    </div>
  );
}
