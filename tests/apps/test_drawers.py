"""Random sequences of open, put, push and close on three cabinets: every state is true, by Trivet's check and by the referee of
../shared (links are fixed objects there; gaps of 2 mm keep them off their frames, so that no pair is left out). Once in scenes of
another program, once in layouts of Trivet's own, in which a cabinet is placed, turned and off the origin.

TRIVET_SEQUENCES: how many sequences, 9 by default; docs/measurements/scenes-of-others.md has the figures of 100."""
import json
import os
import random
import subprocess
import unittest

from live_session import Live
from program import Case, main

REFEREE = os.environ.get("TRIVET_REFEREE", "")
SEQUENCES = int(os.environ.get("TRIVET_SEQUENCES", "9"))
STEPS = 10
CLEARANCE = ("--clearance", "2e-6")  # the same for all states: by default it goes with the size of the scene
SIDES = ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6))


class Body:
    def __init__(self, name, at, boxes, joint="", inner=(), free=False):
        self.name, self.at, self.boxes, self.joint, self.inner, self.free = name, at, boxes, joint, inner, free

    def mjcf(self):
        geoms = "".join('<geom type="box" pos="%g %g %g" size="%g %g %g"/>' % box for box in self.boxes)
        return '<body name="%s" pos="%g %g %g">%s%s%s</body>\n' % (
            self.name, *self.at, "<freejoint/>" if self.free else self.joint, geoms, "".join(one.mjcf() for one in self.inner))

    def obj(self):
        lines, first = [], 1
        for x, y, z, a, b, c in self.boxes:
            for i in range(8):
                lines.append("v %r %r %r\n" % (x + (a if i & 1 else -a), y + (b if i & 2 else -b), z + (c if i & 4 else -c)))
            for s in SIDES:
                lines.append("f %d %d %d\nf %d %d %d\n" % tuple(first + v for v in (s[0], s[1], s[2], s[0], s[2], s[3])))
            first += 8
        return "".join(lines)

    def all(self):
        return [self, *(one for inner in self.inner for one in inner.all())]


def slide(name):
    return '<joint name="%s" type="slide" axis="0 -1 0" range="0 0.3"/>' % name


def hinge(name, axis):
    return '<joint name="%s" type="hinge" axis="%s" range="0 1.6"/>' % (name, axis)


def tray(name, z, width=0.18, depth=0.17):
    """Open above; its front stands at the front of a frame."""
    return Body(name, (0, 0, z), [(0, 0, 0, width, depth, 0.004), (0, -depth - 0.006, 0.03, width, 0.005, 0.034),
                                  (0, depth - 0.004, 0.024, width, 0.003, 0.018),
                                  (width - 0.004, 0, 0.024, 0.003, depth - 0.01, 0.018),
                                  (-width + 0.004, 0, 0.024, 0.003, depth - 0.01, 0.018)], slide(name))


def frame(name, height, inner):
    """Sides, back and bottom, 0.4 x 0.4 m, with its bottom on the floor."""
    half = height / 2
    return Body(name, (0, 0, half + 1e-4),
                [(0.195, 0, 0, 0.01, 0.19, half), (-0.195, 0, 0, 0.01, 0.19, half), (0, 0.19, 0, 0.18, 0.008, half),
                 (0, 0, 0.01 - half, 0.18, 0.17, 0.01)], inner=inner)


def top(z):
    return (0, 0, z, 0.2, 0.19, 0.008)


def chest():
    body = frame("chest", 0.5, [tray("low", -0.2), tray("middle", -0.06), tray("high", 0.08)])
    body.boxes.append(top(0.262))
    return body


def unit():
    lid = Body("lid", (0, 0.19, 0.212), [(0, -0.19, 0, 0.2, 0.188, 0.008)], hinge("lid", "-1 0 0"))
    return frame("unit", 0.4, [tray("drawer", 0.06), lid])


def wardrobe():
    left = Body("left door", (-0.2, -0.21, 0), [(0.098, 0, 0, 0.097, 0.008, 0.28)], hinge("left door", "0 0 -1"))
    right = Body("right door", (0.2, -0.21, 0), [(-0.098, 0, 0, 0.097, 0.008, 0.28)], hinge("right door", "0 0 1"))
    body = frame("wardrobe", 0.6, [tray("inside", -0.1, 0.17, 0.15), left, right])
    body.boxes.append(top(0.312))
    return body


class Cabinet:
    start = "cabinet.xml"

    def __init__(self, body):
        things = [Body("thing %d" % i, (0.5 + 0.15 * i, 0.3, size + 1e-4), [(0, 0, 0, size, 1.3 * size, size)], free=True)
                  for i, size in enumerate((0.02, 0.025, 0.03, 0.035))]
        self.bodies = body.all() + things
        self.things = [one.name for one in things]
        self.files = {"cabinet.xml": self.text_of(body, things)}

    @staticmethod
    def text_of(body, things):
        return ('<mujoco><compiler angle="radian" autolimits="true"/><worldbody><geom type="plane" size="3 3 .1"/>\n' +
                body.mjcf() + "".join(one.mjcf() for one in things) + "</worldbody></mujoco>\n")


