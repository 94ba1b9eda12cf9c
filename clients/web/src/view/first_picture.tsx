// What stands in the picture's place until a scene's first one has come.
import {scene} from "../scene/session";
import {shown} from "./frames";

export function FirstPicture() {
  if (!scene.value || shown.value) return null;
  return <div class="first-picture" role="status"><p>The first picture is drawn…</p><progress aria-label="The first picture is drawn" /></div>;
}
