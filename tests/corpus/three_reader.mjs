// Models as three.js reads them: node three_reader.mjs < PATHS. A line of JSON for each path: triangles, area and sizes
// of the scene, or the error.
import { readFileSync } from 'node:fs';
import { dirname, extname } from 'node:path';
import { createInterface } from 'node:readline';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { DOMParser } from 'linkedom';

// What loaders expect of a browser; pictures are asked for, but not decoded.
class Progress extends Event {}
const element = () => ({ addEventListener() {}, removeEventListener() {}, style: {}, getContext: () => null });
Object.assign(globalThis, {
  self: globalThis, window: globalThis, DOMParser, ProgressEvent: Progress,
  document: { createElementNS: element, createElement: element },
  createImageBitmap: async () => ({ width: 1, height: 1, close() {} }),
  fetch: async (request) => {
    const url = request.url ?? String(request);
    if (url.startsWith('data:')) {
      const [head, data] = [url.slice(0, url.indexOf(',')), url.slice(url.indexOf(',') + 1)];
      return new Response(Buffer.from(decodeURIComponent(data), head.includes('base64') ? 'base64' : 'utf8'));
    }
    return new Response(readFileSync(fileURLToPath(url)));
  },
});
console.warn = console.log = console.info = console.error = () => {};
process.on('unhandledRejection', () => {});
const THREE = await import('three');
const loaders = 'three/examples/jsm/loaders/';
const [{ GLTFLoader }, { ColladaLoader }, { FBXLoader }, { TDSLoader }, { LWOLoader }, { AMFLoader }, { OBJLoader },
  { STLLoader }, { PLYLoader }, { ThreeMFLoader }, meshopt] = await Promise.all([
  'GLTFLoader', 'ColladaLoader', 'FBXLoader', 'TDSLoader', 'LWOLoader', 'AMFLoader', 'OBJLoader', 'STLLoader', 'PLYLoader',
  '3MFLoader'].map((name) => import(loaders + name + '.js')).concat(
  import('three/examples/jsm/libs/meshopt_decoder.module.js')));

const bytesOf = (file) => { const b = readFileSync(file); return b.buffer.slice(b.byteOffset, b.byteOffset + b.length); };
const text = (file) => readFileSync(file, 'utf8');
const folder = (file) => pathToFileURL(dirname(file)).href + '/';
const solid = (geometry) => new THREE.Mesh(geometry);
const withFaces = (geometry) => (geometry.index ? solid(geometry) : new THREE.Points(geometry));
const gltf = (file) => new Promise((resolve, reject) => new GLTFLoader().setMeshoptDecoder(meshopt.MeshoptDecoder)
  .parse(bytesOf(file), folder(file), (found) => resolve(found.scene), reject));
const READERS = {
  '.gltf': gltf, '.glb': gltf,
  '.dae': (file) => new ColladaLoader().parse(text(file), folder(file)).scene,
  '.fbx': (file) => new FBXLoader().parse(bytesOf(file), folder(file)),
  '.3ds': (file) => new TDSLoader().parse(bytesOf(file), folder(file)),
  '.lwo': (file) => {
    const group = new THREE.Group();
    group.add(...new LWOLoader().parse(bytesOf(file), folder(file), 'm').meshes);
    return group;
  },
  '.amf': (file) => new AMFLoader().parse(bytesOf(file)),
  '.3mf': (file) => new ThreeMFLoader().parse(bytesOf(file)),
  '.obj': (file) => new OBJLoader().parse(text(file)),
  '.stl': (file) => solid(new STLLoader().parse(bytesOf(file))),
  '.ply': (file) => withFaces(new PLYLoader().parse(bytesOf(file))),
};

function measured(scene) {
  scene.updateMatrixWorld(true);
  const out = { triangles: 0, area: 0, volume: 0, lower: [Infinity, Infinity, Infinity], upper: [-Infinity, -Infinity, -Infinity] };
  const [a, b, c] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
  const add = (mesh, matrix) => {
    const { position } = mesh.geometry.attributes, index = mesh.geometry.index;
    const count = (index ?? position)?.count ?? 0;
    for (let i = 0; i + 2 < count; i += 3) {
      [a, b, c].forEach((p, k) => {
        p.fromBufferAttribute(position, index ? index.getX(i + k) : i + k).applyMatrix4(matrix);
        p.toArray().forEach((x, axis) => {
          out.lower[axis] = Math.min(out.lower[axis], x);
          out.upper[axis] = Math.max(out.upper[axis], x);
        });
      });
      out.triangles += 1;
      out.volume += a.dot(b.clone().cross(c)) / 6;
      out.area += b.clone().sub(a).cross(c.clone().sub(a)).length() / 2;
    }
  };
  scene.traverse((o) => {
    if (!o.isMesh) return;
    if (!o.isInstancedMesh) return add(o, o.matrixWorld);
    for (let i = 0; i < o.count; ++i) {
      const one = new THREE.Matrix4();
      o.getMatrixAt(i, one);
      add(o, one.premultiply(o.matrixWorld));
    }
  });
  return out;
}

for await (const file of createInterface({ input: process.stdin })) {
  let found;
  try {
    const read = READERS[extname(file).toLowerCase()];
    found = measured(await Promise.race([read(file), new Promise((_, reject) => setTimeout(() => reject(new Error('hangs')), 20000))]));
  } catch (error) {
    found = { error: String(error?.message ?? error).split('\n')[0] };
  }
  process.stdout.write(JSON.stringify({ file, ...found }) + '\n');
}
process.exit(0);
