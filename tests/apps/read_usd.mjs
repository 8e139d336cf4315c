// Prints a .usdz as read by three's USDLoader: nodes, with poses, meshes and triangles, as JSON.
//   node read_usd.mjs PATH/TO/USDLoader.js FILE.usdz
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const [loaderFile, file] = process.argv.slice(2);
const { USDLoader } = await import(pathToFileURL(loaderFile));
const bytes = readFileSync(file);
const root = new USDLoader().parse(
  bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
const nodes = [];
root.traverse((node) => {
  let meshes = 0, triangles = 0;
  node.traverse((child) => {
    if (!child.isMesh) return;
    const { index, attributes } = child.geometry;
    meshes += 1;
    triangles += (index ? index.count : attributes.position.count) / 3;
  });
  const { x, y, z } = node.position, q = node.quaternion;
  nodes.push({ name: node.name, position: { x, y, z },
    quaternion: { w: q.w, x: q.x, y: q.y, z: q.z }, meshes, triangles });
});
console.log(JSON.stringify(nodes));
