"""Files at the edges: outputs that are inputs, closed streams, full disks, pipes."""
import json
import os
import resource
import shutil
import signal
import subprocess
import threading
import time

from program import PROGRAM, SLAB, Case, grid_obj, main, put


class InputsStay(Case):
    """No verb overwrites a file that it reads, or that these name."""

    def models(self):
        """The cube in other formats, and a layout of each."""
        self.trivet("run", self.layout([SLAB], name="slab.json"), "-o", "m.stl", "--quiet")
        self.trivet("run", "slab.json", "-o", "m.glb", "--quiet")
        self.trivet("run", "slab.json", "-o", "m.gltf", "--quiet")
        self.trivet("run", "slab.json", "-o", "m.obj", "--quiet")

    def test_run_keeps_the_models_of_its_layout(self):
        self.models()
        for model in ("m.obj", "m.stl", "m.glb", "m.gltf"):
            layout = self.layout([{**SLAB, "model": model}])
            self.refused("run", layout, "-o", model, says=(model, "is an input"))
            self.refused("run", layout, "-o", "./x/../" + model, says="is an input")
        self.refused("run", layout, "-o", "s.glb", "--report", "m.gltf", says="is an input")

    def test_under_another_name(self):
        self.models()
        layout = self.layout([{**SLAB, "model": "m.glb"}])
        os.symlink("m.glb", self.path("soft.glb"))
        os.link(self.path("m.glb"), self.path("hard.glb"))
        for name in ("soft.glb", "hard.glb"):
            self.refused("run", layout, "-o", name, says=(name, "is an input"))

    def test_files_beside(self):
        self.models()
        self.refused("run", self.layout([{**SLAB, "model": "m.gltf"}]), "-o", "s.glb",
                     "--report", "m.bin", says=("m.bin", "named by", "m.gltf"))
        self.refused("run", self.layout([{**SLAB, "model": "m.obj"}]), "-o", "s.glb",
                     "--report", "m.mtl", says=("m.mtl", "named by", "m.obj"))
        # Files that an export writes beside itself: n.gltf has named n.bin, which the model names
        # too.
        for name in ("n.gltf", "other.gltf"):
            self.write(name, self.read("m.gltf").replace(b"m.bin", b"n.bin"))
        shutil.copy(self.path("m.bin"), self.path("n.bin"))
        self.refused("run", self.layout([{**SLAB, "model": "other.gltf"}]), "-o", "n.gltf",
                     says=("n.bin", "named by", "other.gltf"))

    def test_the_models_of_an_appended_object(self):
        layout = self.layout([SLAB], [{"op": "append", "object": "a", "model": "cube.obj"}])
        self.refused("run", layout, "-o", "cube.obj", says="is an input")

    def test_the_models_of_a_scene(self):
        layout = self.layout([SLAB, {"name": "a", "model": "cube.obj"}], [put("a", 0, 0, 1)])
        self.trivet("run", layout, "-o", "s.glb")
        for verb in (("put", "s.glb", "slab.obj", "--position", 0, 0, 2),
                     ("push", "s.glb", "a", "--to", 0.1, 0),
                     ("fix", "s.glb", "a")):
            self.refused(*verb, "-o", "cube.obj", says="is an input")
        self.refused("check", "s.glb", "--report", "cube.obj", says="is an input")
        self.refused("check", layout, "--report", "cube.obj", says="is an input")
        self.refused("export", "s.glb", "-o", "a.urdf", "--report", "slab.obj", says="is an input")
        self.trivet("push", "s.glb", "a", "--to", 0.1, 0, "-o", "s.glb")  # in place is meant

    def test_the_files_of_a_demo(self):
        self.refused("demo", "spoon-saucer", "--export", "d", "-o", "s.glb", "--report",
                     "d/layout.json", says="is an input")
        self.assertFalse(os.path.exists(self.path("d")))

    def session(self, lines, *arguments):
        result = subprocess.run([PROGRAM, "session", *arguments], cwd=self.folder, text=True,
                                input="".join(json.dumps(line) + "\n" for line in lines),
                                capture_output=True, timeout=100)
        return [json.loads(line) for line in result.stdout.splitlines()][1:]

    def test_what_a_session_reads(self):
        self.models()
        layout = self.layout([{**SLAB, "model": "m.glb"}, {"name": "a", "model": "cube.obj"}])
        before = self.read("m.glb")
        answers = self.session([{"save": "m.glb"}, put("a", 0, 0, 1), {"save": "j.glb"},
                                {"save": "s.glb"}], layout, "--journal", "j.glb")
        self.assertEqual([a["status"] for a in answers], ["error", "ok", "error", "ok"])
        for k in (0, 2):
            self.assertIn("is an input", answers[k]["reason"])
        self.assertEqual(self.read("m.glb"), before)
        self.trivet("replay", "j.glb", "-o", "t.glb")
        self.assertEqual(self.read("t.glb"), self.read("s.glb"))
        self.refused("replay", "j.glb", "-o", "m.glb", says="is an input")

    def test_a_start_that_is_called_like_its_copy(self):
        self.trivet("run", self.layout([SLAB]), "-o", "s.glb")
        os.rename(self.path("s.glb"), self.path("j.start"))
        self.refused("session", "j.start", "--journal", "j", says="would be replaced by the journal's copy")
        self.write("j.start", "of the user")
        self.refused("session", self.layout([SLAB]), "--journal", "j", says="is there already")
        self.assertNotIn("j", self.files())


