"""Untrusted files: no crash of the program, no hang, a clear message.

The second part reads every file of Debian's assimp-testmodels, broken ones included; set
TRIVET_ASSIMP_MODELS to another folder to do it there."""
import json
import os
import resource
import subprocess
import time
import unittest
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

from program import PROGRAM, SLAB, Case, main, put, needs_memory_bounds

MODELS = os.environ.get("TRIVET_ASSIMP_MODELS", "/usr/share/assimp/models")
SECONDS = 20
MEMORY_MB = 2000


class Importer(Case):
    """Misbehaviour of the importer process, simulated by a script in its place."""

    def info_fails(self, script, *says, status=2):
        env = self.importer(script)
        out, err = self.trivet("info", "cube.obj", "--import-seconds", "1", status=status, env=env)
        self.assertEqual(out, "")
        self.assertEqual(err.count("\n"), 1, err)
        for part in ("trivet: ", *says):
            self.assertIn(part, err)

    def test_crash(self):
        self.info_fails("kill -SEGV $$", "cube.obj", "Segmentation fault")

    def test_abort(self):
        self.info_fails("kill -ABRT $$", "cube.obj", "Aborted")

    def test_status(self):
        self.info_fails("exit 5", "cube.obj", "status 5")

    def test_hang(self):
        begin = time.monotonic()
        self.info_fails("exec sleep 100", "cube.obj", "longer than the limit of 1 s")
        self.assertLess(time.monotonic() - begin, 20)

    def test_nonsense(self):
        self.info_fails("echo nonsense >&3", "cube.obj", "incomplete")
        self.info_fails("true", "cube.obj", "incomplete")
        self.info_fails("printf 'TRIVET-MODEL-1\\n\\000aaaaaaaaaaaaaaaaaaaaaaaa' >&3", "incomplete")

    def test_endless_answer(self):
        self.info_fails("exec cat /dev/zero >&3", "cube.obj", "limit")

    def test_missing_importer(self):
        out, err = self.trivet("info", "cube.obj", status=3, env={"TRIVET_IMPORTER": "/nowhere/x"})
        self.assertIn("cannot be started", err)

    def test_without_open_cascade(self):
        env = self.importer("exit 0")  # no "importer-cad" beside it
        for name, kind in (("a.step", "STEP"), ("b.IGS", "IGES"), ("c.brep", "BREP")):
            self.write(name, "something\n")
            out, err = self.trivet("info", name, status=3, env=env)
            for part in (name, kind + " files need", "importer-cad", "lacks Open CASCADE",
                         "libocct-data-exchange-dev", "TRIVET_OCCT"):
                self.assertIn(part, err)

    def test_in_process(self):
        env = self.importer("kill -SEGV $$")
        self.trivet("info", "cube.obj", "--import-in-process", env=env)

    def test_same_answer_in_both_processes(self):
        isolated, _ = self.trivet("info", "cube.obj", "--json")
        in_process, _ = self.trivet("info", "cube.obj", "--json", "--import-in-process")
        self.assertEqual(isolated, in_process)

    def test_a_missing_sandbox_is_noted_once(self):
        env = {**self.importer('"$REAL" "$@" 3>&1 | (dd bs=1 count=18; dd bs=1 count=1 of=/dev/null; '
                               'printf "\\000"; cat) 2>/dev/null >&3'),
               "REAL": os.path.join(os.path.dirname(PROGRAM), "trivet-import")}
        out, err = self.trivet("info", "cube.obj", env=env)
        self.assertEqual(out, self.trivet("info", "cube.obj")[0])
        self.assertEqual(err.count("\n"), 1, err)
        self.assertIn("without Landlock (Linux 5.13 or later) and seccomp", err)
        self.assertEqual(self.trivet("info", "cube.obj", "--quiet", env=env)[1], "")

    def test_reports_tell_what_confined_the_importer(self):
        layout = self.layout([SLAB, {"name": "a", "model": "cube.obj"}], [put("a", 0, 0, 1)])
        self.trivet("run", layout, "-o", "s.glb", "--report", "r.json")
        told = self.read_json("r.json")["importer"]
        self.assertEqual(sorted(told["sandbox"] + told["lacking"]),
                         ["landlock", "mounts", "network", "privileges", "seccomp"])
        self.trivet("run", layout, "-o", "s.glb", "--report", "none.json", "--import-in-process")
        self.assertNotIn("importer", self.read_json("none.json"))

    def test_a_layout_names_the_model(self):
        layout = self.layout([{"name": "bad", "model": "cube.obj"}])
        out, err = self.trivet("run", layout, "-o", "s.glb", status=2,
                               env=self.importer("kill -SEGV $$"))
        self.assertIn("/objects/0/model: cube.obj: ", err)
        self.assertNotIn("s.glb", self.files())

    @needs_memory_bounds
    def test_several_models_share_an_importer(self):
        self.write("big.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n" * 1000000)
        good = self.layout([SLAB, {"name": "a", "model": "cube.obj"}], [put("a", 0, 0, 1)])
        bad = self.layout([SLAB, {"name": "a", "model": "cube.obj"}, {"name": "big", "model": "big.obj"}],
                          name="bad.json")
        env = {**self.importer('echo start >> "$STARTS"; exec "$REAL" "$@"'),
               "STARTS": self.path("starts"),
               "REAL": os.path.join(os.path.dirname(PROGRAM), "trivet-import")}
        self.trivet("run", good, "-o", "shared.glb", "--threads", "1", env=env)
        with open(self.path("starts")) as starts:
            self.assertEqual(starts.read(), "start\n")
        self.trivet("run", good, "-o", "here.glb", "--threads", "1", "--import-in-process")
        with open(self.path("shared.glb"), "rb") as shared, open(self.path("here.glb"), "rb") as here:
            self.assertEqual(shared.read(), here.read())
        out, err = self.trivet("run", bad, "-o", "s.glb", "--import-memory-mb", "150", status=2, env=env)
        self.assertIn("/objects/2/model: big.obj: ", err)
        self.assertIn("memory", err)

    @needs_memory_bounds
    def test_memory(self):
        self.write("big.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n" * 1000000)
        out, err = self.trivet("info", "big.obj", "--import-memory-mb", "150", status=2)
        self.assertIn("big.obj", err)
        self.assertIn("memory", err)


