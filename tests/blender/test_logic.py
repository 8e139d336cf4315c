"""Logic of the add-on that needs no Blender, with the module and with the program."""
import math
import os
import shutil
import tempfile
import threading
import unittest

import numpy as np

from trivet_addon import backends, bodies, layouts, program, work
from trivet_addon.bodies import (Body, Part, deviation, fault_of, is_sheared, motion_of, moved, part_of, translation,
                                 usual_clearance)
from trivet_addon.layouts import Settings, near, safe_names

TRIVET = os.environ.get("TRIVET_PROGRAM") or shutil.which("trivet")
CORNERS = np.array([[x, y, z] for x in (-.5, .5) for y in (-.5, .5) for z in (-.5, .5)], float)
FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6],
                  [0, 6, 4], [1, 5, 7], [1, 7, 3]], np.int32)


def box(name, at, size=(1, 1, 1), fixed=False, **more):
    at = np.array(at, float)
    return Body(name, [Part(CORNERS * size, FACES, at)], translation(at), fixed, **more)


def found(kind):
    return backends.find(kind, program=TRIVET)


def put(backend, bodies, movers, floor=True):
    settings = Settings(floor=floor)
    return work.Put(lambda bodies, out: backend.layout(bodies, out, settings), bodies, movers).run()


class Bodies(unittest.TestCase):
    def test_faces_below_a_mirrored_matrix_are_turned_round(self):
        def volume(part):
            a, b, c = (part.vertices[part.faces[:, k]] for k in range(3))
            return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)

        for scale, size in (((1, 2, 3), 6), ((-1, 2, 3), 6), ((-1, -2, 3), 6), ((-1, -2, -3), 6)):
            matrix = np.diag([*scale, 1.0])
            self.assertAlmostEqual(volume(part_of(CORNERS, FACES, matrix)), size)

    def test_parts_are_joined_where_they_are(self):
        a, b = part_of(CORNERS, FACES, translation((1, 2, 3))), part_of(CORNERS, FACES, translation((4, 0, 0)))
        body = Body("two", [a, b], translation((1, 2, 3)))
        vertices, faces = body.arrays()
        np.testing.assert_allclose(vertices + body.origin, body.world())
        self.assertEqual((faces.max(), len(faces), body.num_faces), (15, 24, 24))
        np.testing.assert_allclose(body.bounds(), [[.5, -.5, -.5], [4.5, 2.5, 3.5]])

    def test_motion_is_from_where_it_was_read(self):
        body = box("a", (1, 2, 3))
        pose = translation((5, 5, 5)) @ np.diag([-1.0, -1.0, 1.0, 1.0])
        np.testing.assert_allclose(moved(body.world(), motion_of(body, pose)), moved(body.arrays()[0], pose))
        there = box("a", (5, 5, 5))
        self.assertLess(deviation(body, translation((4, 3, 2)), there), 1e-12)
        self.assertEqual(deviation(body, np.eye(4), Body("b", [Part(CORNERS[:4], FACES[:1], np.zeros(3))])), float("inf"))

    def test_what_cannot_be_taken_is_named(self):
        self.assertEqual(fault_of(Body("none")), "has no surface")
        bad = CORNERS.copy()
        bad[3, 1] = np.nan
        self.assertIn("not finite", fault_of(Body("nan", [Part(bad, FACES, np.zeros(3))])))
        self.assertIsNone(fault_of(box("good", (0, 0, 0))))

    def test_shear_is_seen(self):
        turn = np.eye(4)
        turn[:2, :2] = [[0.6, -0.8], [0.8, 0.6]]
        scale = np.diag([1, 2, 0.5, 1.0])
        self.assertFalse(is_sheared(turn @ scale))
        self.assertTrue(is_sheared(scale @ turn))
        self.assertFalse(is_sheared(np.diag([0.0, 1, 1, 1])))

    def test_clearance_grows_with_extent_and_distance(self):
        self.assertEqual(usual_clearance([]), 0)
        self.assertAlmostEqual(usual_clearance([box("a", (0, 0, 0))]), 2.0 ** -20 * 3 ** 0.5)
        self.assertAlmostEqual(usual_clearance([box("a", (100, 0, 0))]), 2.0 ** -20 * 100.5)


