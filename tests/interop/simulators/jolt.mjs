// Jolt: convex hulls by calls, in a compound of each body. Of two coefficients of friction the
// smaller one. The engine's lengths are for people and cars; household things ask for shorter ones.
// It leaves out corners beyond 256 of a hull (jolt_corners.mjs): such hulls come in pieces. Manifolds
// of the parts of two bodies are not merged, of which it would keep four points.
import fs from 'node:fs';
import {createRequire} from 'node:module';
import initJolt from 'jolt-physics';
import {hullPieces} from './hull_pieces.mjs';
import {turned} from './scene.mjs';

const jolt = await initJolt();
const require = createRequire(import.meta.url);
export const name = 'Jolt';
export const version = JSON.parse(fs.readFileSync(require.resolve('jolt-physics/package.json'))).version;

const STILL = 0, MOVING = 1;
const MOST_CORNERS = 256;  // of a hull
const VELOCITY_STEPS = 100, POSITION_STEPS = 4;  // of the defaults, 10 and 2, stacks creep and light things rattle
const STEP = 1e-3;  // seconds; of longer ones heavy things crush light ones that carry them (loads.mjs)
const UNIT = 100;  // per metre: the engine's tolerances are absolute
const vector = (p) => new jolt.Vec3(...p.map((value) => UNIT * value));
const placed = (p) => new jolt.RVec3(...p.map((value) => UNIT * value));
const quaternion = ([w, x, y, z]) => new jolt.Quat(x, y, z, w);

function layers() {
  const settings = new jolt.JoltSettings();
  const pairs = new jolt.ObjectLayerPairFilterTable(2);
  pairs.EnableCollision(STILL, MOVING);
  pairs.EnableCollision(MOVING, MOVING);
  const broad = new jolt.BroadPhaseLayerInterfaceTable(2, 2);
  for (const layer of [STILL, MOVING]) broad.MapObjectToBroadPhaseLayer(layer, new jolt.BroadPhaseLayer(layer));
  settings.mObjectLayerPairFilter = pairs;
  settings.mBroadPhaseLayerInterface = broad;
  settings.mObjectVsBroadPhaseLayerFilter = new jolt.ObjectVsBroadPhaseLayerFilterTable(broad, 2, pairs, 2);
  return settings;
}

/** Asks for the smaller friction, and keeps the deepest contact of the first step. */
function listen(system) {
  const seen = {deepest: 0};
  const listener = new jolt.ContactListenerJS();
  const settle = (a, b, manifold, settings) => {
    const first = jolt.wrapPointer(a, jolt.Body), second = jolt.wrapPointer(b, jolt.Body);
    jolt.wrapPointer(settings, jolt.ContactSettings).mCombinedFriction = Math.min(first.GetFriction(), second.GetFriction());
    seen.deepest = Math.max(seen.deepest, jolt.wrapPointer(manifold, jolt.ContactManifold).mPenetrationDepth / UNIT);
  };
  listener.OnContactValidate = () => jolt.ValidateResult_AcceptAllContactsForThisBodyPair;
  listener.OnContactAdded = settle;
  listener.OnContactPersisted = settle;
  listener.OnContactRemoved = () => {};
  system.SetContactListener(listener);
  return seen;
}

function setUp(system) {
  const settings = system.GetPhysicsSettings();
  settings.mPenetrationSlop = 1e-5 * UNIT;
  settings.mSpeculativeContactDistance = 5e-5 * UNIT;
  settings.mManifoldTolerance = 1e-5 * UNIT;
  settings.mPointVelocitySleepThreshold = 0.003 * UNIT;
  settings.mNumVelocitySteps = VELOCITY_STEPS;
  settings.mNumPositionSteps = POSITION_STEPS;
  system.SetPhysicsSettings(settings);
}

