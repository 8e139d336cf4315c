"""trivet batch where things fail: file systems without links, clocks that jump, workers that die or hang, full disks."""
import errno
import fcntl
import json
import os
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from batches import HEAP, BatchCase, as_root_in_mounts, build_preload
from program import PROGRAM, grid_obj, main, needs_memory_bounds

NOBODY = 65534
DAY = 86400


class FaultyCase(BatchCase):
    """With system calls that fail, see faulty_calls.c."""

    @classmethod
    def setUpClass(cls):
        cls.build = tempfile.mkdtemp(prefix="trivet_test_")
        cls.addClassCleanup(shutil.rmtree, cls.build)
        cls.preload = build_preload("faulty_calls", cls.build)

    def faulty(self, **variables):
        return {**self.preload, **{k: str(v) for k, v in variables.items()}}


class WithoutLinks(FaultyCase):
    def test_renaming_gives_the_same_bytes(self):
        for out_format in ("tar", "dir"):
            one = "one_" + out_format
            self.batch(one, "--format", out_format)
            for error in (errno.EPERM, errno.EOPNOTSUPP, errno.EXDEV):
                for last_resort in (0, errno.EINVAL):
                    out = "%s_%d_%d" % (out_format, error, last_resort)
                    env = self.faulty(FAULTY_LINK=error, FAULTY_RENAMEAT2=last_resort)
                    self.batch(out, "--format", out_format, "--shard", "1/2", env=env)
                    self.batch(out, "--format", out_format, env=env)
                    self.assertEqual(self.hashes(out), self.hashes(one))
                    self.assertEqual(self.temporaries(out), [])

    def test_other_errors_are_told(self):
        err = self.batch("out", env=self.faulty(FAULTY_LINK=errno.EIO), status=3)[1]
        self.assertIn("run.json: cannot be written: Input/output error", err)
        env = self.faulty(FAULTY_LINK=errno.EPERM, FAULTY_RENAMEAT2=errno.EACCES)
        self.assertIn("Permission denied", self.batch("out", env=env, status=3)[1])
        self.assertEqual([name for name in self.files() if "scenes-" in name], [])

    def test_two_copies_at_once_replace_nothing(self):
        """One is held while it renames a unit, until the other has made it, too."""
        self.batch("one", count=20)
        env = self.faulty(FAULTY_LINK=errno.EPERM)
        slow = self.start("both", "--json", count=20, env={**env, "SLOW_RENAME_MS": "500"}, stdout=subprocess.PIPE)
        self.wait_until(lambda: any("scenes-" in name for name in self.temporaries("both")), slow)
        self.batch("both", count=20, env=env)
        made = {name: os.stat(self.path(name)).st_ino for name in self.files() if name.startswith("both/")}
        totals = json.loads(slow.communicate()[0])
        self.assertEqual(slow.returncode, 0)
        self.assertGreater(totals["units_dropped"], 0)
        self.assertEqual(self.hashes("both"), self.hashes("one"))
        self.assertEqual(self.temporaries("both"), [])
        for name, inode in made.items():
            if "/." not in name:
                self.assertEqual(os.stat(self.path(name)).st_ino, inode, name)

    def test_two_batches_cannot_both_claim_a_folder(self):
        """Both have looked for run.json before either has it."""
        env = self.faulty(FAULTY_LINK=errno.EPERM, SLOW_RENAME_MS=500)
        both = [self.start("out", "--seed", seed, count=10, env=env) for seed in "12"]
        statuses = [process.wait() for process in both]
        self.assertEqual(sorted(statuses), [0, 2])
        self.assertEqual(self.read_json("out/run.json")["seed"], 1 + statuses.index(0))
        self.assertIn("0 findings", self.trivet("batch", "verify", "out", "--sample", 1)[0])


