"""Common part of the tests of trivet batch: recipes, batches, and what they leave."""
import glob
import hashlib
import json
import os
import shutil
import subprocess
import time
import unittest

from program import PROGRAM, Case, grid_obj

EFFORT = float(os.environ.get("TRIVET_TEST_EFFORT", "1"))
SLAB = {"name": "slab", "model": "slab.obj", "fixed": True, "position": [0, 0, 0.050001]}
HEAP = {"name": "heap", "models": [{"model": "cube.obj", "class": "cube"}, {"model": "cube.obj", "scale": 0.5}],
        "count": [1, 3], "scale_range": [0.5, 1.2], "rotation": "any",
        "heap": {"radius": 0.2, "height": 0.5, "rise": 0.2}}


def sha256_of(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def build_preload(name, folder):
    """The environment in which a program loads name.c before its libraries."""
    if not shutil.which("cc"):
        raise unittest.SkipTest("no C compiler")
    source = os.path.join(os.path.dirname(os.path.abspath(__file__)), name + ".c")
    library = os.path.join(folder, name + ".so")
    subprocess.run(["cc", "-Wall", "-Werror", "-shared", "-fPIC", source, "-o", library, "-ldl"], check=True)
    return {"LD_PRELOAD": library, "ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "") + ":verify_asan_link_order=0"}


def as_root_in_mounts(script):
    """Runs a shell script where it may mount file systems; None if that is not possible here."""
    for prefix in (["unshare", "-m"], ["unshare", "-rm"]):
        probe = subprocess.run([*prefix, "sh", "-c", "mount -t tmpfs -o size=64k none /tmp"], capture_output=True)
        if probe.returncode == 0:
            return subprocess.run([*prefix, "sh", "-c", script], capture_output=True, timeout=120)
    return None


class BatchCase(Case):
    def setUp(self):
        super().setUp()
        self.write_recipe()

    def write_recipe(self, name="recipe.json", **more):
        recipe = {"trivet_recipe": 1, "objects": [SLAB], "groups": [HEAP], **more}
        return self.write(name, json.dumps(recipe))

    def write_large_recipe(self, **more):
        """Scenes of 2 MB and more each, as .glb."""
        self.write("sheet.obj", grid_obj(200))
        sheet = {"name": "sheet", "model": "sheet.obj", "fixed": True, "position": [5, 5, 5]}
        return self.write_recipe(objects=[SLAB, sheet], **more)

    def batch(self, out, *more, count=40, recipe="recipe.json", status=0, env=None):
        return self.trivet("batch", recipe, "--count", count, "--per-tar", 5, "--out", out, "--quiet",
                           *more, status=status, env=env)

    def start(self, out, *more, count=40, per_tar=5, env=None, stdout=subprocess.DEVNULL):
        return subprocess.Popen([PROGRAM, "batch", "recipe.json", "--count", str(count), "--per-tar", str(per_tar),
                                 "--out", out, "--quiet", *more], cwd=self.folder, stdout=stdout, stderr=subprocess.DEVNULL,
                                env={**os.environ, **(env or {})})

    def workers_of(self, batch):
        """Ids of the processes that make its scenes."""
        def children(process):
            with open("/proc/%s/task/%s/children" % (process, process)) as file:
                return file.read().split()

        def name_of(process):
            with open("/proc/%s/comm" % process) as file:
                return file.read().strip()
        return [w for zygote in children(batch)[:1] for w in children(zygote) if name_of(w) == "trivet"]

    def hashes(self, out):
        """SHA-256 of all that a batch has but temporary files, by path."""
        return {name[len(out) + 1:]: sha256_of(self.path(name)) for name in self.files()
                if name.startswith(out + os.sep) and not os.path.basename(name).startswith(".")
                and "/." not in name}

    def temporaries(self, out):
        return [name for name in self.files() if name.startswith(out + os.sep) and "/." in name]

    def units(self, out):
        return glob.glob(self.path(out + "/0000/scenes-*.tar"))

    def merged(self, out):
        """Rows of its manifest."""
        self.trivet("batch", "merge", out, "-o", out + ".jsonl")
        return [json.loads(line) for line in self.read(out + ".jsonl").splitlines()]

    def wait_until(self, condition, *processes, seconds=60):
        """Waits for the condition, and asserts that these processes run until then."""
        deadline = time.monotonic() + seconds
        while not condition():
            for process in processes:
                self.assertIsNone(process.poll(), "it ended too soon")
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.002)

    def assert_no_process_left(self):
        """Asserts that no process works in this folder."""
        deadline = time.monotonic() + 5
        while time.monotonic() < deadline:
            left = []
            for entry in glob.glob("/proc/[0-9]*/cwd"):
                try:
                    if os.readlink(entry) == os.path.realpath(self.folder):
                        left.append(entry)
                except OSError:
                    pass
            if not left:
                return
            time.sleep(0.05)
        self.fail("processes are left: %s" % left)