@unittest.skipUnless(os.path.isdir(MODELS), MODELS + " is missing (Debian: assimp-testmodels)")
class AssimpModels(unittest.TestCase):
    def read(self, path):
        begin = time.monotonic()
        result = subprocess.run(
            [PROGRAM, "info", path, "--json", "--import-seconds", str(SECONDS),
             "--import-memory-mb", str(MEMORY_MB)],
            stdin=subprocess.DEVNULL, capture_output=True, timeout=10 * SECONDS)
        seconds = time.monotonic() - begin
        return path, result.returncode, result.stdout, result.stderr.decode(), seconds

    def test_every_file(self):
        paths = sorted(os.path.join(folder, name) for folder, _, names in os.walk(MODELS)
                       for name in names)
        self.assertGreater(len(paths), 500, "the package is incomplete")
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            results = list(pool.map(self.read, paths))
        outcomes, slowest = Counter(), 0
        for path, status, out, err, seconds in results:
            with self.subTest(path):
                self.assertIn(status, (0, 2), err)
                self.assertEqual(err, "")
                answer = json.loads(out)
                # Allows for a busy machine; beyond the limit only starting and sending remain.
                self.assertLess(seconds, 3 * SECONDS)
                if status == 0:
                    self.assertGreater(answer["triangles"], 0)
                    outcomes["read"] += 1
                else:
                    message = answer["error"]["message"]
                    self.assertIn(os.path.basename(path), message)
                    self.assertEqual(answer["error"]["kind"], "bad input", message)
                    kind = ("importer crashed" if " stopped with " in message else
                            "too slow" if "longer than" in message else
                            "too large" if "memory" in message else "refused")
                    outcomes[kind] += 1
                    if kind != "refused":
                        print(message)
                slowest = max(slowest, seconds)
        peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
        print(f"{len(paths)} files: {dict(outcomes)}; slowest {slowest:.1f} s, "
              f"largest process {peak:.0f} MiB")
        self.assertLess(peak, 2 * MEMORY_MB)
        self.assertGreater(outcomes["read"], len(paths) // 4)


if __name__ == "__main__":
    main()
