// A property of an engine, alone: a box on a lighter one on MuJoCo's floor. Its contacts are as
// stiff as the lighter of two bodies asks, so that a heavy one sinks into what carries it:
//   node heavy.mjs       Prints how deep, with MuJoCo's own options and with those of exports.
import loadMujoco from '@mujoco/mujoco';

const mujoco = await loadMujoco();
const OPTIONS = {
  'its own options': ['', ''],
  'exports': ['timestep="0.002" cone="elliptic" impratio="100"', 'solref="0.004 3" solimp="0.995 0.9995 0.0001"'],
  'exports of heavy loads': ['timestep="0.001" cone="elliptic" impratio="100" tolerance="1e-14"',
    'solref="0.002 3" solimp="0.9 0.9999 0.000002"'],
};

function sunk(ratio, [option, geom]) {
  const box = (name, z, mass) => `<body name="${name}" pos="0 0 ${z}"><freejoint/>
    <geom type="box" size="0.1 0.1 0.05" mass="${mass}" condim="4" friction="0.5 0.005 0.0001" ${geom}/></body>`;
  const model = mujoco.MjModel.from_xml_string(`<mujoco><option ${option}/><worldbody>
    <geom type="plane" size="0 0 1" ${geom}/>${box('light', 0.05, 1)}${box('heavy', 0.15, ratio)}</worldbody></mujoco>`);
  const data = new mujoco.MjData(model);
  while (data.time < 2) mujoco.mj_step(model, data);
  const [lower, upper] = [data.qpos[2], data.qpos[9]];
  data.delete();
  model.delete();
  return 1e3 * (0.1 - (upper - lower));
}

for (const [name, options] of Object.entries(OPTIONS))
  for (const ratio of [1, 10, 100, 1000])
    console.log(`${name}: ${ratio} times as heavy: sunk by ${sunk(ratio, options).toFixed(4)} mm`);