class Angles(unittest.TestCase):
    def test_near_lock_give_the_rotation_back(self):
        random = np.random.default_rng(1)
        for order in ("XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"):
            for off in (0.0, 1e-9, 1e-6, -3e-5, 1e-3, .1):
                for noise in (0.0, 1e-7):  # of float32
                    angles = [0.7, random.choice([-1, 1]) * math.pi / 2 + off, -2.1]
                    rotation = self.composed(order, angles) + noise * random.uniform(-1, 1, (3, 3))
                    found = bodies.angles_near_lock(rotation, order)
                    again = self.composed(order, [found["XYZ".index(name)] for name in order])
                    self.assertLess(np.abs(again - rotation).max(), 1e-9 + 4 * noise, (order, off, noise))
        self.assertIsNone(bodies.angles_near_lock(np.eye(3), "XYZ"))
        self.assertIsNone(bodies.angles_near_lock(bodies.rotation_about(1, math.pi / 2), "QUATERNION"))

    @staticmethod
    def composed(order, angles):
        out = np.eye(3)
        for name, angle in zip(order, angles):
            out = bodies.rotation_about("XYZ".index(name), angle) @ out
        return out


class Names(unittest.TestCase):
    def test_are_unique_and_not_the_floor(self):
        names = ["floor", "floor (2)", "cup", "cu\np", "cu\tp", "", "Würfel", layouts.UNITED]
        safe = safe_names(names)
        self.assertEqual(len(set(safe.values())), len(names))
        self.assertNotIn("floor", safe.values())
        self.assertEqual((safe["cup"], safe["Würfel"]), ("cup", "Würfel"))
        self.assertTrue(all(value.isprintable() and value for value in safe.values()))

    def test_near_ones_are_those_whose_boxes_overlap(self):
        random = np.random.default_rng(5)
        for _ in range(50):
            bodies = [box(str(k), random.uniform(-2, 2, 3), random.uniform(.1, 1.5, 3)) for k in range(12)]
            about = {"0", "7"}
            got = {body.name for body in near(bodies, about)}
            for body in bodies:
                low, high = body.bounds()
                meets = any((low <= other.bounds()[1]).all() and (other.bounds()[0] <= high).all()
                            for other in bodies if other.name in about)
                self.assertEqual(body.name in got, meets)


class Mends(unittest.TestCase):
    def test_both_backends_part_two_and_leave_the_third(self):
        for kind in ("MODULE", "PROGRAM"):
            with self.subTest(kind=kind):
                given = [box("a", (0, 0, .5)), box("b", (.999, 0, .503)), box("c", (5, 0, .5 + 1e-6))]
                settings = Settings(clearance=1e-5)
                report = work.Mend(lambda bodies, out: found(kind).layout(bodies, out, settings), given, ["a", "b"]).run()
                self.assertEqual((sorted(report.motions), report.refused), (["a", "b"], {}))
                apart = moved(given[1].bounds(), report.motions["b"])[0, 0] - moved(given[0].bounds(), report.motions["a"])[1, 0]
                self.assertTrue(0 < apart < 1e-3, apart)
                self.assertLess(moved(given[1].bounds(), report.motions["b"])[0, 2], 1e-4)
                self.assertTrue(report.verdict.stands)

    def test_what_has_no_place_is_refused(self):
        for kind in ("MODULE", "PROGRAM"):
            with self.subTest(kind=kind):
                given = [box("rock", (0, 0, 2), (4, 4, 4), fixed=True), box("coin", (0, 0, 2), (.1, .1, .02))]
                report = work.Mend(lambda bodies, out: found(kind).layout(bodies, out, Settings()), given, ["coin"]).run()
                self.assertEqual((report.motions, list(report.refused)), ({}, ["coin"]))


