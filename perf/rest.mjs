// node rest.mjs SECONDS SCENE...: how far MuJoCo moves the free bodies of each scene from its start state.
// Needs @mujoco/mujoco of npm. Prints a line of JSON for each: {"file", "version", "moved": {body: metres},
// "end": {body: [x, y, z, qw, qx, qy, qz]}, "joints": {joint: by how much its value changed, metres or radians}} or "error".
import load from '@mujoco/mujoco';
import fs from 'fs';
import path from 'path';

const FREE = 0, SLIDE = 2;  // mjJNT_FREE, mjJNT_SLIDE; mjJNT_HINGE is the next
const MOST_BYTES = 500e6;

function filesBelow(folder) {
  return fs.readdirSync(folder, {withFileTypes: true, recursive: true})
      .filter(entry => entry.isFile())
      .map(entry => path.relative(folder, path.join(entry.parentPath ?? entry.path, entry.name)));
}

function makeFolders(FS, file) {
  let at = '';
  for (const part of path.posix.dirname(file).split('/').slice(1)) {
    at += '/' + part;
    try { FS.mkdir(at); } catch { /* it is there */ }
  }
}

function copyIn(FS, folder) {
  const names = filesBelow(folder);
  const bytes = names.reduce((sum, name) => sum + fs.statSync(path.join(folder, name)).size, 0);
  if (bytes > MOST_BYTES) throw new Error(`${folder} is larger than ${MOST_BYTES} bytes`);
  for (const name of names) {
    makeFolders(FS, '/scene/' + name);
    FS.writeFile('/scene/' + name, fs.readFileSync(path.join(folder, name)));
  }
  return names;
}

function nameAt(model, address) {
  let name = '';
  for (let i = address; model.names[i] && model.names[i] !== '\0'; ++i)
    name += typeof model.names[i] === 'number' ? String.fromCharCode(model.names[i]) : model.names[i];
  return name;
}

function movedBodies(mj, model, seconds) {
  const data = new mj.MjData(model);
  if (model.nkey > 0) mj.mj_resetDataKeyframe(model, data, 0);
  mj.mj_forward(model, data);
  const from = Array.from(data.xipos), values = Array.from(data.qpos);
  const steps = Math.round(seconds / model.opt.timestep);
  for (let i = 0; i < steps; ++i) mj.mj_step(model, data);
  const moved = {}, end = {}, joints = {};
  for (let j = 0; j < model.njnt; ++j) {
    if (model.jnt_type[j] >= SLIDE) {
      const at = model.jnt_qposadr[j];
      joints[nameAt(model, model.name_jntadr[j]) || `joint ${j}`] = data.qpos[at] - values[at];
    }
    if (model.jnt_type[j] !== FREE) continue;
    const body = model.jnt_bodyid[j];
    const away = [0, 1, 2].map(k => data.xipos[3 * body + k] - from[3 * body + k]);
    const name = nameAt(model, model.name_bodyadr[body]) || `body ${body}`;
    moved[name] = Math.hypot(...away);
    end[name] = [...[0, 1, 2].map(k => data.xpos[3 * body + k]), ...[0, 1, 2, 3].map(k => data.xquat[4 * body + k])];
  }
  data.delete?.();
  return {moved, end, joints};
}

const mj = await load({print: () => {}, printErr: () => {}});
const [seconds, ...scenes] = process.argv.slice(2);
for (const file of scenes) {
  let answer = {file, version: mj.mj_versionString()};
  let names = [];
  try {
    names = copyIn(mj.FS, path.dirname(path.resolve(file)));
    const main = '/scene/' + path.basename(file);
    const model = mj.MjModel.mj_loadXML ? mj.MjModel.mj_loadXML(main) : mj.MjModel.loadFromXML(main);
    Object.assign(answer, movedBodies(mj, model, Number(seconds)));
    model.delete?.();
  } catch (error) {
    answer = {file, error: String(error.message ?? error)};
  }
  for (const name of names) mj.FS.unlink('/scene/' + name);
  console.log(JSON.stringify(answer));
}
