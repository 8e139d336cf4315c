"""Common part of the end-to-end tests: the program, a folder per test, models and layouts."""
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.environ.get("TRIVET_PROGRAM", "trivet")
SOURCE_DIR = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# A decorator for tests of bounds on memory, of which sanitizers reserve terabytes.
needs_memory_bounds = unittest.skipIf(os.environ.get("TRIVET_SANITIZE"), "sanitizers reserve terabytes")
SKIPPED = 77  # exit status that CTest reports as "skipped"

SIDES = ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6))


def box_obj(x, y, z):
    """OBJ text of a closed box of these half extents about the origin."""
    corners = [(x if i & 1 else -x, y if i & 2 else -y, z if i & 4 else -z) for i in range(8)]
    faces = [(s[0], s[1], s[2]) for s in SIDES] + [(s[0], s[2], s[3]) for s in SIDES]
    return "".join("v %r %r %r\n" % c for c in corners) + \
        "".join("f %d %d %d\n" % tuple(v + 1 for v in f) for f in faces)


def grid_obj(cells):
    """OBJ text of a flat square of 2 x cells x cells triangles at z = 0."""
    n = cells + 1
    lines = ["v %.6f %.6f 0\n" % (i / cells, j / cells) for j in range(n) for i in range(n)]
    for j in range(cells):
        for i in range(cells):
            a = j * n + i + 1
            lines.append("f %d %d %d\nf %d %d %d\n" % (a, a + 1, a + n + 1, a, a + n + 1, a + n))
    return "".join(lines)


class Case(unittest.TestCase):
    """A test with a folder of its own as working directory."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="trivet_test_")
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.write("cube.obj", box_obj(0.05, 0.05, 0.05))
        self.write("slab.obj", box_obj(0.5, 0.5, 0.05))

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return name

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def read_json(self, name):
        return json.loads(self.read(name))

    def files(self):
        return sorted(os.path.relpath(os.path.join(folder, name), self.folder)
                      for folder, _, names in os.walk(self.folder) for name in names)

    def trivet(self, *arguments, status=0, env=None):
        """Runs the program and checks its exit status, one or several. Returns (stdout,
        stderr)."""
        result = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, timeout=300,
                                stdin=subprocess.DEVNULL, capture_output=True,
                                env={**os.environ, **(env or {})})
        out, err = result.stdout.decode(), result.stderr.decode()
        accepted = status if isinstance(status, tuple) else (status,)
        self.assertIn(result.returncode, accepted,
                      " ".join(map(str, arguments)) + "\n" + out + err)
        return out, err

    def refused(self, *arguments, says, status=2):
        """Expects this exit status, a message with these parts, and no new
        file."""
        before = {name: self.read(name) for name in self.files()}
        out, err = self.trivet(*arguments, status=status)
        self.assertEqual(out, "")
        self.assertTrue(err.startswith("trivet: "), err)
        self.assertEqual(err.count("\n"), 1, err)
        for part in [says] if isinstance(says, str) else says:
            self.assertIn(part, err)
        self.assertEqual({name: self.read(name) for name in self.files()}, before)
        return err

    def importer(self, script):
        """Variables by which a script of the shell takes the importer's place."""
        self.write("importer", "#!/bin/sh\n" + script + "\n")
        os.chmod(self.path("importer"), 0o755)
        return {"TRIVET_IMPORTER": self.path("importer")}

    def layout(self, objects, operations=(), name="layout.json", **more):
        """Writes a layout and returns its name."""
        return self.write(name, json.dumps({"trivet": 1, **more, "objects": objects,
                                            "operations": list(operations)}))

    def two_cubes(self):
        return self.layout([SLAB, {"name": "a", "model": "cube.obj"},
                            {"name": "b", "model": "cube.obj"}],
                           [put("a", 0, 0, 1), put("b", 0.01, 0.02, 1, [3, 1, 0, 2])])


SLAB = {"name": "slab", "model": "slab.obj", "fixed": True, "position": [0, 0, 0.050001]}


def put(name, x, y, z, rotation=(1, 0, 0, 0)):
    return {"op": "put", "object": name, "position": [x, y, z], "rotation": list(rotation)}


def without_times(report):
    """The report's text without the lines that may differ between two runs."""
    return b"\n".join(line for line in report.split(b"\n") if b'"milliseconds"' not in line)


def random_bytes(count, seed=1):
    return random.Random(seed).randbytes(count)


def main():
    """unittest.main, but reports a fully skipped run to CTest."""
    program = unittest.main(exit=False, verbosity=2)
    result = program.result
    if not result.wasSuccessful():
        sys.exit(1)
    sys.exit(SKIPPED if result.testsRun > 0 and len(result.skipped) == result.testsRun else 0)
