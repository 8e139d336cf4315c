// A fault of an engine, alone: prisms of a metre on Rapier's floor. Those with a foot of many corners
// creep and rock, as the engine keeps four corners of a face: node prism.mjs
import rapier from '@dimforge/rapier3d-deterministic-compat';

await rapier.init();

function prism(corners) {
  const points = [];
  for (const z of [0, 1])
    for (let i = 0; i < corners; ++i)
      points.push(Math.cos(2 * Math.PI * i / corners), Math.sin(2 * Math.PI * i / corners), z);
  return rapier.ColliderDesc.convexHull(new Float32Array(points));
}

for (const corners of [4, 8, 16, 24, 48]) {
  const world = new rapier.World({x: 0, y: 0, z: -9.81});
  world.timestep = 1 / 240;
  world.createCollider(rapier.ColliderDesc.cuboid(50, 50, 1).setTranslation(0, 0, -1));
  const body = world.createRigidBody(rapier.RigidBodyDesc.dynamic().setTranslation(0, 0, 1e-4));
  world.createCollider(prism(corners), body);
  for (let i = 0; i < 2 * 240; ++i) world.step();
  const {x, y} = body.translation();
  console.log(`${corners} corners: ${(1000 * Math.hypot(x, y)).toFixed(2)} mm in 2 s, ${body.isSleeping() ? 'asleep' : 'awake'}`);
}