class PlacedCabinet(Cabinet):
    """In a layout; its objects are the cabinet's bodies, called cabinet/NAME."""
    start = "kitchen.json"

    def __init__(self, body):
        super().__init__(body)
        things = [one for one in self.bodies if one.free]
        objects = [{"name": "cabinet", "articulation": "cabinet.xml", "position": [0.1, 0, 0], "rotation": [1, 0, 0, 0.05]}]
        for one in things:
            objects.append({"name": one.name, "model": one.name + ".obj", "position": [one.at[0] + 0.2, *one.at[1:]]})
        self.files = {"cabinet.xml": self.text_of(body, []), "kitchen.json": json.dumps({"trivet": 1, "objects": objects})}


class Drawers(Case):
    cabinet, extension, moved = Cabinet, ".xml", ("ok",)

    def setUp(self):
        super().setUp()
        self.counts = dict.fromkeys(("states", "opened", "blocked", "put", "pushed", "refused", "settled", "undone"), 0)

    def judged(self, live, bodies):
        """True by Trivet; and by the referee, on shapes written here."""
        verdict = live.ask(query="check")
        if not verdict["ok"]:
            return verdict["findings"]
        objects = []
        for one in live.ask(query="objects")["objects"]:
            (x, y, z), (w, a, b, c) = one["position"], one["rotation"]
            matrix = [1 - 2 * (b * b + c * c), 2 * (a * b - w * c), 2 * (a * c + w * b), x,
                      2 * (a * b + w * c), 1 - 2 * (a * a + c * c), 2 * (b * c - w * a), y,
                      2 * (a * c - w * b), 2 * (b * c + w * a), 1 - 2 * (a * a + b * b), z, 0, 0, 0, 1]
            name = one["object"].split("/")[-1]
            objects.append({"name": name, "model": name + ".obj", "state": one["state"], "world_from_file": matrix})
        self.assertEqual({one["name"] for one in objects}, {one.name for one in bodies})
        self.counts["states"] += 1
        if os.path.exists(REFEREE):
            self.write("state.json", json.dumps({"objects": objects}))
            done = subprocess.run([REFEREE, "state.json"], cwd=self.folder, capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return []

    def step(self, live, generator, cabinet, joints):
        """One random step. @return its answer."""
        kind = generator.choice(("open", "close", "put", "put", "push"))
        thing = generator.choice(cabinet.things)
        if kind in ("open", "close"):
            to = generator.choice(("upper", generator.uniform(0.1, 0.3))) if kind == "open" else "lower"
            answer = live.ask(move_joint=generator.choice(joints), to=to)
            self.assertIn(answer["status"], self.moved, answer)
            refused = answer["status"] == "refused"
            self.counts["refused" if refused else "blocked" if answer["end"] == "blocked" else "opened"] += 1
            return answer
        if kind == "put":
            answer = live.ask(op="put", object=thing, position=[generator.uniform(-0.2, 0.2), generator.uniform(-0.5, 0.2), 1])
        else:
            answer = live.ask(op="push", object=thing, direction=[generator.uniform(-1, 1), generator.uniform(-1, 1)],
                              distance=0.05)
        self.assertIn(answer["status"], ("ok", "refused"), answer)
        self.counts["refused" if answer["status"] == "refused" else "put" if kind == "put" else "pushed"] += 1
        return answer

    def sequence(self, cabinet, seed):
        generator = random.Random(seed)
        live = Live(self.folder, cabinet.start, *CLEARANCE)
        joints = [joint["joint"] for joint in live.ask(query="joints")["joints"]]
        live.ask(settle=True)
        self.assertEqual(self.judged(live, cabinet.bodies), [])
        for _ in range(STEPS):
            before = live.ask(query="objects")["done"]
            if self.step(live, generator, cabinet, joints)["status"] != "ok":
                continue
            if self.judged(live, cabinet.bodies):  # it took away what something lay on
                live.ask(settle=True)
                self.counts["settled"] += 1
                if self.judged(live, cabinet.bodies):
                    while live.ask(query="objects")["done"] > before:
                        live.ask(undo=True)
                    self.counts["undone"] += 1
                    self.assertEqual(self.judged(live, cabinet.bodies), [])
        saved = "out %d%s" % (seed, self.extension)
        live.ask(save=saved)
        self.assertEqual(live.end(), 0)
        self.trivet("check", saved, *CLEARANCE)

    def test_every_state_is_true(self):
        for number, body in enumerate((chest(), unit(), wardrobe())):
            cabinet = self.cabinet(body)
            for name, text in cabinet.files.items():
                self.write(name, text)
            for one in cabinet.bodies:
                self.write(one.name + ".obj", one.obj())
            for seed in range(number, SEQUENCES, 3):
                with self.subTest(cabinet=body.name, seed=seed):
                    self.sequence(cabinet, seed)
        print(json.dumps({"sequences": SEQUENCES, **self.counts, "referee": os.path.exists(REFEREE)}))
        self.assertGreater(self.counts["states"], 3 * SEQUENCES)
        self.assertGreater(self.counts["opened"], SEQUENCES)
        self.assertGreater(self.counts["put"], SEQUENCES)

    @unittest.skipUnless(os.path.exists(REFEREE), "no referee: nobody else judged the states (../shared/tools/referee)")
    def test_the_referee_was_there(self):
        """Skips visibly where it was not."""


class DrawersOfLayouts(Drawers):
    """Moves of joints are operations there: one that leaves the whole without balance is refused, and nothing has to be settled."""
    cabinet, extension, moved = PlacedCabinet, ".glb", ("ok", "refused")

    def sequence(self, cabinet, seed):
        super().sequence(cabinet, seed)
        self.assertEqual(self.counts["settled"], 0)


if __name__ == "__main__":
    main()
