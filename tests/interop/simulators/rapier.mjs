// Rapier: convex hulls by calls. Of two coefficients of friction the smaller one.
import rapier from '@dimforge/rapier3d-deterministic-compat';
import {middleOf, normal} from './hull_pieces.mjs';
import {principal, turned} from './scene.mjs';

await rapier.init();
export const name = 'Rapier', version = rapier.version();

const UNIT = 100;  // per metre: the engine's tolerances of contacts are absolute
const BALL = 1e-5;  // metres: their radius
const FOOT = {height: 3e-3, steepness: 0.999};  // metres above the lowest corner; downwards
const FLOOR = 10;  // metres: of a larger floor contacts with wedges have false normals, millimetres deep
const scaled = (values, factor = UNIT) => values.map((value) => factor * value);
const vector = ([x, y, z]) => ({x, y, z});
const quaternion = ([w, x, y, z]) => ({w, x, y, z});

function addBody(world, body) {
  const description = body.fixed ? rapier.RigidBodyDesc.fixed() : rapier.RigidBodyDesc.dynamic();
  description.setTranslation(...scaled(body.position)).setRotation(quaternion(body.rotation));
  if (!body.fixed) {
    const {values, axes} = principal(body.inertia);
    description.setAdditionalMassProperties(body.mass, vector(scaled(body.centre)),
      vector(scaled(values, UNIT * UNIT)), quaternion(axes));
  }
  const rigid = world.createRigidBody(description);
  for (const hull of body.hulls) {
    const shape = rapier.ColliderDesc.convexMesh(new Float32Array(scaled(hull.points.flat())), new Uint32Array(hull.triangles.flat()));
    if (!shape) throw new Error(`${body.name}: Rapier takes no hull of ${hull.points.length} points`);
    addCollider(world, shape, body.friction, rigid);
  }
  if (!body.fixed) {
    addBalls(world, body, rigid);
    addFeet(world, body, rigid);
  }
  return rigid;
}

function addCollider(world, shape, friction, rigid) {
  shape.setDensity(0).setFriction(friction).setFrictionCombineRule(rapier.CoefficientCombineRule.Min);
  return world.createCollider(shape, rigid);
}

const dot = (a, b) => a.reduce((sum, v, k) => sum + v * b[k], 0);

/**
 * Faces on which a body stands, in pieces: of a face the engine keeps four corners, so that a round
 * foot across an edge would tip (see prism.mjs). Each piece has four and the middle of the hull.
 */
function addFeet(world, body, rigid) {
  const [w, x, y, z] = body.rotation, down = turned([w, -x, -y, -z], [0, 0, -1]);
  const lowest = Math.max(...body.hulls.flatMap(({points}) => points).map((p) => dot(p, down)));
  for (const {points, triangles} of body.hulls) {
    const foot = triangles.map((corners) => corners.map((i) => points[i])).filter((corners) =>
      corners.every((p) => dot(p, down) > lowest - FOOT.height) && dot(normal(corners), down) > FOOT.steepness);
    for (let i = 0; foot.length > 2 && i < foot.length; i += 2) {
      const corners = [...new Set(foot.slice(i, i + 2).flat()), middleOf(points)];
      const shape = rapier.ColliderDesc.convexHull(new Float32Array(scaled(corners.flat())));
      if (shape) addCollider(world, shape, body.friction, rigid);
    }
  }
}

/**
 * Corners on which a body stands: of the vertices near its lowest one the farthest in each of 16
 * directions. The engine keeps four corners of a face, so that a round foot would tip on a flat top
 * (see prism.mjs): these corners get balls.
 */
function standingCorners(body) {
  const placed = body.hulls.flatMap((hull) => hull.points).map((point) => ({point, at: turned(body.rotation, point)}));
  const heights = placed.map(({at}) => at[2]), lowest = Math.min(...heights);
  const near = placed.filter(({at}) => at[2] <= lowest + 1e-3 * (Math.max(...heights) - lowest));
  const corners = new Set();
  for (let i = 0; i < 16; ++i) {
    const along = ({at}) => at[0] * Math.cos(i * Math.PI / 8) + at[1] * Math.sin(i * Math.PI / 8);
    corners.add(near.reduce((best, next) => (along(next) > along(best) ? next : best)));
  }
  return [...corners].map(({point}) => point);
}

function addBalls(world, body, rigid) {
  const up = turned([body.rotation[0], ...body.rotation.slice(1).map((v) => -v)], [0, 0, BALL]);
  for (const corner of standingCorners(body)) {
    const ball = rapier.ColliderDesc.ball(BALL * UNIT);
    ball.setTranslation(...scaled(corner.map((value, k) => value + up[k])));
    addCollider(world, ball, body.friction, rigid);
  }
}

/** The deepest contact of the first step, which has moved things by less than a micrometre. */
function deepest(world) {
  let depth = 0;
  world.forEachCollider((a) => world.contactPairsWith(a, (b) => world.contactPair(a, b, (manifold) => {
    for (let i = 0; i < manifold.numContacts(); ++i) depth = Math.max(depth, -manifold.contactDist(i));
  })));
  return depth;
}

export function load(scene) {
  const world = new rapier.World({x: 0, y: 0, z: -UNIT * scene.gravity});
  world.timestep = 1 / 240;
  world.lengthUnit = UNIT / 10;  // household things
  world.integrationParameters.contact_natural_frequency = 120;  // of 30 Hz nuts in a basket sink and creep
  world.numSolverIterations = 8;
  if (scene.floor !== null)
    addCollider(world, rapier.ColliderDesc.cuboid(FLOOR * UNIT, FLOOR * UNIT, UNIT).setTranslation(0, 0, -UNIT), scene.floor);
  const bodies = new Map(scene.bodies.map((body) => [body.name, addBody(world, body)]));
  return {
    timestep: world.timestep,
    penetration: () => deepest(world) / UNIT,
    step: () => world.step(),
    pose(body) {
      const rigid = bodies.get(body.name), p = rigid.translation(), q = rigid.rotation();
      return {position: scaled([p.x, p.y, p.z], 1 / UNIT), rotation: [q.w, q.x, q.y, q.z]};
    },
    warnings: () => 0,
    free: () => world.free(),
  };
}
