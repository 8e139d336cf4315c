// A limit of engines that solve contacts one after another: a box on a lighter one, 3 cm from its
// middle, and a slab on three light posts, as many times as heavy. By how much the upper ones move
// in 5 s, in mm: node loads.mjs jolt|rapier
import {moved} from './scene.mjs';

const {load, name} = await import(`./${process.argv[2]}.mjs`);

function box(size, position, mass) {
  const [a, b, c] = size.map((v) => v / 2), about = (p, q) => mass * (p * p + q * q) / 12;
  const points = [-c, c].flatMap((z) => [[-a, -b, z], [a, -b, z], [a, b, z], [-a, b, z]]);
  const triangles = [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7]];
  for (let i = 0, j = 1; i < 4; ++i, j = (i + 1) % 4) triangles.push([i, j, j + 4], [i, j + 4, i + 4]);
  return {name: position.join(), fixed: false, position, rotation: [1, 0, 0, 0], mass, centre: [0, 0, 0],
    inertia: [about(size[1], size[2]), about(size[0], size[2]), about(size[0], size[1]), 0, 0, 0], friction: 0.5, hulls: [{points, triangles}]};
}

const UP = 1e-6;  // metres between things
for (const times of [1, 10, 100, 1000]) {
  const upper = box([0.1, 0.1, 0.1], [0.03, 0, 0.15 + 2 * UP], 0.1 * times), lower = box([0.1, 0.1, 0.1], [0, 0, 0.05 + UP], 0.1);
  const slab = box([0.3, 0.3, 0.05], [1.03, 0, 0.125 + 2 * UP], 0.01 * times);
  const posts = [[-0.1, -0.1], [0.1, -0.1], [0, 0.12]].map(([x, y]) => box([0.02, 0.02, 0.1], [1 + x, y, 0.05 + UP], 0.01));
  const world = load({gravity: 9.81, floor: 0.5, bodies: [lower, upper, slab, ...posts]});
  for (let i = 0; i < 5 / world.timestep; ++i) world.step();
  const way = (body) => (1e3 * moved(body, world.pose(body))).toFixed(3);
  console.log(`${name}, ${times} times as heavy: box ${way(upper)} mm, slab ${way(slab)} mm`);
  world.free();
}
