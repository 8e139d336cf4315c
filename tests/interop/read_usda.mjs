// Prints a .usda as read by npm's tinyusdz: bodies of the world with poses, masses and names, as JSON.
//   node read_usda.mjs FILE.usda
// The package is built for browsers and returns a layer as text, in its own words and order.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';

process.type = 'renderer';
globalThis.window = globalThis;
const {default: start} = await import('tinyusdz/tinyusdz.js');
const binary = readFileSync(createRequire(import.meta.url).resolve('tinyusdz/tinyusdz.wasm'));
const usd = await start({
  instantiateWasm(imports, done) {
    WebAssembly.instantiate(binary, imports).then(({instance, module}) => done(instance, module));
    return {};
  },
});

/** The layer as the library prints what it read. */
function layerText(file) {
  const loader = new usd.TinyUSDZLoaderNative();
  if (!loader.loadAsLayerFromBinary(readFileSync(file), file)) throw new Error(loader.error());
  return loader.layerToString();
}

/** The library quotes by ' what has a " inside. */
const quoted = (text) => (text[0] === "'" ? text.slice(1, -1).replace(/\\(.)/g, '$1') : JSON.parse(text));
const numbers = (text) => text.replace(/[()]/g, '').split(',').map(Number);

/** Prims right below the default prim: {name, and the attributes as text}. */
function bodies(text) {
  const out = [];
  let depth = 0;
  for (const line of text.split('\n').map((l) => l.trim())) {
    const prim = /^def (\w+) ("(?:[^"\\]|\\.)*")/.exec(line);
    if (prim && depth === 1) out.push({type: prim[1], name: quoted(prim[2]), attributes: {}});
    const attribute = /^(?:custom |uniform )*[\w[\]]+ ([\w:]+) = (.*)$/.exec(line);
    if (attribute && depth === 2) out.at(-1).attributes[attribute[1]] = attribute[2];
    if (line === '{') ++depth;
    if (line === '}') --depth;
  }
  return out;
}

const objects = bodies(layerText(process.argv[2])).filter((body) => 'xformOp:translate' in body.attributes).map((body) => {
  const {attributes} = body;
  const [x, y, z] = numbers(attributes['xformOp:translate']);
  const [w, i, j, k] = numbers(attributes['xformOp:orient']);
  return {name: body.name, given: quoted(attributes['trivet:name']), position: {x, y, z}, quaternion: {w, x: i, y: j, z: k},
    mass: 'physics:mass' in attributes ? Number(attributes['physics:mass']) : null};
});
console.log(JSON.stringify({objects}));
