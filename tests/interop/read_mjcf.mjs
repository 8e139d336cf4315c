// Prints a scene as npm's MuJoCo reads it: bodies with poses and masses, as JSON.
//   node read_mjcf.mjs SCENE.xml          Needs simulators/mujoco.mjs beside it.
import {read} from './mujoco.mjs';

console.log(JSON.stringify({objects: read(process.argv[2])}));