class ClosedStreams(Case):
    """Who closes a standard stream finds nothing of it in a file."""

    def closed(self, descriptors, *arguments, lines=()):
        """The program with these descriptors closed. Gives status, output, errors."""
        def close():
            for descriptor in descriptors:
                os.close(descriptor)
        result = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, preexec_fn=close,
                                input="".join(json.dumps(line) + "\n" for line in lines).encode(),
                                capture_output=True, timeout=100)
        return result.returncode, result.stdout.decode(), result.stderr.decode()

    def check_journal(self, steps):
        """Every line of it is one that Trivet wrote, and it is replayed."""
        lines = self.read("j").decode().splitlines()
        self.assertEqual(len(lines), 1 + steps)
        for line in lines:
            self.assertIn("sum", json.loads(line))
        self.trivet("replay", "j", "-o", "t.glb")

    def test_a_session_without_standard_output(self):
        layout = self.layout([SLAB, {"name": "a", "model": "cube.obj"}])
        status, _, err = self.closed([1], "session", layout, "--journal", "j",
                                     lines=[put("a", 0, 0, 1)])
        self.assertEqual(status, 3)
        self.assertIn("answers of the session cannot be written", err)
        self.check_journal(0)

    def test_a_session_whose_reader_has_gone(self):
        layout = self.layout([SLAB, {"name": "a", "model": "cube.obj"}])
        process = subprocess.Popen([PROGRAM, "session", layout, "--journal", "j"], cwd=self.folder,
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        process.stdout.readline()
        process.stdout.close()
        process.stdin.write(json.dumps(put("a", 0, 0, 1)) + "\n")
        process.stdin.flush()  # and stays open: the session ends by itself
        self.assertEqual(process.wait(timeout=60), 3)
        self.assertIn("answers of the session cannot be written", process.stderr.read())
        process.stdin.close()
        process.stderr.close()
        self.check_journal(1)

    def test_a_session_on_a_full_disk(self):
        layout = self.layout([SLAB, {"name": "a", "model": "cube.obj"}])
        with open("/dev/full", "w") as full:
            result = subprocess.run([PROGRAM, "session", layout, "--journal", "j"], cwd=self.folder,
                                    stdin=subprocess.DEVNULL, stdout=full, stderr=subprocess.PIPE)
        self.assertEqual(result.returncode, 3)
        self.check_journal(0)

    def test_results_do_not_depend_on_streams(self):
        layout = self.two_cubes()
        self.trivet("run", layout, "-o", "s.glb", "--report", "r.json")
        for descriptors in ([0], [1], [2], [0, 1], [0, 1, 2]):
            status, out, err = self.closed(descriptors, "run", layout, "-o", "t.glb", "--report",
                                           "t.json", "--quiet")
            self.assertEqual((status, out, err), (0, "", ""), descriptors)
            self.assertEqual(self.read("t.glb"), self.read("s.glb"))

    def test_what_cannot_be_told_is_an_error(self):
        status, _, err = self.closed([1], "schema")
        self.assertEqual(status, 3)
        self.assertIn("cannot write to the standard output", err)


class Pipes(Case):
    """Layouts that are no regular files."""

    def test_devices(self):
        for device in ("/dev/zero", "/dev/urandom"):
            begin = time.monotonic()
            self.trivet("run", device, "-o", "s.glb", status=2)
            self.assertLess(time.monotonic() - begin, 20)
        self.refused("run", "/dev/null", "-o", "s.glb", says="/dev/null: is empty")

    def test_a_pipe_that_is_fed(self):
        text = self.read(self.two_cubes())
        self.trivet("run", "layout.json", "-o", "s.glb")
        os.mkfifo(self.path("fifo"))
        writer = threading.Thread(target=self.feed, args=(text,))
        writer.start()
        self.trivet("run", "fifo", "-o", "t.glb")
        writer.join()
        self.assertEqual(self.read("t.glb"), self.read("s.glb"))
        # Models lie relative to the layout, which is in /dev/fd here.
        self.layout([{**SLAB, "model": self.path("slab.obj")}])
        for command in ('"$0" run <(cat layout.json) -o u.glb',
                        '(sleep 1; cat layout.json) | "$0" run /dev/stdin -o u.glb'):
            subprocess.run(["bash", "-c", command, PROGRAM], cwd=self.folder, check=True,
                           stdout=subprocess.DEVNULL, timeout=100)
            self.trivet("check", "u.glb")
            os.remove(self.path("u.glb"))

    def feed(self, text):
        time.sleep(0.5)
        with open(self.path("fifo"), "wb") as fifo:
            fifo.write(text[:100])
            fifo.flush()
            time.sleep(0.5)
            fifo.write(text[100:])

    def test_an_empty_pipe_is_empty(self):
        for command in ('"$0" run <(true) -o u.glb', 'true | "$0" run /dev/stdin -o u.glb'):
            result = subprocess.run(["bash", "-c", command, PROGRAM], cwd=self.folder, timeout=100,
                                    capture_output=True)
            self.assertEqual(result.returncode, 2)
            self.assertIn(b"is empty", result.stderr)

    def test_a_pipe_that_nobody_feeds(self):
        os.mkfifo(self.path("fifo"))
        begin = time.monotonic()
        self.trivet("run", "fifo", "-o", "s.glb", status=2)
        self.assertLess(time.monotonic() - begin, 60)
        out, err = self.trivet("check", "fifo", status=2)
        self.assertIn("fifo", err)

    def test_an_endless_pipe(self):
        for what in ("cat /dev/zero", "yes", "echo '{'; cat /dev/zero"):
            command = '(%s) | "$0" run /dev/stdin -o u.glb' % what
            result = subprocess.run(["bash", "-c", command, PROGRAM], cwd=self.folder, timeout=100,
                                    capture_output=True)
            self.assertEqual(result.returncode, 2)
            self.assertIn(b"/dev/stdin: line ", result.stderr)


class FullDisks(Case):
    """No room for the largest of several files: nothing is half-written, nothing is left over."""

    def no_room(self, limit, *arguments):
        """The program may write no file of more bytes. It must fail and leave all as it was."""
        before = {name: self.read(name) for name in self.files()}
        folders = {folder for folder, _, _ in os.walk(self.folder)}

        def set_limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)  # write() fails, as on a full disk
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
        result = subprocess.run([PROGRAM, *arguments], cwd=self.folder, preexec_fn=set_limit,
                                restore_signals=False, capture_output=True, timeout=100, stdin=subprocess.DEVNULL)
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn(b"File too large", result.stderr)
        self.assertNotIn(b"temporary", result.stderr)
        self.assertEqual({name: self.read(name) for name in self.files()}, before)
        self.assertEqual({folder for folder, _, _ in os.walk(self.folder)}, folders)

    def test_exports_of_several_files(self):
        self.write("grid.obj", grid_obj(30))
        layout = self.layout([{**SLAB, "model": "grid.obj"}])
        self.trivet("run", layout, "-o", "s.glb")
        for name in ("a.obj", "a.gltf"):
            self.no_room(2000, "run", layout, "-o", name)
        for name in ("a.urdf", "a.xml", "a.usda"):
            for more in ((), ("--meshes", "deep/below")):  # the scene is read through a smaller file
                self.no_room(48_000, "export", "s.glb", "-o", name, *more)
        # Old files stay.
        self.trivet("run", layout, "-o", "a.obj")
        self.write("a.mtl", self.read("a.mtl") + b"# changed\n")
        self.no_room(2000, "run", layout, "-o", "a.obj")

    def test_data_sets_and_labels_of_several_views(self):
        views = ("--dome", 3, "--width", 64, "--height", 48, "--samples", 1)
        self.trivet("render", "slab.obj", "--coco", "c", *views)
        size = max(len(self.read(n)) for n in self.files() if n.startswith("c/"))
        shutil.rmtree(self.path("c"))
        for form in ("--coco", "--bop"):
            self.no_room(size // 2, "render", "slab.obj", form, "new/set", *map(str, views))
        os.mkdir(self.path("old"))
        self.write("old/mine", "mine")
        self.no_room(size - 1, "render", "slab.obj", "--coco", "old", *map(str, views))
        self.no_room(size - 1, "render", "slab.obj", "--ids", "ids_{}.png", "--boxes", "b_{}.json", "--coco", "old",
                     *map(str, views))

    def test_journals(self):
        """No room for the copy of the start, for the first line, for a model."""
        self.write("grid.obj", grid_obj(30))
        layout = self.layout([{**SLAB, "model": "grid.obj"}] + [
            {"name": "n%d" % i, "model": "cube.obj", "fixed": True, "position": [i, 0, 1], "rotation": [3, 1, 1, 2]} for i in range(30)])
        self.assertEqual(self.run_session(layout), 0)
        start, line = len(self.read("j.start")), len(self.read("j"))
        self.assertLess(start, line)
        model = max(os.path.getsize(self.path(name)) for name in self.files() if name.startswith("j.models/"))
        self.assertLess(line, model)
        for name in [name for name in self.files() if name.startswith("j")]:
            os.remove(self.path(name))
        os.rmdir(self.path("j.models"))
        for limit in (start - 1, line - 1, model - 1):
            self.no_room(limit, "session", layout, "--journal", "j", "--keep-models")

    def run_session(self, layout):
        return subprocess.run([PROGRAM, "session", layout, "--journal", "j", "--keep-models"], cwd=self.folder, stdin=subprocess.DEVNULL,
                              capture_output=True, timeout=100).returncode

    def test_a_scene_and_its_report(self):
        layout = self.two_cubes()
        self.trivet("run", layout, "-o", "s.stl", "--report", "r.json")
        size = len(self.read("s.stl"))
        self.assertGreater(len(self.read("r.json")), size)
        os.remove(self.path("s.stl"))
        os.remove(self.path("r.json"))
        self.no_room(size + 10, "run", layout, "-o", "s.stl", "--report", "r.json")


if __name__ == "__main__":
    main()
