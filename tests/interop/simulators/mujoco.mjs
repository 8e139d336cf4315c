// Today's MuJoCo, which reads the MJCF file itself.
import fs from 'node:fs';
import path from 'node:path';
import loadMujoco from '@mujoco/mujoco';

const mujoco = await loadMujoco();
export const name = 'MuJoCo', version = mujoco.mj_versionString();

/** Copies a scene and its files into the engine's file system; returns its path there. */
function bring(file) {
  const xml = fs.readFileSync(file, 'utf8');
  const meshes = /meshdir="([^"]*)"/.exec(xml)[1], from = path.resolve(path.dirname(file), meshes);
  const to = path.join('/', path.basename(file) + '.d', meshes);
  mujoco.FS.mkdirTree(to);
  for (const [, asset] of xml.matchAll(/<(?:mesh|texture) [^>]*file="([^"]*)"/g))
    mujoco.FS.writeFile(path.join(to, asset), fs.readFileSync(path.join(from, asset)));
  const target = path.join('/', path.basename(file) + '.d', path.basename(file));
  mujoco.FS.writeFile(target, xml);
  return target;
}

function countWarnings(data) {
  let count = 0;
  for (let i = 0; i < data.warning.size(); ++i) count += data.warning.get(i).number;
  return count;
}

function place(model, data, id, {fixed, position, rotation}) {
  if (fixed) {
    model.body_pos.set(position, 3 * id);
    model.body_quat.set(rotation, 4 * id);
  } else {
    data.qpos.set([...position, ...rotation], model.jnt_qposadr[model.body_jntadr[id]]);
  }
}

/** Bodies as the engine names, places and weighs them. */
export function read(file) {
  const model = mujoco.MjModel.from_xml_path(bring(file)), data = new mujoco.MjData(model);
  mujoco.mj_forward(model, data);
  return Array.from({length: model.nbody - 1}, (_, k) => k + 1).map((id) => {
    const [x, y, z] = data.xpos.slice(3 * id, 3 * id + 3), q = data.xquat.slice(4 * id, 4 * id + 4);
    return {name: mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY.value, id), position: {x, y, z},
      quaternion: {w: q[0], x: q[1], y: q[2], z: q[3]}, mass: model.body_mass[id]};
  });
}

export function load(scene, file) {
  const model = mujoco.MjModel.from_xml_path(bring(file)), data = new mujoco.MjData(model);
  const ids = new Map(scene.bodies.map((body) => [body.name, mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY.value, body.name)]));
  for (const body of scene.bodies) place(model, data, ids.get(body.name), body);
  mujoco.mj_forward(model, data);
  let deepest = 0;
  for (let i = 0; i < data.ncon; ++i) deepest = Math.max(deepest, -data.contact.get(i).dist);
  return {
    timestep: model.opt.timestep,
    penetration: () => deepest,
    step: () => mujoco.mj_step(model, data),
    pose(body) {
      const id = ids.get(body.name);
      return {position: Array.from(data.xpos.slice(3 * id, 3 * id + 3)), rotation: Array.from(data.xquat.slice(4 * id, 4 * id + 4))};
    },
    warnings: () => countWarnings(data),
    free: () => { data.delete(); model.delete(); },
  };
}
