// node mujoco_poses.mjs FOLDER OUT.jsonl: what MuJoCo of npm makes of each MJCF and URDF file below FOLDER, at its first keyframe, if
// there is one, and at the reference. Needs @mujoco/mujoco in the folder of this file or above it. Each line of OUT: {"file", "version", "states":
// {"key" or "reference": {name: [x, y, z, qw, qx, qy, qz, kilograms, centre x, y, z]}}} or {"file", "error"}. Masses and centres are those of
// the body and all that is welded to it. Pictures are white pixels, and meshes of URDF spheres: MuJoCo looks for them elsewhere.
import load from '@mujoco/mujoco';
import fs from 'fs';
import path from 'path';

const PIXEL = Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4//8/AAX+Av4N70a4AAAAAElFTkSuQmCC', 'base64');

const mj = await load({print: () => {}, printErr: () => {}});
const [folder, out] = process.argv.slice(2);
const names = fs.readdirSync(folder, {withFileTypes: true, recursive: true})
    .filter(entry => entry.isFile())
    .map(entry => path.relative(folder, path.join(entry.parentPath ?? entry.path, entry.name))).sort();

for (const name of names) {
  mj.FS.mkdirTree(path.posix.dirname('/scene/' + name));
  mj.FS.writeFile('/scene/' + name, name.endsWith('.png') ? PIXEL : fs.readFileSync(path.join(folder, name)));
}

// The text of a model's file as MuJoCo gets it; undefined: it is none.
function modelText(name) {
  if (!/\.(xml|urdf)$/.test(name)) return undefined;
  const text = fs.readFileSync(path.join(folder, name), 'utf8');
  if (name.endsWith('.xml')) return text.includes('<mujoco') ? text : undefined;
  return text.replace(/<mesh\b[^>]*>(\s*<\/mesh>)?/g, '<sphere radius="0.1"/>');
}

function nameAt(model, address) {
  let name = '';
  for (let i = address; model.names[i] && model.names[i] !== '\0'; ++i)
    name += typeof model.names[i] === 'number' ? String.fromCharCode(model.names[i]) : model.names[i];
  return name;
}

function state(model, key) {
  const data = new mj.MjData(model);
  if (key) mj.mj_resetDataKeyframe(model, data, 0);
  mj.mj_kinematics(model, data);
  mj.mj_comPos(model, data);
  const bodies = {}, masses = {};
  for (let i = 1; i < model.nbody; ++i) {
    const of = masses[model.body_weldid[i]] ??= [0, 0, 0, 0];
    of[0] += model.body_mass[i];
    for (let k = 0; k < 3; ++k) of[k + 1] += model.body_mass[i] * data.xipos[3 * i + k];
  }
  for (let i = 1; i < model.nbody; ++i) {
    const name = nameAt(model, model.name_bodyadr[i]), [mass, ...moment] = masses[model.body_weldid[i]];
    if (name) bodies[name] = [...data.xpos.slice(3 * i, 3 * i + 3), ...data.xquat.slice(4 * i, 4 * i + 4), mass,
                              ...moment.map(m => mass > 0 ? m / mass : 0)];
  }
  data.delete?.();
  return bodies;
}

const lines = [];
for (const name of names) {
  const text = modelText(name);
  if (text === undefined) continue;
  mj.FS.writeFile('/scene/' + name, text);
  let line = {file: name, version: mj.mj_versionString()};
  try {
    const main = '/scene/' + name;
    const model = mj.MjModel.mj_loadXML ? mj.MjModel.mj_loadXML(main) : mj.MjModel.loadFromXML(main);
    line.states = {reference: state(model, false)};
    if (model.nkey > 0) line.states.key = state(model, true);
    model.delete?.();
  } catch (error) {
    line.error = String(error.message ?? error);
  }
  lines.push(JSON.stringify(line));
}
fs.writeFileSync(out, lines.join('\n') + '\n');
