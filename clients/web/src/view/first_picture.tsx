// The placeholder until a scene's first picture arrives: the last picture that this browser showed, or a fox on a first
// visit.
import fox from "../../pictures/first.webp";
import {scene} from "../scene/session";
import {last_picture, thumbnails} from "../scene/thumbnails";
import {shown} from "./frames";

export function FirstPicture() {
  if (shown.value) return null;
  const stored = !scene.value ? last_picture.value?.address ?? fox : last_picture.value?.scene === scene.value.id ? last_picture.value.address : thumbnails.value[scene.value.id];
  return (
    <>
      {stored && <img class="stored-picture" src={stored} alt="" />}
      {scene.value && <div class="first-picture" role="status"><p>Drawing the first picture…</p><progress aria-label="Drawing the first picture" /></div>}
    </>
  );
}
