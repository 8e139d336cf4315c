// A fault of an engine, alone: a sled on MuJoCo's floor that stands on the edges of two runners
// (sled.py). If the faces at the ends of the edges are flatter than those beside them, the engine
// finds one contact of each edge, and the sled creeps; balls at the ends hold it: node ridge.mjs
// Exit status 1 if that changed.
import loadMujoco from '@mujoco/mujoco';

const mujoco = await loadMujoco();
const CONTACT = 'condim="4" friction="0.5 0.005 0.0001" solref="0.004 3" solimp="0.995 0.9995 0.0001"';

/** Its tips rise by 2 mm on their way out. */
function runner(tip) {
  const out = [[-0.2, 0, 0], [0.2, 0, 0]];
  for (const x of [-0.2 - tip, 0.2 + tip]) for (const y of [-1, 1]) out.push([x, 0.01 * y, 0.002], [x, 0.02 * y, 0.02]);
  return out;
}

const balls = (y) => [-0.2, 0.2].map((x) => `<geom type="sphere" size="1e-5" pos="${x} ${y} 1e-5"/>`).join('');

function creep(tip, hasBalls) {
  const sides = [-0.1, 0.1].map((y) => `<geom type="mesh" mesh="runner" pos="0 ${y} 0"/>${hasBalls ? balls(y) : ''}`);
  const model = mujoco.MjModel.from_xml_string(`<mujoco><option cone="elliptic" impratio="100"/>
    <default><geom ${CONTACT} margin="1e-6"/></default>
    <asset><mesh name="runner" inertia="shell" vertex="${runner(tip).flat().join(' ')}"/></asset>
    <worldbody><geom type="plane" size="0 0 1"/><body pos="0 0 1e-6"><freejoint/>
      <inertial pos="0 0 0.05" mass="1" diaginertia="0.01 0.01 0.01"/>${sides.join('')}</body></worldbody></mujoco>`);
  const data = new mujoco.MjData(model);
  mujoco.mj_forward(model, data);
  const count = data.ncon;
  while (data.time < 2) mujoco.mj_step(model, data);
  const way = 1e3 * Math.hypot(data.qpos[0], data.qpos[1], data.qpos[2] - 1e-6);
  data.delete();
  model.delete();
  console.log(`tips of ${1e3 * tip} mm${hasBalls ? ', balls' : ''}: ${count} contacts, ${way.toFixed(3)} mm in 2 s`);
  return way;
}

const ways = [[0.001, false], [0.05, false], [0.05, true]].map((which) => creep(...which));
process.exitCode = ways[0] < 0.1 && ways[1] > 0.1 && ways[2] < 0.1 ? 0 : 1;
