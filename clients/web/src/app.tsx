// The page: tools on the left, the picture, panels on the right.
import {effect} from "@preact/signals";
import {useEffect} from "preact/hooks";
import {listScenes, openScene, last_scene, scenes} from "./scene/session";
import {sayError, say} from "./scene/messages";
import {followNews} from "./scene/news";
import {sendLeftovers} from "./api/outbox";
import {Panels} from "./panels";
import {KeySheet} from "./shell/key_sheet";
import {listenToKeys} from "./shell/keys";
import {Messages} from "./shell/messages";
import {theme} from "./shell/places";
import {TopBar} from "./shell/top_bar";
import {loadContract} from "./tools/schema";
import {Palette} from "./tools/palette";
import {Viewport} from "./view/viewport";

/** The scene of the address, the one that was open last, or the first. */
async function openFirst() {
  const left = sendLeftovers();
  if (left) say(`${left} changes of a page that was closed are sent now.`);
  await Promise.all([loadContract(), listScenes()]);
  const wanted = new URLSearchParams(location.search).get("scene") ?? last_scene.value;
  const found = scenes.value.find(({id, name}) => id === wanted || name === wanted) ?? scenes.value[0];
  if (found) await openScene(found.id);
}

function useStart() {
  useEffect(() => {
    const stops = [listenToKeys(), followNews(), effect(() => { document.documentElement.dataset["theme"] = theme.value; })];
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
      <main><Viewport /></main>
      <Panels />
      <Messages />
      <KeySheet />
    </div>
  );
}