class Stuck(unittest.TestCase):
    def test_is_what_hangs_together_with_what_stays(self):
        pairs = [("a", "wall"), ("b", "a"), ("c", "d"), ("wall", "floor tile"), ("e", "b")]
        out = work.stuck_from_the_start(pairs, ["a", "b", "c", "d", "e", "f"])
        self.assertEqual({name: one.objects for name, one in out.items()},
                         {"a": ("a", "wall"), "b": ("b", "a"), "e": ("e", "b")})
        self.assertEqual(work.stuck_from_the_start([], ["a"]), {})

    def test_is_what_beginning_again_finds(self):
        random = np.random.default_rng(2)
        stuck_ones = 0
        for _ in range(20):
            bodies = [box("wall", (0, 0, 1), (.3, 6, 2), fixed=True),
                      *(box(str(k), [*random.uniform(-1.2, 1.2, 2), random.uniform(.6, 3)], (.5,) * 3) for k in range(6))]
            movers = [body.name for body in bodies[1:]]
            backend = found("MODULE")
            make = lambda bodies, out: backend.layout(bodies, out, Settings())
            slow = work.Put(make, bodies, movers).run()
            fast = work.Put(make, bodies, movers, crossings=lambda: backend.crossings(bodies, movers)).run()
            stuck = work.stuck_from_the_start(backend.crossings(bodies, movers), movers)
            stuck_ones += len(stuck)
            self.assertLessEqual(set(stuck), set(fast.refused))
            for report in (slow, fast):
                shown = [replace_at(body, report.motions.get(body.name, np.eye(4))) for body in bodies]
                self.assertEqual([p for p in backend.crossings(shown, report.done) if set(p) & set(report.done)], [])
                self.assertEqual(sorted([*report.done, *report.refused]), movers)
        self.assertGreater(stuck_ones, 10)


class Backends(unittest.TestCase):
    def test_say_which_and_why(self):
        module = found("AUTO")
        self.assertEqual((module.kind, module.note), ("MODULE", ""))
        self.assertIn("Python module", module.text)
        piped = found("PROGRAM")
        self.assertEqual(piped.version, module.version)
        self.assertIn("over a pipe", piped.text)
        missing = backends.find("AUTO", folder="/nonexistent", program=TRIVET)
        self.assertEqual(missing.kind, "PROGRAM")
        self.assertIn("/nonexistent: there is no package `trivet`", missing.note)
        with self.assertRaisesRegex(backends.NoBackend, "no package `trivet`.*the program /nowhere is missing"):
            backends.find("AUTO", folder="/nonexistent", program="/nowhere")
        with self.assertRaisesRegex(backends.NoBackend, "does not load"):
            backends.find("MODULE", folder="/nonexistent", program=TRIVET)

    def test_programs_that_are_others_are_refused_by_name(self):
        with tempfile.TemporaryDirectory() as folder:
            other, broken = os.path.join(folder, "other"), os.path.join(folder, "broken")
            for path, text in ((other, "#!/bin/sh\necho 'other thing 1.0'\n"), (broken, "no program")):
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
                os.chmod(path, 0o755)
            with self.assertRaisesRegex(backends.NoBackend, "other is not the program trivet"):
                backends.find("PROGRAM", program=other)
            with self.assertRaisesRegex(backends.NoBackend, "broken does not run"):
                backends.find("PROGRAM", program=broken)


