// Draws shells from the export "fields": one mesh, instanced once for each shell, its vertices moved along the strands.
import * as three from "three";
import fragmentShader from "./fur.frag.glsl";
import vertexShader from "./fur.vert.glsl";

/** Returns the skin with its fur. model: the loaded file. lights, ambient: the scene's. anisotropy: the atlas's. */
export function shellsOf(model, {lights, ambient, anisotropy}) {
  const fur = new three.Group();
  const [skin] = meshesOf(model);
  const {fur_layers: layers, atlas_columns: columns} = skin.userData;
  const geometry = new three.InstancedBufferGeometry().copy(skin.geometry);
  geometry.instanceCount = layers;
  const shells = new three.Mesh(geometry, new three.ShaderMaterial({
    vertexShader, fragmentShader, vertexColors: true, transparent: true, depthWrite: false,
    defines: {LIGHTS: lights.length},
    uniforms: {
      layers: {value: layers}, columns: {value: columns}, ambient: {value: ambient}, atlas: {value: atlasOf(skin, anisotropy)},
      toLights: {value: lights.map(({direction}) => new three.Vector3(...direction).normalize().negate())},
      colours: {value: lights.map(({colour, intensity}) => new three.Vector3(...colour).multiplyScalar(intensity))},
    },
  }));
  shells.position.copy(skin.position);
  shells.renderOrder = 1;
  skin.material = new three.MeshStandardMaterial({vertexColors: true, color: new three.Color(.35, .35, .35), roughness: .9});
  fur.add(shells, skin);
  return fur;
}

function meshesOf(model) {
  const found = [];
  model.traverse((part) => part.isMesh && found.push(part));
  return found;
}

/** Returns the atlas of shells, which is sRGB; the file stores it as an occlusion texture, which loaders take as linear. */
function atlasOf({material}, anisotropy) {
  const atlas = material.aoMap;
  atlas.anisotropy = anisotropy;
  atlas.colorSpace = three.SRGBColorSpace;
  atlas.minFilter = three.LinearMipmapLinearFilter;
  atlas.needsUpdate = true;
  return atlas;
}