class Clocks(FaultyCase):
    def test_nothing_depends_on_a_wall_clock_that_jumps(self):
        self.batch("one")
        for days in (-10000, 10000):
            out = "jumps_%d" % days
            self.batch(out, "--scene-seconds", 10, env=self.faulty(CLOCK_JUMPS=days * DAY))
            self.assertEqual(self.hashes(out), self.hashes("one"))
        # It does jump: the program is younger than now.
        out = self.trivet("doctor", status=(0, 3), env=self.faulty(CLOCK_AHEAD=-20000 * DAY))[0]
        self.assertIn("it is behind", out)

    def is_locked(self, name):
        """True if a process holds the lock of this file, or of the folder that it is in: then it is being written."""
        out, folder, temporary = name.split(os.sep)[:3]
        try:
            descriptor = os.open(self.path(os.path.join(out, folder, temporary)), os.O_RDONLY)
        except FileNotFoundError:
            return False
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return False
        except BlockingIOError:
            return True
        finally:
            os.close(descriptor)

    def stop_while_writing(self, out, process):
        """Stops it while it holds the lock of a unit, not between two units, nor before the lock."""
        def has_stopped():
            with open("/proc/%d/stat" % process.pid) as file:
                return file.read().rpartition(")")[2].split()[0] == "T"

        def writes():
            process.send_signal(signal.SIGSTOP)
            self.wait_until(has_stopped, process)
            if any("scenes-" in name and self.is_locked(name) for name in self.temporaries(out)):
                return True
            process.send_signal(signal.SIGCONT)
            return False

        self.wait_until(writes, process)

    def test_merge_spares_what_is_being_written(self):
        for out_format in ("tar", "dir"):
            out = "out_" + out_format
            process = self.start(out, "--format", out_format, count=1000, per_tar=500)
            self.stop_while_writing(out, process)
            left = [out + "/0000/.scenes-000001%s.trivet-tmp.host.%d" % (ending, age)
                    for ending in (".tar", "") for age in (0, 2)]
            for name, age in zip(left, (0, 2, 0, 2)):
                self.write(name if ".tar" in name else name + "/a.json", "half")
                os.utime(self.path(name), (time.time() - age * DAY,) * 2)
            # The clock jumps when merge begins: none is older than that but those that were.
            merge = ("batch", "merge", out, "-o", "all.jsonl")
            self.trivet(*merge, env=self.faulty(CLOCK_AHEAD=3 * DAY))
            self.assertEqual([os.path.exists(self.path(name)) for name in left], [True, False] * 2)
            # It jumped while they were written: all look old.
            for name in os.listdir(self.path(out + "/0000")):
                os.utime(self.path(out + "/0000/" + name), (1, 1))
            self.trivet(*merge)
            self.assertEqual([os.path.exists(self.path(name)) for name in left], [False] * 4)
            process.send_signal(signal.SIGCONT)
            self.assertEqual(process.wait(), 0)
            self.trivet("batch", "status", out)


class Workers(FaultyCase):
    """Workers, of which one has a scene that ends or holds its process."""
    BAD = 13

    def faulty_scene(self, signal_number):
        return self.faulty(FAULTY_SCENE=self.BAD, FAULTY_SIGNAL=int(signal_number), FAULTY_LOG=self.path("log"))

    def assert_listed(self, out, reason, one="one"):
        """It alone has failed, the others are the same; it was tried twice."""
        for bad, good in zip(self.merged(out), self.merged(one)):
            if bad["k"] == self.BAD:
                self.assertEqual((bad["status"], bad["objects"]), ("failed", 0))
                self.assertRegex(bad["reason"], reason)
            else:
                bad.pop("members"), good.pop("members")
                self.assertEqual(bad, good)
        self.assertEqual(self.read("log"), b"xx")
        os.remove(self.path("log"))
        self.assert_no_process_left()
        self.trivet("batch", "verify", out, "--sample", 0.2)
        self.assertIn("failed: ", self.trivet("batch", "status", out)[0])

    def test_a_scene_that_ends_its_process_twice_is_listed(self):
        self.batch("one")
        for number, text in ((signal.SIGABRT, r"signal 6 \(Aborted\)"), (signal.SIGKILL, r"signal 9 \(Killed\)")):
            out = "out_%d" % number
            said = self.batch(out, "--jobs", 2, env=self.faulty_scene(number), status=1)[0]
            self.assertIn("39 ok, 0 refused, 1 failed", said)
            self.assert_listed(out, "^its process was ended by " + text + "$")

    def test_a_scene_that_hangs_without_cpu_time_is_listed(self):
        self.batch("one")
        begin = time.monotonic()
        self.batch("out", "--jobs", 2, "--scene-seconds", 0.2, env=self.faulty_scene(signal.SIGSTOP), status=1)
        self.assertGreater(time.monotonic() - begin, 2 * 10 * 0.2)
        self.assert_listed("out", "^took more than 2 s$")

    @needs_memory_bounds
    def test_a_scene_that_wants_too_much_memory_is_listed(self):
        self.write("sheet.obj", grid_obj(200))
        self.write_recipe(groups=[HEAP, {
            "name": "large", "models": [{"model": "sheet.obj"}], "count": [0, 1],
            "heap": {"centre": [5, 5], "radius": 0, "height": 0.1}}])
        self.batch("one", "--with", "scene", count=10)
        self.batch("out", "--with", "scene", "--scene-memory-mb", 35, count=10, status=1)
        large = 0
        for bad, good in zip(self.merged("out"), self.merged("one")):
            self.assertEqual(good["status"], "ok")
            if good["triangles"] > 10000:
                large += 1
                self.assertEqual((bad["status"], bad["reason"]), ("failed", "needs more than 35 MB"))
            else:
                self.assertEqual(bad, good)
        self.assertTrue(0 < large < 10, large)


