"""trivet batch: scenes that depend on recipe, seed and number alone, units that are whole or not there."""
import glob
import json
import os
import random
import resource
import shlex
import signal
import subprocess
import tarfile
import time
import unittest

from batches import EFFORT, HEAP, SLAB, BatchCase, as_root_in_mounts
from program import PROGRAM, main, needs_memory_bounds


class Bytes(BatchCase):
    def test_shards_jobs_folders_and_names_change_nothing(self):
        self.batch("one", "--jobs", 1)
        one = self.hashes("one")
        self.assertEqual(len([n for n in one if n.endswith(".tar")]), 8)
        for shard in range(3):
            self.batch("three", "--shard", "%d/3" % shard, "--jobs", 3, "--recycle", 2)
        self.assertEqual(self.hashes("three"), one)
        env = {"SLURM_ARRAY_TASK_MIN": "1", "SLURM_ARRAY_TASK_COUNT": "2"}
        for task in "12":
            self.batch("slurm", env={**env, "SLURM_ARRAY_TASK_ID": task})
        self.assertEqual(self.hashes("slurm"), one)
        self.batch("slurm")  # nothing is left to do
        self.assertEqual(self.hashes("slurm"), one)
        for name in ("cube.obj", "slab.obj", "recipe.json"):
            self.write("elsewhere/" + name, self.read(name))
        self.batch("moved", recipe=self.path("elsewhere/recipe.json"))
        self.assertEqual(self.hashes("moved"), one)
        self.assertEqual(self.trivet("batch", "status", "moved")[0].split("\n")[0],
                         "units: 8 of 8; scenes: 40 of 40: 40 ok, 0 refused, 0 failed")

    def test_kill_at_random_moments_changes_nothing(self):
        """Three shards at once, in a folder that is never emptied: 50 kills with TRIVET_TEST_EFFORT=1."""
        kills = max(3, round(50 * EFFORT))
        count = 60 * kills  # of which the kills leave a part to do
        self.batch("one", count=count)
        generator = random.Random(1)
        num_killed = num_units = 0
        while num_killed < kills:
            shards = [self.start("killed", "--shard", "%d/3" % i, "--jobs", "1", count=count) for i in range(3)]
            wanted = len(self.units("killed")) + generator.randrange(6)
            self.wait_until(lambda: len(self.units("killed")) >= wanted, *shards)
            generator.shuffle(shards)
            for process in shards:
                time.sleep(generator.uniform(0, 0.02))
                process.kill()
                num_killed += process.wait() == -signal.SIGKILL
            self.assert_no_process_left()
            num_units = len(self.units("killed"))
        self.assertLess(num_units, count // 5, "all was done before the last kill")
        for i in range(3):
            self.batch("killed", "--shard", "%d/3" % i, count=count)
        self.assertEqual(self.hashes("killed"), self.hashes("one"))
        left = len(self.temporaries("killed"))
        print("%d kills, %d of %d units were there after the last one, %d temporary files left" %
              (num_killed, num_units, count // 5, left))
        self.assertEqual(json.loads(self.trivet("batch", "status", "killed", "--json")[0])["temporaries"], left)
        # Merge deletes them when they are old.
        for name in self.temporaries("killed"):
            os.utime(self.path(name), (1, 1))
        self.trivet("batch", "merge", "killed", "-o", "all.jsonl")
        self.assertEqual(self.temporaries("killed"), [])

    def test_two_copies_of_a_shard_at_once(self):
        self.batch("one")
        for process in [self.start("both"), self.start("both"), self.start("both", "--jobs", "1")]:
            self.assertEqual(process.wait(), 0)
        self.assertEqual(self.hashes("both"), self.hashes("one"))
        self.assertEqual(self.temporaries("both"), [])

    def test_what_two_copies_of_a_shard_make_twice_is_dropped(self):
        """One is held in the middle of a unit until the other has made them all."""
        self.batch("one", count=400)
        held = self.start("both", "--json", count=400, stdout=subprocess.PIPE)
        self.wait_until(lambda: any("scenes-" in name for name in self.temporaries("both")), held)
        held.send_signal(signal.SIGSTOP)
        begun = len(self.temporaries("both"))
        self.assertGreater(begun, 0)
        other = json.loads(self.batch("both", "--json", count=400)[0])
        self.assertEqual((other["units"], other["units_dropped"]), (80, 0))
        held.send_signal(signal.SIGCONT)
        totals = json.loads(held.communicate()[0])
        self.assertEqual(held.returncode, 0)
        self.assertTrue(0 < totals["units_dropped"] <= begun, totals)
        self.assertGreater(totals["units_by_others"], totals["units_dropped"])
        self.assertEqual(totals["ok"] + totals["refused"], 400, "scenes of others count, too")
        self.assertEqual(self.hashes("both"), self.hashes("one"))
        self.assertEqual(self.temporaries("both"), [])

    def test_killed_workers_change_nothing(self):
        self.batch("one", count=240)
        process = self.start("shot", "--jobs", "2", "--retries", "100", count=240)
        generator = random.Random(2)
        # Models are read: an importer, before its exec, is called "trivet", too.
        self.wait_until(lambda: os.path.exists(self.path("shot/run.json")), process)
        shots = 0
        while shots < 10 and process.poll() is None:
            before, deadline = len(self.units("shot")), time.monotonic() + 0.3
            shots += self.shoot_a_worker(process.pid, generator)
            # It gets on between two shots.
            while process.poll() is None and len(self.units("shot")) == before and time.monotonic() < deadline:
                time.sleep(0.005)
        self.assertEqual(process.wait(), 0)
        self.assertGreater(shots, 2)
        self.assertEqual(self.hashes("shot"), self.hashes("one"))

    def shoot_a_worker(self, batch, generator):
        """@return whether there was one."""
        try:
            os.kill(int(generator.choice(self.workers_of(batch))), generator.choice([signal.SIGSEGV, signal.SIGKILL]))
            return True
        except (OSError, IndexError):
            return False

    def test_arrangements_differ_from_scene_to_scene(self):
        cubes = [{"name": "c%d" % i, "model": "cube.obj", "scale": 0.2} for i in range(3)]
        arrange = {"op": "arrange", "things": [{"objects": "c*"}], "relations": [{"is": "on", "a": "*", "b": "slab"}]}

        def poses(name, operation):
            self.write_recipe(name + ".json", objects=[SLAB, *cubes], groups=[], operations=[operation])
            self.batch(name, "--format", "dir", count=3, recipe=name + ".json")
            scenes = [json.loads(self.read(f)) for f in sorted(glob.glob(self.path(name + "/0000/scenes-*/*.json")))
                      if "manifest" not in f]
            self.assertEqual([s["status"] for s in scenes], ["ok"] * 3)
            return [json.dumps([o.get("pose", o) for o in s["objects"]], sort_keys=True) for s in scenes]
        drawn = poses("drawn", arrange)
        self.assertEqual(len(set(drawn)), 3)
        self.assertEqual(poses("again", arrange), drawn)
        self.assertEqual(len(set(poses("given", {**arrange, "seed": 4}))), 1)

    def test_formats_hold_the_same_scenes(self):
        self.batch("tar", "--with", "scene,report")
        self.batch("dir", "--format", "dir", "--with", "scene,report")
        self.batch("poses", "--format", "poses")
        rows = self.read("poses/0000/scenes-000001.jsonl").decode().splitlines(keepends=True)
        self.assertEqual(json.loads(rows[-1])["scenes"], 5)
        with tarfile.open(self.path("tar/0000/scenes-000001.tar")) as tar:
            members = tar.getmembers()
            self.assertEqual(members[-1].name, "manifest.jsonl")
            self.assertTrue(all((m.mtime, m.uid, m.uname, m.mode) == (0, 0, "", 0o644) for m in members))
            self.assertEqual([m.name for m in members[:3]],
                             ["000000005.json", "000000005.glb", "000000005.report.json"])
            content = {m.name: tar.extractfile(m).read() for m in members}
        for name, data in content.items():
            self.assertEqual(self.read("dir/0000/scenes-000001/" + name), data, name)
        for i, k in enumerate(range(5, 10)):
            self.assertEqual(content["%09d.json" % k].decode(), rows[i])
        only = self.trivet("batch", "recipe.json", "--count", 40, "--only", "9,5,9")[0]
        self.assertEqual(only, rows[4] + rows[0])
        for out in ("tar", "dir", "poses"):
            self.trivet("batch", "verify", out, "--sample", 0.2)
        # The scene as it was laid out, and as it stands by its poses.
        self.write("tar/5.glb", content["000000005.glb"])
        self.trivet("batch", "materialise", "tar", 5, "-o", "tar/again.glb")
        self.trivet("check", "tar/5.glb")
        self.trivet("check", "tar/again.glb")
        for name in ("5", "again"):
            self.trivet("export", "tar/%s.glb" % name, "-o", name + ".jsonl")
        self.assertEqual(self.read("5.jsonl"), self.read("again.jsonl"))


class Faults(BatchCase):
    def cpu_seconds_of(self, k):
        """CPU seconds of a process that makes scene k alone."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.trivet("batch", "recipe.json", "--count", 20, "--only", k)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

    def test_a_scene_beyond_its_cpu_time_is_listed(self):
        self.write_recipe(groups=[{**HEAP, "count": [0, 20]}])
        self.batch("free", count=20)
        free = self.merged("free")
        smallest, *_, largest = [row["k"] for row in sorted(free, key=lambda row: row["objects"])]
        # The same share on any machine.
        seconds = "%.2g" % ((self.cpu_seconds_of(largest) - self.cpu_seconds_of(smallest)) / 3)
        self.batch("bound", "--scene-seconds", seconds, count=20, status=1)
        bound = self.merged("bound")
        failed = [row for row in bound if row["status"] == "failed"]
        self.assertTrue(0 < len(failed) < 20, len(failed))
        for row in failed:
            # On a busy machine ten times that by the clock may end it first.
            self.assertRegex(row["reason"], "^(needs more than %s s of CPU time|took more than .* s)$" % seconds)
        for a, b in zip(free, bound):
            if b["status"] != "failed":
                self.assertEqual(a, b)
        self.assertEqual(self.batch("bound", "--scene-seconds", seconds, count=20, status=1)[0].count("failed"), 1)

    @needs_memory_bounds
    def test_a_scene_beyond_its_memory_is_listed(self):
        self.write_large_recipe()
        self.batch("out", "--scene-memory-mb", 1, "--with", "scene", count=6, status=1)
        rows = self.merged("out")
        self.assertEqual([row["status"] for row in rows], ["failed"] * 6)

    def test_scenes_behind_a_slow_one_fill_no_memory(self):
        """A worker is held, the other one goes on until what waits for its place in the unit is enough."""
        self.write_large_recipe()
        process = self.start("out", "--jobs", "2", "--with", "scene", "--scene-seconds", "1000", count=150, per_tar=150)
        self.wait_until(lambda: os.path.exists(self.path("out/run.json")), process)
        before = self.kilobytes(process.pid)
        workers = []
        while len(workers) < 2:
            self.assertIsNone(process.poll())
            workers = self.workers_of(process.pid)
        os.kill(int(workers[0]), signal.SIGSTOP)
        worked, since = self.cpu_ticks(workers[1]), time.monotonic()
        most = 0
        while time.monotonic() - since < 2:
            most = max(most, self.kilobytes(process.pid) - before)
            if self.cpu_ticks(workers[1]) != worked:
                worked, since = self.cpu_ticks(workers[1]), time.monotonic()
            time.sleep(0.05)
        os.kill(int(workers[0]), signal.SIGCONT)
        self.assertEqual(process.wait(), 0)
        self.assertLess(most, 150e3)  # all are 300 MB

    def kilobytes(self, process):
        with open("/proc/%d/status" % process) as file:
            return int([line for line in file if line.startswith("VmRSS")][0].split()[1])

    def cpu_ticks(self, process):
        with open("/proc/%s/stat" % process) as file:
            return sum(map(int, file.read().split()[13:15]))

    def test_sigterm_stops_within_seconds_and_leaves_whole_units(self):
        self.write_recipe(groups=[{**HEAP, "count": 12}])
        process = self.start("out", "--jobs", "2", count=4000)
        self.wait_until(lambda: self.units("out"), process)
        process.send_signal(signal.SIGTERM)
        start = time.monotonic()
        self.assertEqual(process.wait(), 75)
        self.assertLess(time.monotonic() - start, 5)
        self.assertEqual(self.temporaries("out"), [])
        self.assert_no_process_left()
        self.trivet("batch", "status", "out", status=1)
        self.trivet("batch", "verify", "out", "--sample", 0)

    def test_sigterm_at_the_beginning_leaves_nothing_half_made(self):
        generator = random.Random(4)
        for _ in range(8):
            process = self.start("out", count=100000)
            time.sleep(generator.uniform(0, 0.1))
            process.send_signal(signal.SIGTERM)
            self.assertIn(process.wait(), (75, -signal.SIGTERM))  # the latter before it looks at the folder
            self.assertEqual(self.temporaries("out"), [])
            self.assert_no_process_left()

    def test_full_disk_stops_at_once_with_all_written_intact(self):
        run = as_root_in_mounts(
            "cd %s && mkdir full && mount -t tmpfs -o size=96k none full && "
            "%s batch recipe.json --count 4000 --per-tar 5 --out full; echo status $?; "
            "%s batch verify full --sample 0; echo status $?; ls -a full/0000"
            % (self.folder, PROGRAM, PROGRAM))
        if run is None:
            self.skipTest("no file system can be mounted here")
        out, err = run.stdout.decode(), run.stderr.decode()
        self.assertIn("No space left on device", err)
        self.assertEqual(out.count("status 3"), 1, out + err)
        self.assertEqual(out.count("status 0"), 1, out + err)
        self.assertIn("scenes-000000.tar", out)
        self.assertNotIn("trivet-tmp", out)

    def test_read_only_folder_is_refused_before_the_first_scene(self):
        run = as_root_in_mounts("cd %s && mkdir ro && mount -t tmpfs -o ro none ro && "
                                "%s batch recipe.json --count 10 --out ro; echo status $?" % (self.folder, PROGRAM))
        if run is None:
            self.skipTest("no file system can be mounted here")
        self.assertIn("status 3", run.stdout.decode())
        self.assertIn("ro: cannot be written: Read-only file system", run.stderr.decode())

    def test_few_descriptors(self):
        self.batch("one")
        subprocess.run(["bash", "-c", 'ulimit -n 64; exec "$@"', "bash", PROGRAM, "batch", "recipe.json", "--count", "40",
                        "--per-tar", "5", "--out", "few", "--quiet"], cwd=self.folder, check=True, capture_output=True)
        self.assertEqual(self.hashes("few"), self.hashes("one"))
        run = subprocess.run(["bash", "-c", 'ulimit -n 16; exec "$@"', "bash", PROGRAM, "batch", "recipe.json", "--count",
                              "4000", "--jobs", "64", "--out", "none"], cwd=self.folder, capture_output=True)
        self.assertEqual(run.returncode, 3)
        self.assertIn(b"accepted: fewer --jobs, or a larger ulimit -n", run.stderr)


class Usage(BatchCase):
    def test_bad_usage(self):
        base = ("batch", "recipe.json", "--count", 10)
        self.refused("batch", says="batch: a recipe is missing")
        self.refused("batch", "recipe.json", "--out", "o", says="--count is missing")
        self.refused(*base, says="--out is missing")
        self.refused(*base, "--out", "o", "--shard", "2/2", says="--shard: shard 2 of 2 is not accepted")
        self.refused(*base, "--out", "o", "--format", "zip", says="accepted: tar, dir, poses")
        self.refused(*base, "--out", "o", "--format", "poses", "--with", "scene", says="--with: is not accepted")
        self.refused(*base, "--only", "3,10", says="--only: 10 is not accepted; accepted: 0 to 9")
        self.refused("batch", "none.json", "--count", 1, "--out", "o", says="none.json")
        self.refused("batch", "status", self.folder, says="run.json")
        self.refused("batch", "materialise", "nowhere", 3, "-o", "a.glb", says="run.json")

    def test_bad_recipes_and_models_leave_nothing(self):
        self.write("bad.json", '{"trivet_recipe": 1, "groups": [{"name": "a", "models": [], "on": "floor"}]}')
        self.refused("batch", "bad.json", "--count", 1, "--out", "o", says="bad.json: /groups/0/models: [] is not")
        self.write_recipe("none.json", groups=[{**HEAP, "models": [{"model": "none.obj"}]}])
        self.refused("batch", "none.json", "--count", 1, "--out", "o", says="none.obj: is no file")
        self.write("broken.obj", "v 0 0 zero\nf 1 2 3\n")
        self.write_recipe("broken.json", groups=[{**HEAP, "models": [{"model": "broken.obj"}]}])
        self.refused("batch", "broken.json", "--count", 1, "--out", "o", says="broken.obj")

    def test_dry_run_and_templates_write_nothing(self):
        before = self.files()
        out = json.loads(self.trivet("batch", "recipe.json", "--count", 95, "--per-tar", 10, "--shard", "1/4", "--dry-run",
                                     "--json")[0])
        self.assertEqual((out["units"], out["scenes"], out["models"]), (3, 25, 2))
        args = ("batch", "recipe.json", "--count", 100000, "--seed", 7, "--template")
        for engine in ("slurm", "parallel"):
            self.assertIn("--count 100000 --seed 7 --per-tar 20", self.trivet(*args, engine)[0])
        job = json.loads(self.trivet(*args, "aws-batch")[0])
        self.assertEqual(job["arrayProperties"]["size"], 100)
        self.assertIn("completions: 100\n", self.trivet(*args, "kubernetes")[0])
        self.assertEqual(self.files(), before)

    def test_templates_keep_all_options(self):
        recipe, out = "my folder/it's.json", "out of\ttwo words"
        begin = ["--count", "100", "--seed", "0", "--per-tar", "10", "--jobs", "2", "--out"]
        more = ["--format", "dir", "--with", "scene,report", "--scene-seconds", "5", "--import-in-process"]
        here = ["batch", recipe, *begin, out, *more]
        in_container = ["batch", "/in/it's.json", *begin, "/out", *more]
        text = {engine: self.trivet(*here, "--template", engine, env={"TRIVET_SHARDS": "4"})[0]
                for engine in ("slurm", "parallel", "kubernetes", "aws-batch")}
        for engine in ("slurm", "parallel"):
            subprocess.run(["bash", "-n"], input=text[engine].encode(), check=True)
            words = shlex.split(text[engine].replace("\\\n", " "), comments=True)
            at = words.index("trivet") + 1
            self.assertEqual(words[at:at + len(here)], here)
        self.assertIn("--array=0-3%", text["slurm"])
        self.assertIn("--cpus-per-task=2 ", text["slurm"])
        self.assertIn(" --shard {}/4 ::: {0..3}\n", text["parallel"])
        self.assertEqual(json.loads(text["aws-batch"])["containerOverrides"]["command"], in_container)
        line = [line for line in text["kubernetes"].splitlines() if " args: " in line][0]
        self.assertEqual(json.loads(line.split(" args: ")[1]), in_container)


class Referee(BatchCase):
    @unittest.skipUnless(os.access(os.environ.get("TRIVET_REFEREE", ""), os.X_OK),
                         "the referee of ../shared is not built")
    def test_scenes_are_judged_true(self):
        """By a program that shares no code with Trivet."""
        self.batch("out", "--format", "dir", "--with", "scene,report", count=int(5 * EFFORT) or 1)
        scenes = sorted(glob.glob(self.path("out/0000/scenes-*/*.glb")))
        self.assertGreater(len(scenes), 0)
        for scene in scenes:
            report = json.loads(self.read(scene[:-4] + ".report.json"))
            for o in report["objects"]:
                o["model"] = self.path("out/" + o["model"])
            self.write("report.json", json.dumps(report))
            run = subprocess.run([os.environ["TRIVET_REFEREE"], self.path("report.json"), "--scene", scene],
                                 capture_output=True, cwd=self.folder)
            self.assertEqual(run.returncode, 0, run.stdout.decode() + run.stderr.decode())


if __name__ == "__main__":
    main()
