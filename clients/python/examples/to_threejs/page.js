// Shows the same groom as glTF alone has it, #shells and #cards, and with shells that a shader makes of the fields, #shader.
import * as three from "three";
import {OrbitControls} from "three/examples/jsm/controls/OrbitControls.js";
import {GLTFLoader} from "three/examples/jsm/loaders/GLTFLoader.js";
import cards from "exported/cards.glb";
import fields from "exported/fields.glb";
import about from "exported/scene.json";
import shells from "exported/shells.glb";
import {shellsOf} from "./fur.js";

const renderer = new three.WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
renderer.setPixelRatio(Math.max(devicePixelRatio, 2));  // strands are finer than a pixel
const anisotropy = renderer.capabilities.getMaxAnisotropy();  // and are seen along the skin
renderer.setSize(about.size, about.size);
document.body.append(renderer.domElement);
const scene = new three.Scene();
scene.background = new three.Color("#c5c8ce");
const camera = new three.PerspectiveCamera(about.camera.fov_degrees);
camera.position.fromArray(about.camera.position);
const controls = new OrbitControls(camera, renderer.domElement);
controls.target.fromArray(about.camera.target);
controls.addEventListener("change", draw);

function draw() {
  const distance = camera.position.distanceTo(controls.target);
  camera.near = distance / 100, camera.far = distance * 10;
  camera.updateProjectionMatrix();
  renderer.render(scene, camera);
}

function addLights() {
  scene.add(new three.AmbientLight("white", Math.PI * about.ambient));
  for (const {direction, colour, intensity} of about.lights) {
    const light = new three.DirectionalLight(new three.Color(...colour), Math.PI * intensity);
    light.position.fromArray(direction).negate().add(controls.target);
    light.target.position.copy(controls.target);
    scene.add(light, light.target);
  }
}

/** The layers of the file are blended in their order over the skin; none of them hides those above it. */
function addShells({scene: model}) {
  let order = 0;
  model.traverse((part) => {
    if (!part.isMesh) return;
    part.renderOrder = order++;
    if (!part.material.transparent) return;
    part.material.depthWrite = false;
    part.material.map.anisotropy = anisotropy;
  });
  scene.add(model);
}

/** The scene of the finest level; edges of strands are smoothed by the samples of a pixel. */
function addCards({scene: model}) {
  model.traverse((part) => {
    if (!part.material?.map) return;
    part.material.alphaToCoverage = true;
    part.material.map.anisotropy = anisotropy;
  });
  scene.add(model);
}

async function show() {
  globalThis.createImageBitmap = undefined;  // pictures as elements: a headless browser waits for these alone
  const loader = new GLTFLoader();
  if (location.hash === "#cards") addCards(await loader.parseAsync(cards.buffer, ""));
  else if (location.hash === "#shader") scene.add(shellsOf((await loader.parseAsync(fields.buffer, "")).scene, {...about, anisotropy}));
  else addShells(await loader.parseAsync(shells.buffer, ""));
  controls.update();
  draw();
}

addLights();
addEventListener("hashchange", () => location.reload());
show();
