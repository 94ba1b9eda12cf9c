// Shows a groom in three forms: #shells and #cards are plain glTF, #shader draws shells made from the fields.
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
const anisotropy = renderer.capabilities.getMaxAnisotropy();  // strands are seen at grazing angles
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

/** Blends the shells over the skin in the file's order; they write no depth, so none hides those above it. */
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

/** Shows the finest level of detail; alpha-to-coverage with multisampling smooths the edges of strands. */
function addCards({scene: model}) {
  model.traverse((part) => {
    if (!part.material?.map) return;
    part.material.alphaToCoverage = true;
    part.material.map.anisotropy = anisotropy;
  });
  scene.add(model);
}

async function show() {
  globalThis.createImageBitmap = undefined;  // so textures load as <img>, which headless browsers wait for
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
