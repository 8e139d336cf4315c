// Prints a .urdf as read by npm's urdf-loader: links below the world with poses and masses, as JSON.
//   node read_urdf.mjs FILE.urdf
import {readFileSync} from 'node:fs';
import {DOMParser, Element, Document} from '@xmldom/xmldom';
import {Object3D, Quaternion, Vector3} from 'three';

// Browser objects that the loader expects. It selects by child[link="NAME"] alone.
globalThis.DOMParser = DOMParser;
const elements = (node) => Array.from(node.childNodes).filter((child) => child.nodeType === 1);
const descendants = (node) => elements(node).flatMap((child) => [child, ...descendants(child)]);
Element.prototype.querySelector = function (selector) {
  const link = /^child\[link="(.*)"\]$/s.exec(selector)[1];
  return descendants(this).find((child) => child.nodeName === 'child' && child.getAttribute('link') === link) ?? null;
};
globalThis.Document = Document;
globalThis.Element = Element;

const {default: URDFLoader} = await import('urdf-loader');
const loader = new URDFLoader();
loader.parseCollision = true;
const meshes = new Map();  // by path, how often it is used
loader.loadMeshCb = (path, manager, materialOrDone, done = materialOrDone) => {
  meshes.set(path, (meshes.get(path) ?? 0) + 1);
  done(new Object3D());
};
const robot = loader.parse(readFileSync(process.argv[2], 'utf8'));
robot.updateMatrixWorld(true);
const links = Object.entries(robot.links).map(([name, link]) => {
  const position = new Vector3(), quaternion = new Quaternion();
  link.matrixWorld.decompose(position, quaternion, new Vector3());
  const {x, y, z} = position, q = quaternion;
  const mass = descendants(link.urdfNode).find((node) => node.nodeName === 'mass');
  return {name, position: {x, y, z}, quaternion: {w: q.w, x: q.x, y: q.y, z: q.z},
    mass: mass ? Number(mass.getAttribute('value')) : null};
});
console.log(JSON.stringify({objects: links, meshes: [...meshes.keys()].sort()}));
