// An exported scene beside the same objects as one writes them by hand for MuJoCo, a box each and
// MuJoCo's own options: steps per CPU second, and how many objects stay within a millimetre.
//   node hand_made.mjs SECONDS SCENE.xml
import loadMujoco from '@mujoco/mujoco';
import {moved, readScene} from './scene.mjs';
import {load} from './mujoco.mjs';

const mujoco = await loadMujoco();
const [seconds, file] = process.argv.slice(2);
const scene = readScene(file);

function boxOf({hulls}) {
  const points = hulls.flatMap((hull) => hull.points);
  const bound = (pick) => [0, 1, 2].map((k) => pick(...points.map((p) => p[k])));
  const low = bound(Math.min), high = bound(Math.max);
  return {at: low.map((v, k) => (v + high[k]) / 2), half: low.map((v, k) => (high[k] - v) / 2)};
}

function byHand() {
  const bodies = scene.bodies.map((body) => {
    const {at, half} = boxOf(body);
    return `<body pos="${body.position.join(' ')}" quat="${body.rotation.join(' ')}">${body.fixed ? '' : '<freejoint/>'}
      <geom type="box" pos="${at.join(' ')}" size="${half.join(' ')}" mass="${body.mass}"/></body>`;
  });
  return mujoco.MjModel.from_xml_string(`<mujoco><worldbody><geom type="plane" size="0 0 1"/>${bodies.join('')}</worldbody></mujoco>`);
}

/** [steps per CPU second, of steps of so many seconds] */
function timed(timestep, step) {
  const count = Math.round(Number(seconds) / timestep), cpu = process.cpuUsage();
  for (let i = 0; i < count; ++i) step();
  const {user, system} = process.cpuUsage(cpu);
  return Math.round(1e6 * count / (user + system));
}

function tell(name, geoms, speed, poseOf) {
  const free = scene.bodies.filter((body) => !body.fixed);
  const stay = free.filter((body) => moved(body, poseOf(body)) <= 1e-3).length;
  console.log(`${name}: ${geoms} geoms that collide, ${speed} steps per CPU second, ${stay} of ${free.length} within 1 mm`);
}

const exported = load(scene, file);
tell('exported', scene.bodies.reduce((sum, body) => sum + body.hulls.length, 0), timed(exported.timestep, exported.step), exported.pose);
exported.free();
const model = byHand(), data = new mujoco.MjData(model);
const speed = timed(model.opt.timestep, () => mujoco.mj_step(model, data));
tell('by hand', scene.bodies.length, speed, (body) => {
  const id = scene.bodies.indexOf(body) + 1;
  return {position: Array.from(data.xpos.slice(3 * id, 3 * id + 3)), rotation: Array.from(data.xquat.slice(4 * id, 4 * id + 4))};
});
