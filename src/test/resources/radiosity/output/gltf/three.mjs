// Prints what three.js sees in a glTF file as JSON: each mesh with sums over its attributes, and the camera.
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
globalThis.self ??= globalThis;
const { GLTFLoader } = await import(
  pathToFileURL(process.cwd() + '/node_modules/three/examples/jsm/loaders/GLTFLoader.js').href);
const bytes = readFileSync(process.argv[2]);
const file = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
const gltf = await new GLTFLoader().parseAsync(file, '');
gltf.scene.updateMatrixWorld(true);
const sum = (attribute, component) => {
  let total = 0;
  for (let i = 0; i < attribute.count; i++) total += attribute.getComponent(i, component);
  return total;
};
const meshes = [];
gltf.scene.traverse(o => {
  if (!o.isMesh) return;
  const a = o.geometry.attributes;
  meshes.push({
    name: o.material.name, unlit: o.material.isMeshBasicMaterial === true, vertexColours: o.material.vertexColors,
    side: o.material.side, elements: o.geometry.index.count / 3, vertices: a.position.count,
    position: [0, 1, 2].map(c => sum(a.position, c) + a.position.count * o.matrixWorld.elements[12 + c]),
    colour: [0, 1, 2, 3].map(c => sum(a.color, c)),
    radiosity: [0, 1, 2].map(c => sum(a._radiosity, c)), irradiance: [0, 1, 2].map(c => sum(a._irradiance, c)),
    reflectance: o.material.userData.reflectance
  });
});
const camera = gltf.cameras[0];
console.log(JSON.stringify({
  meshes, extras: gltf.asset.extras.radiosity,
  camera: { at: camera.getWorldPosition(camera.position.clone()).toArray(),
    towards: camera.getWorldDirection(camera.position.clone()).toArray(), fov: camera.fov, aspect: camera.aspect }
}));
