// Checks a scene in three.js's loader: node three_check.mjs SCENE EXPECTED.json (of expected.py)
import { readFile } from 'node:fs/promises';
import assert from 'node:assert/strict';

// Browser objects that the loader expects; images are requested but not decoded.
globalThis.self = globalThis;
let numPictures = 0;
globalThis.createImageBitmap = async (blob) => {
  numPictures += 1;
  assert.ok(blob.size > 0);
  return { width: 1, height: 1, close() {} };
};
const { GLTFLoader } = await import('three/examples/jsm/loaders/GLTFLoader.js');
const THREE = await import('three');

const [scene, expectedFile] = process.argv.slice(2);
const expected = JSON.parse(await readFile(expectedFile));
const bytes = await readFile(scene);
const gltf = await new Promise((resolve, reject) => new GLTFLoader().parse(
  bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), '', resolve, reject));
gltf.scene.updateMatrixWorld(true);

assert.equal(gltf.scene.children.length, expected.length, 'number of objects');
let worst = 0;
for (const want of expected) {
  const object = gltf.scene.children.find((o) => (o.userData.name ?? o.name) === want.name);
  assert.ok(object, `no object "${want.name}"`);
  const materials = new Set();
  let lights = 0, cameras = 0;
  object.traverse((o) => {
    if (o.material) materials.add(o.material.name);
    lights += o.isLight ? 1 : 0;
    cameras += o.isCamera ? 1 : 0;
  });
  assert.deepEqual([...materials].sort(), want.materials, `materials of "${want.name}"`);
  assert.equal(lights, want.lights, `lights of "${want.name}"`);
  assert.equal(cameras, want.cameras, `cameras of "${want.name}"`);
  // The world's z is the file's y: (x, y, z) is written (x, z, -y).
  const turn = new THREE.Matrix4().set(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);
  const wanted = turn.multiply(new THREE.Matrix4().set(...want.world));
  const found = object.matrixWorld.clone().multiply(
    new THREE.Matrix4().makeTranslation(...want.pivot));
  const size = Math.max(1, ...want.pivot.map(Math.abs), ...want.world.map(Math.abs));
  for (let i = 0; i < 16; ++i)
    worst = Math.max(worst, Math.abs(found.elements[i] - wanted.elements[i]) / size);
}
assert.ok(worst < 1e-6, `poses differ by ${worst}`);
console.log(`${scene}: three.js ${THREE.REVISION}: ${expected.length} objects, ${numPictures} ` +
  `pictures; poses differ by ${worst.toExponential(1)} at most`);
