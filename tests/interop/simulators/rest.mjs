// Exported scenes at rest in an engine: node rest.mjs mujoco|rapier|jolt SECONDS SCENE.xml...
// Prints a line of JSON per scene, as every program of this folder does.
import {moved, readScene, turnedDegrees} from './scene.mjs';

const [engine, seconds, ...files] = process.argv.slice(2);
const {name, version, load} = await import(`./${engine}.mjs`);

function simulate(file) {
  const scene = readScene(file), world = load(scene, file);
  const steps = Math.round(Number(seconds) / world.timestep), cpu = process.cpuUsage();
  world.step();
  const penetration = world.penetration();
  for (let i = 1; i < steps; ++i) world.step();
  const used = process.cpuUsage(cpu);
  const objects = scene.bodies.filter((body) => !body.fixed).map((body) => {
    const pose = world.pose(body);
    return {name: body.name, moved: moved(body, pose), turned_deg: turnedDegrees(body, pose)};
  });
  const warnings = world.warnings();
  world.free();
  return {simulator: `${name} ${version}`, scene: scene.name, seconds: Number(seconds), penetration, warnings,
    hulls: scene.bodies.reduce((sum, body) => sum + body.hulls.length, 0),
    steps_per_cpu_second: Math.round(1e6 * steps / (used.user + used.system)), objects};
}

for (const file of files) console.log(JSON.stringify(simulate(file)));
