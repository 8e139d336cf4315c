// Exported scenes at rest in today's MuJoCo: node mujoco_rest.mjs SECONDS SCENE.xml...
// Every body stays within a millimetre, and MuJoCo warns of nothing.
import fs from 'node:fs';
import path from 'node:path';
import loadMujoco from '@mujoco/mujoco';

const MOST_MM = 1;
const mujoco = await loadMujoco();

/** Copies a scene and its meshes into the engine's file system; returns its path there. */
function bring(file) {
  const folder = path.dirname(file), name = path.basename(file);
  const xml = fs.readFileSync(file, 'utf8');
  const meshes = path.join('/', name + '.d', /meshdir="([^"]*)"/.exec(xml)[1]);
  mujoco.FS.mkdirTree(meshes);
  for (const [, mesh] of xml.matchAll(/<mesh [^>]*file="([^"]*)"/g))
    mujoco.FS.writeFile(path.join(meshes, mesh), fs.readFileSync(path.join(folder, path.basename(meshes), mesh)));
  const target = path.join('/', name + '.d', name);
  mujoco.FS.writeFile(target, xml);
  return target;
}

/** Millimetres by which each body moves within so many seconds; and the simulation's figures. */
function simulate(file, seconds) {
  const model = mujoco.MjModel.from_xml_path(bring(file));
  const data = new mujoco.MjData(model);
  mujoco.mj_forward(model, data);
  const start = Array.from(data.xpos);
  const steps = Math.round(seconds / model.opt.timestep);
  const cpu = process.cpuUsage();
  for (let i = 0; i < steps; ++i) mujoco.mj_step(model, data);
  const used = process.cpuUsage(cpu);
  const moved = [];
  for (let b = 1; b < model.nbody; ++b)
    moved.push(1000 * Math.hypot(...[0, 1, 2].map((k) => data.xpos[3 * b + k] - start[3 * b + k])));
  const out = {moved, geoms: model.ngeom, rate: Math.round(1e6 * steps / (used.user + used.system))};
  data.delete(), model.delete();
  return out;
}

let failed = false;
const [seconds, ...files] = process.argv.slice(2);
for (const file of files) {
  const {moved, geoms, rate} = simulate(file, Number(seconds));
  const stays = moved.filter((mm) => mm < MOST_MM).length;
  console.log(`MuJoCo ${mujoco.mj_versionString()}: ${path.basename(file)}: ${stays} of ${moved.length} bodies within ` +
    `${MOST_MM} mm after ${seconds} s, farthest ${Math.max(...moved).toFixed(3)} mm; ${geoms} geoms, ${rate} steps per CPU second`);
  failed ||= stays < moved.length;
}
process.exit(failed ? 1 : 0);