class BothBackends:
    """Tests that must hold with either backend."""

    kind = ""

    def setUp(self):
        self.backend = found(self.kind)

    def test_boxes_fall_onto_each_other_the_lowest_first(self):
        bodies = [box("table", (0, 0, .5), (4, 4, 1), fixed=True), box("b", (0, 0, 6)), box("a", (0.1, 0, 4))]
        report = put(self.backend, bodies, ["a", "b"])
        self.assertEqual((report.done, report.refused, report.gave_way), (["a", "b"], {}, []))
        self.assertEqual(set(report.motions), {"a", "b"})
        for name, height in (("a", -2.5), ("b", -3.5)):
            np.testing.assert_allclose(report.motions[name], translation((0, 0, height)), atol=2e-5)
        self.assertTrue(report.verdict.stands)
        self.assertEqual(report.statuses["a"].state, "stable")
        self.assertEqual((report.statuses["a"].supports, report.statuses["a"].loads), (("table",), ("b",)))

    def test_refused_ones_stay_and_are_in_the_way(self):
        bodies = [box("wall", (0, 0, 1), (.2, 4, 2), fixed=True), box("stuck", (0.3, 0, 1.2)), box("over", (0.6, 0, 3)),
                  box("free", (3, 0, 2))]
        report = put(self.backend, bodies, ["stuck", "over", "free"])
        self.assertEqual(list(report.refused), ["stuck"])
        self.assertEqual((report.refused["stuck"].code, report.refused["stuck"].objects), ("crossing", ("stuck", "wall")))
        self.assertEqual(report.done, ["free", "over"])
        shown = [replace_at(body, report.motions.get(body.name, np.eye(4))) for body in bodies]
        self.assertEqual(self.backend.crossings(shown, ["over", "free"]), [])
        self.assertEqual(len(self.backend.crossings(shown, ["stuck"])), 1)

    def test_obstacles_may_interpenetrate(self):
        bodies = [box("a", (0, 0, .5), (2, 2, 1), fixed=True), box("b", (.5, 0, .6), (2, 2, 1), fixed=True), box("c", (.2, 0, 3))]
        report = put(self.backend, bodies, ["c"])
        self.assertEqual(report.done, ["c"])
        np.testing.assert_allclose(report.motions["c"], translation((0, 0, -1.4)), atol=2e-5)

    def test_what_was_free_gives_way_and_is_told(self):
        plank = box("plank", (0, 0, 1.05 + 3e-6), (4, .5, .1))
        bodies = [box("post", (0, 0, .5), (1, 1, 1), fixed=True), plank, box("weight", (1.5, 0, 3), density=5000.0)]
        report = put(self.backend, bodies, ["weight"])
        self.assertEqual((report.done, report.refused, report.gave_way), (["weight"], {}, ["plank"]))
        self.assertEqual(set(report.motions), {"plank", "weight"})
        self.assertTrue(report.verdict.stands)

    def test_judges_bodies_where_they_are(self):
        bodies = [box("a", (0, 0, .5), fixed=True), box("b", (.3, 0, .7), fixed=True), box("air", (4, 0, 3)),
                  box("down", (8, 0, .5 + 1e-6))]
        verdict, statuses = self.backend.judge(bodies, Settings())
        self.assertEqual([tuple(sorted(pair)) for pair in verdict.crossings], [("a", "b")])
        self.assertEqual((verdict.not_at_rest, verdict.topples, verdict.stands), (("air",), ("air",), False))
        self.assertEqual((statuses["down"].state, statuses["down"].supports), ("stable", ("floor",)))

    def test_stops_when_told_and_reports_progress(self):
        bodies = [box(str(k), (0, 0, 2 * k + 1)) for k in range(30)]
        errors, reached, stopped = [], threading.Event(), threading.Event()

        def put(layout, body):
            if job.progress.done == 3:
                reached.set()
                stopped.wait(20)
            return layout.perform(work.put_operation(body))

        job = work.Put(lambda bodies, out: self.backend.layout(bodies, out, Settings()), bodies, [b.name for b in bodies],
                       put)

        def run():
            try:
                job.run()
            except work.Stopped as error:
                errors.append(error)

        thread = threading.Thread(target=run)
        thread.start()
        self.assertTrue(reached.wait(20))
        job.progress.stop()
        stopped.set()
        thread.join(20)
        self.assertFalse(thread.is_alive())
        self.assertEqual(len(errors), 1)
        self.assertEqual(job.progress.total, 30)


def replace_at(body, motion):
    return Body(body.name, [Part(moved(body.world(), motion), body.arrays()[1], np.zeros(3))], np.eye(4))


class ByModule(BothBackends, unittest.TestCase):
    kind = "MODULE"


class ByProgram(BothBackends, unittest.TestCase):
    kind = "PROGRAM"

    def test_a_program_that_ends_says_why(self):
        bodies = [box("a", (0, 0, .5))]
        with self.assertRaisesRegex(program.ProgramError, "clearance"):
            self.backend.layout(bodies, [], Settings(clearance=-1.0))

    def test_models_are_read_as_they_were_written(self):
        import trivet

        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.ply")
            points = np.random.default_rng(1).normal(size=(8, 3))
            program.write_ply(path, points, FACES)
            shape = trivet.Shape.load(path)
        np.testing.assert_array_equal(shape.vertices[shape.faces], points.astype(np.float32)[FACES])


if __name__ == "__main__":
    unittest.main()