/** A hull with the least tolerance of 1 to 1,000 micrometres that the engine's builder takes. */
function hullShape(body, {points}) {
  const settings = new jolt.ConvexHullShapeSettings();
  for (const point of points) settings.mPoints.push_back(vector(point));
  settings.mMaxConvexRadius = 0;
  let made;
  for (const tolerance of [1e-6, 1e-5, 1e-4, 1e-3]) {
    settings.mHullTolerance = UNIT * tolerance;
    settings.ClearCachedResult();
    made = settings.Create();
    if (made.IsValid()) return made.Get();
  }
  throw new Error(`${body.name}: ${made.GetError().c_str()}`);
}

function bodyShape(body, corners) {
  const compound = new jolt.StaticCompoundShapeSettings();
  const [w, x, y, z] = body.rotation, down = turned([w, -x, -y, -z], [0, 0, -1]);
  for (const hull of body.hulls.flatMap((hull) => hullPieces(hull, down, corners)))
    compound.AddShapeShape(vector([0, 0, 0]), quaternion([1, 0, 0, 0]), hullShape(body, hull), 0);
  const made = compound.Create();
  if (made.HasError()) throw new Error(`${body.name}: ${made.GetError().c_str()}`);
  const inner = made.Get(), centre = inner.GetCenterOfMass();
  const offset = [centre.GetX(), centre.GetY(), centre.GetZ()].map((value, k) => body.centre[k] - value / UNIT);
  return new jolt.OffsetCenterOfMassShape(inner, vector(offset));
}

function setMass(settings, {mass, inertia: [xx, yy, zz, xy, xz, yz]}) {
  const properties = settings.mMassPropertiesOverride, matrix = new jolt.Mat44();
  [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]].forEach(
    (column, i) => matrix.SetColumn3(i, new jolt.Vec3(...column.map((value) => UNIT * UNIT * value))));
  matrix.SetColumn4(3, new jolt.Vec4(0, 0, 0, 1));
  settings.mOverrideMassProperties = jolt.EOverrideMassProperties_MassAndInertiaProvided;
  properties.mMass = mass;
  properties.mInertia = matrix;
}

function addBody(bodies, body, corners) {
  const settings = new jolt.BodyCreationSettings(bodyShape(body, corners), placed(body.position), quaternion(body.rotation),
    body.fixed ? jolt.EMotionType_Static : jolt.EMotionType_Dynamic, body.fixed ? STILL : MOVING);
  if (!body.fixed) setMass(settings, body);
  settings.mUseManifoldReduction = false;
  return add(bodies, settings, body.friction);
}

function add(bodies, settings, friction) {
  settings.mFriction = friction;
  const made = bodies.CreateBody(settings);
  bodies.AddBody(made.GetID(), jolt.EActivation_Activate);
  return made;
}

function addFloor(bodies, friction) {
  const box = new jolt.BoxShape(vector([50, 50, 1]), 0);
  add(bodies, new jolt.BodyCreationSettings(box, placed([0, 0, -1]), quaternion([1, 0, 0, 0]),
    jolt.EMotionType_Static, STILL), friction);
}

export function load(scene, _, corners = MOST_CORNERS) {
  const world = new jolt.JoltInterface(layers()), system = world.GetPhysicsSystem();
  const bodies = system.GetBodyInterface();
  system.SetGravity(vector([0, 0, -scene.gravity]));
  setUp(system);
  const seen = listen(system);
  if (scene.floor !== null) addFloor(bodies, scene.floor);
  const made = new Map(scene.bodies.map((body) => [body.name, addBody(bodies, body, corners)]));
  let first = 0, steps = 0;
  return {
    timestep: STEP,
    penetration: () => first,
    step() {
      world.Step(STEP, 1);
      if (++steps === 1) first = seen.deepest;
    },
    pose(body) {
      const p = made.get(body.name).GetPosition(), q = made.get(body.name).GetRotation();
      return {position: [p.GetX(), p.GetY(), p.GetZ()].map((value) => value / UNIT), rotation: [q.GetW(), q.GetX(), q.GetY(), q.GetZ()]};
    },
    warnings: () => 0,
    free: () => jolt.destroy(world),
  };
}
