// Exported scenes at rest in an engine, or started from other poses. In JavaScript and in C++:
//   node rest.mjs mujoco|rapier|jolt SECONDS [--starts STARTS.jsonl] SCENE.xml...
//   bullet_rest                      SECONDS [--starts STARTS.jsonl] SCENE.xml...
//   mujoco2_rest                     SECONDS [--starts STARTS.jsonl] SCENE.xml...
// SCENE.xml is what `trivet export` writes; for mujoco2_rest with --mujoco 2. Modules are found from
// the folder of the scripts: copy ../package*.json and *.mjs to a folder and call `npm ci` there.
// Each line of STARTS.jsonl is a world: {"cup": {"position": [x, y, z], "rotation": [w, x, y, z]}, ...},
// metres, by the names of bodies in SCENE.xml; bodies without a pose start as in SCENE.xml, all at rest.
// A line of JSON is printed per scene and world: {"simulator", "scene", "seconds", "penetration",
// "warnings", "hulls", "steps_per_cpu_second", "cpu_seconds", "objects": [{"name", "moved", "turned_deg", "position",
// "rotation"}]}: of free bodies the final pose, and how far the farthest corner went from the start.
import fs from 'node:fs';
import {moved, readScene, startedFrom, turnedDegrees} from './scene.mjs';

const [engine, seconds, ...rest] = process.argv.slice(2);
const {name, version, load} = await import(`./${engine}.mjs`);

function simulate(scene, file) {
  const world = load(scene, file);
  const steps = Math.round(Number(seconds) / world.timestep), cpu = process.cpuUsage();
  world.step();
  const penetration = world.penetration();
  for (let i = 1; i < steps; ++i) world.step();
  const used = process.cpuUsage(cpu);
  const objects = scene.bodies.filter((body) => !body.fixed).map((body) => {
    const pose = world.pose(body);
    return {name: body.name, moved: moved(body, pose), turned_deg: turnedDegrees(body, pose), ...pose};
  });
  const warnings = world.warnings();
  world.free();
  return {simulator: `${name} ${version}`, scene: scene.name, seconds: Number(seconds), penetration, warnings,
    hulls: scene.bodies.reduce((sum, body) => sum + body.hulls.length, 0),
    steps_per_cpu_second: Math.round(1e6 * steps / (used.user + used.system)), cpu_seconds: 1e-6 * (used.user + used.system), objects};
}

const hasStarts = rest[0] === '--starts';
const worlds = hasStarts ? fs.readFileSync(rest[1], 'utf8').split('\n').filter(Boolean).map((line) => JSON.parse(line)) : [{}];
for (const file of rest.slice(hasStarts ? 2 : 0)) {
  const scene = readScene(file);
  for (const starts of worlds) console.log(JSON.stringify(simulate(startedFrom(scene, starts), file)));
}
