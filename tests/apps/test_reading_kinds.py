"""Kinds of faults that people report of readers, and forms of each: every one means what its author meant."""
import json
import os
import subprocess
from concurrent.futures import ThreadPoolExecutor

from program import PROGRAM, Case, main
import reading_forms
import reading_more_forms


class Kinds(Case):
    def outcome(self, numbered):
        """The failure of a form in a folder of its own; None: it is read as it should be."""
        number, form = numbered
        try:
            self.check(form, str(number) + "/")
        except AssertionError as error:
            return error
        return None

    def info(self, path):
        done = subprocess.run([PROGRAM, "info", path, "--json"], cwd=self.folder, capture_output=True, text=True, timeout=300)
        return done.returncode, json.loads(done.stdout)

    def check(self, form, folder):
        for name, content in [(form["file"], form["content"]), *form["others"].items()]:
            self.write(folder + name, content)
        status, info = self.info(folder + form["file"])
        if "refused" in form:
            self.assertEqual(status, 2)
            for says in (form["file"], *form["refused"]):
                self.assertIn(says, json.dumps(info, ensure_ascii=False))
            return
        self.assertEqual(status, 0, info)
        notes = "\n".join(info["notes"])
        for says in form["says"]:
            self.assertIn(says, notes)
        solid, within = form["solid"], form["within"]
        if solid:
            size = max(max(abs(p[k]) for p in solid.positions) for k in range(3))
            width = max(max(p[k] for p in solid.positions) - min(p[k] for p in solid.positions) for k in range(3))
            self.assertLess(abs(info["volume"] / solid.volume - 1), within, (info["volume"], solid.volume))
            self.assertLess(abs(info["area"] / solid.area - 1), within, (info["area"], solid.area))
            self.assertTrue(info["closed"])
            centre = info["centre"]
            if form["also"].get("moved"):
                centre = solid.centre
            for a, b in zip(centre, solid.centre):
                self.assertLess(abs(a - b), max(within * width, 1e-15 * size), (info["centre"], solid.centre))
        for key, expected in form["also"].items():
            if key == "images":
                self.assertEqual(len(info["images"]), expected, info["notes"])
            elif isinstance(expected, float):
                self.assertAlmostEqual(info[key], expected, 12)
            elif key != "moved":
                self.assertEqual(info[key], expected, key)


def add_tests():
    for kind in reading_forms.KINDS + reading_more_forms.KINDS:
        def test(self, kind=kind):
            forms = list(kind())
            self.assertGreaterEqual(len(forms), 4)
            with ThreadPoolExecutor(os.cpu_count()) as pool:
                outcomes = list(pool.map(self.outcome, enumerate(forms)))
            for number, (form, outcome) in enumerate(zip(forms, outcomes)):
                with self.subTest(kind.__name__, number=number, file=form["file"]):
                    if outcome:
                        raise outcome
        setattr(Kinds, "test_" + kind.__name__, test)


add_tests()

if __name__ == "__main__":
    main()
