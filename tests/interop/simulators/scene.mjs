// Trivet's MJCF as data for engines that read no scene files; and small linear algebra.
import fs from 'node:fs';
import path from 'node:path';
import {DOMParser} from '@xmldom/xmldom';

const numbers = (text) => text.trim().split(/\s+/).map(Number);
const children = (element, tag) => Array.from(element.childNodes).filter((node) => node.nodeName === tag);

/** A hull of an OBJ file: {points: [[x, y, z], ...], triangles: [[a, b, c], ...]}. */
function readHull(file) {
  const lines = fs.readFileSync(file, 'utf8').split('\n');
  const of = (tag) => lines.filter((line) => line.startsWith(tag)).map((line) => line.slice(2));
  return {
    points: of('v ').map((text) => numbers(text).slice(0, 3)),
    triangles: of('f ').map((text) => text.trim().split(/\s+/).map((corner) => parseInt(corner) - 1)),
  };
}

/**
 * Reads a scene: {gravity, floor: friction or null, bodies: [{name, fixed, position, rotation
 * (w, x, y, z), mass, centre, inertia (xx, yy, zz, xy, xz, yz), friction, hulls: [{points, triangles}]}]}.
 */
export function readScene(file) {
  const root = new DOMParser().parseFromString(fs.readFileSync(file, 'utf8'), 'text/xml').documentElement;
  const folder = path.resolve(path.dirname(file), children(root, 'compiler')[0].getAttribute('meshdir'));
  const meshes = new Map();
  for (const mesh of children(children(root, 'asset')[0], 'mesh'))
    meshes.set(mesh.getAttribute('name'), path.join(folder, mesh.getAttribute('file')));
  const collides = (element) => children(element, 'geom').filter((g) => g.getAttribute('class') === 'collision');
  const frictionOf = (geom) => numbers(geom.getAttribute('friction'))[0];
  const world = children(root, 'worldbody')[0];
  const hulls = new Map();
  const hull = (name) => hulls.get(name) ?? hulls.set(name, readHull(meshes.get(name))).get(name);
  const floor = collides(world)[0];
  return {
    name: path.basename(file, '.xml'),
    gravity: -numbers(children(root, 'option')[0].getAttribute('gravity'))[2],
    floor: floor ? frictionOf(floor) : null,
    bodies: children(world, 'body').map((body) => {
      const inertial = children(body, 'inertial')[0], geoms = collides(body);
      return {
        name: body.getAttribute('name'),
        fixed: children(body, 'freejoint').length === 0,
        position: numbers(body.getAttribute('pos')),
        rotation: numbers(body.getAttribute('quat')),
        mass: Number(inertial.getAttribute('mass')),
        centre: numbers(inertial.getAttribute('pos')),
        inertia: numbers(inertial.getAttribute('fullinertia')),
        friction: frictionOf(geoms[0]),
        hulls: geoms.map((geom) => hull(geom.getAttribute('mesh'))),
      };
    }),
  };
}

/** The scene with other poses of some bodies, by name. */
export function startedFrom(scene, starts) {
  for (const name of Object.keys(starts))
    if (!scene.bodies.some((body) => body.name === name)) throw new Error(`${scene.name}: no body "${name}"`);
  return {...scene, bodies: scene.bodies.map((body) => ({...body, ...starts[body.name]}))};
}

/** A point turned by a unit quaternion (w, x, y, z). */
export function turned([w, x, y, z], [a, b, c]) {
  const s = [y * c - z * b, z * a - x * c, x * b - y * a].map((v) => 2 * v);
  return [a + w * s[0] + y * s[2] - z * s[1], b + w * s[1] + z * s[0] - x * s[2], c + w * s[2] + x * s[1] - y * s[0]];
}

/** Metres by which the farthest corner of a body's hulls moved from its pose in the file. */
export function moved(body, {position, rotation}) {
  let farthest = 0;
  for (const hull of body.hulls)
    for (const point of hull.points) {
      const from = turned(body.rotation, point), to = turned(rotation, point);
      farthest = Math.max(farthest, Math.hypot(...[0, 1, 2].map(
        (k) => to[k] + position[k] - from[k] - body.position[k])));
    }
  return farthest;
}

export function turnedDegrees(body, {rotation}) {
  const dot = Math.abs(body.rotation.reduce((sum, value, i) => sum + value * rotation[i], 0));
  return 2 * Math.acos(Math.min(1, dot)) * 180 / Math.PI;
}

/** Principal axes of a symmetric matrix (xx, yy, zz, xy, xz, yz), by Jacobi's rotations: {values, axes (w, x, y, z)}. */
export function principal([xx, yy, zz, xy, xz, yz]) {
  const m = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
  let q = [1, 0, 0, 0];
  for (let sweep = 0; sweep < 30; ++sweep)
    for (const [i, j] of [[0, 1], [0, 2], [1, 2]]) {
      if (Math.abs(m[i][j]) <= 1e-15 * (m[i][i] + m[j][j])) continue;
      const angle = Math.atan2(2 * m[i][j], m[i][i] - m[j][j]) / 2, c = Math.cos(angle), s = Math.sin(angle);
      for (let k = 0; k < 3; ++k) [m[k][i], m[k][j]] = [c * m[k][i] + s * m[k][j], c * m[k][j] - s * m[k][i]];
      for (let k = 0; k < 3; ++k) [m[i][k], m[j][k]] = [c * m[i][k] + s * m[j][k], c * m[j][k] - s * m[i][k]];
      const axis = 3 - i - j, sign = axis === 1 ? -1 : 1;
      const turn = [Math.cos(angle / 2), 0, 0, 0];
      turn[1 + axis] = sign * Math.sin(angle / 2);
      q = product(q, turn);
    }
  return {values: [m[0][0], m[1][1], m[2][2]], axes: q};
}

const product = ([a, b, c, d], [e, f, g, h]) => [a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g,
  a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e];