class Importers(BatchCase):
    """Models whose import crashes, hangs or wants all memory: nothing is begun."""

    def assert_refused(self, says, *more, env=None):
        before = self.files()
        err = self.batch("out", *more, env=env, status=2)[1]
        self.assertEqual(err.count("\n"), 1, err)
        for part in (says, ".obj: "):
            self.assertIn(part, err)
        self.assertEqual(self.files(), before)
        self.assert_no_process_left()

    def test_a_model_that_crashes_its_importer(self):
        self.assert_refused("Segmentation fault", env=self.importer("kill -SEGV $$"))

    def test_a_model_that_hangs_its_importer(self):
        begin = time.monotonic()
        self.assert_refused("longer than the limit of 1 s", "--import-seconds", 1, env=self.importer("exec sleep 100"))
        self.assertLess(time.monotonic() - begin, 20)

    def test_a_model_that_wants_all_memory(self):
        self.write("cube.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n" * 1000000)
        self.assert_refused("memory", "--import-memory-mb", 150)


class Folders(BatchCase):
    def test_no_permission(self):
        if os.geteuid() == 0:
            os.chmod(self.folder, 0o755)
            user = {"user": NOBODY, "group": NOBODY, "extra_groups": []}
        else:
            user = {}
        try:
            subprocess.run([PROGRAM, "--version"], check=True, capture_output=True, cwd=self.folder, **user)
        except (OSError, subprocess.CalledProcessError):
            self.skipTest("another user cannot run the program here")
        self.batch("begun", "--shard", "0/2")
        os.makedirs(self.path("closed"))
        for folder, mode in (("closed", 0o555), ("begun", 0o777), ("begun/0000", 0o555)):
            os.chmod(self.path(folder), mode)
        before = self.files()
        for out, named in (("closed", "closed"), ("closed/new", "closed/new"),
                           ("begun", "begun/0000/scenes-000001.tar")):
            run = subprocess.run([PROGRAM, "batch", "recipe.json", "--count", "40", "--per-tar", "5", "--out", out],
                                 cwd=self.folder, capture_output=True, **user)
            err = run.stderr.decode()
            self.assertEqual(run.returncode, 3, err)
            self.assertIn("trivet: %s: cannot be written: Permission denied" % named, err)
        self.assertEqual(self.files(), before)
        self.assertEqual(os.listdir(self.path("closed")), [])
        self.assert_no_process_left()

    def test_a_disk_that_was_full_is_filled_with_the_same_bytes(self):
        self.batch("one", count=100)
        run = as_root_in_mounts(
            "cd %s && mkdir full && mount -t tmpfs -o size=96k none full && "
            "batch() { %s batch recipe.json --count 100 --per-tar 5 --out full --quiet; echo status $?; } && "
            "batch && ls full/0000 | wc -l && mount -o remount,size=16m full && batch && cp -r full made"
            % (self.folder, PROGRAM))
        if run is None:
            self.skipTest("no file system can be mounted here")
        out, err = run.stdout.decode(), run.stderr.decode()
        self.assertRegex(out, r"(?s)^status 3\n[1-9]\n.*status 0\n", out + err)
        self.assertEqual(self.hashes("made"), self.hashes("one"))

    def test_sigterm_while_models_are_hashed(self):
        with open(self.path("huge.stl"), "wb") as file:
            file.truncate(64 << 30)
        self.write_recipe(groups=[{**HEAP, "models": [{"model": "huge.stl"}]}])
        process = self.start("out")
        self.wait_until(lambda: self.bytes_read(process.pid) > 1 << 24, process)
        process.send_signal(signal.SIGTERM)
        begin = time.monotonic()
        self.assertEqual(process.wait(), 75)
        self.assertLess(time.monotonic() - begin, 5)
        self.assertFalse(os.path.exists(self.path("out")))

    def bytes_read(self, process):
        with open("/proc/%d/io" % process) as file:
            return int(file.readline().split()[1])


class Refusals(BatchCase):
    def test_motions_beyond_the_limit_are_in_the_manifest(self):
        self.write_recipe(groups=[{**HEAP, "count": 2}], max_motions=2)
        self.batch("kept", count=10)
        for row in self.merged("kept"):
            self.assertEqual((row["status"], row["operations"], row["refused"], row["objects"]), ("ok", 2, 2, 1))
        self.assertIn(r'did not come to rest within 2 motions', self.trivet("batch", "recipe.json", "--count", 10, "--only", 3)[0])
        self.write_recipe(groups=[{**HEAP, "count": 2}], max_motions=2, accept={"max_refused": 0})
        self.batch("refused", count=10)
        for row in self.merged("refused"):
            self.assertEqual((row["status"], row["reason"]), ("refused", "2 refused operations; accepted: at most 0"))
        self.write_recipe(groups=[{**HEAP, "count": 2}], max_motions=2, on_refusal="drop")
        self.batch("dropped", count=10)
        for row in self.merged("dropped"):
            self.assertEqual(row["status"], "refused")
            self.assertRegex(row["reason"], '^dropped: "heap_0" did not come to rest within 2 motions$')


if __name__ == "__main__":
    main()
