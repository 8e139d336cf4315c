"""Options, help, exit statuses, output streams."""
import json
import os
import pty
import subprocess
import unittest

from program import PROGRAM, SLAB, SOURCE_DIR, Case, main, put

VERBS = ("info", "run", "put", "check", "render", "demo", "schema")


class Help(Case):
    def test_every_verb_has_help_and_version(self):
        self.assertIn("trivet", self.trivet("--version")[0])
        out, _ = self.trivet("--help")
        for verb in VERBS:
            self.assertIn(verb, out)
            text, err = self.trivet(verb, "--help")
            for option in ("--detector", "--device", "--threads", "--json", "--quiet", "--verbose", "--help",
                           "--version"):
                self.assertIn(option, text)
            self.assertEqual(err, "")
            self.assertEqual(self.trivet(verb, "--version")[0], self.trivet("--version")[0])

    def test_schema_prints_the_published_file(self):
        with open(os.path.join(os.path.dirname(PROGRAM), "layout.schema.json")) as file:
            self.assertEqual(self.trivet("schema")[0], file.read())


class WrongUsage(Case):
    def test_messages_name_accepted_values(self):
        run = ("run", self.two_cubes(), "-o", "s.glb")
        for arguments, says in (
                ((), "a verb is missing; accepted verbs: info, run, put"),
                (("fly",), ["fly", "accepted verbs: info, run, put"]),
                (("run",), "layout is required"),
                (("run", "layout.json"), "--output is required"),
                ((*run, "--fast"), "run: there is no option --fast"),
                ((*run, "--repotr", "r.json"),
                 'there is no option --repotr; did you mean "--report"?'),
                (("zlist", "cube.obj", "--confirm", "yes"),
                 "yes\" is not accepted; accepted: auto, embree, off"),
                (("zlist", "cube.obj", "--gpu-lists", "cpu"),
                 '"cpu" is not accepted; accepted: auto, gpu, software'),
                ((*run, "--confirm", "off"), "there is no option --confirm"),
                ((*run, "--detector", "cuda"),
                 '"cuda" is not accepted; accepted: auto, bvh, software, gpu, framebuffer, compute'),
                (("batch", "status", "folder", "--detector", "raster"), '"raster" is not accepted'),
                ((*run, "--threads", "many"), '"many" is not accepted; accepted: whole numbers'),
                ((*run, "--threads", "-1"), '"-1" is not accepted; accepted: whole numbers from 0'),
                ((*run, "--threads", "1.5"), '"1.5" is not accepted'),
                ((*run, "--clearance", "nan"), '"nan" is not accepted; accepted: numbers from 0'),
                ((*run, "--max-motions", "0"), '"0" is not accepted'),
                (("put", "s.glb", "cube.obj", "-o", "t.glb"),
                 ["put: a place is missing; accepted: --position", "or --on"]),
                (("put", "s.glb", "cube.obj", "-o", "t.glb", "--position", "1", "2"), "--position"),
                (("put", "s.glb", "cube.obj", "-o", "t.glb", "--position", "1", "2", "inf"),
                 '"inf" is not accepted; accepted: numbers from'),
                (("put", "s.glb", "cube.obj", "-o", "t.glb", "--position", "1", "2", "3",
                  "--rotation", "0", "0", "0", "0"), "--rotation: "),
                (("put", "s.glb", "cube.obj", "-o", "t.glb", "--position", "1", "2", "3",
                  "--scale", "0"), '"0" is not accepted; accepted: numbers from 1e-15'),
                (("put", "s.glb", "cube.obj", "-o", "t.glb", "--position", "1", "2", "3",
                  "--up", "x"), '"x" is not accepted; accepted: y, z'),
                (("demo", "dinner", "-o", "s.glb"),
                 '"dinner" is not accepted; accepted: spoon-saucer, breakfast'),
                (("render", "cube.obj", "-o", "p.png", "--width", "0"), '"0" is not accepted'),
                (("render", "cube.obj", "-o", "p.jpg"), "accepted: .png"),
        ):
            with self.subTest(arguments=arguments):
                self.refused(*arguments, says=says)

    def test_negative_numbers_are_not_options(self):
        self.trivet("run", self.two_cubes(), "-o", "s.glb")
        self.trivet("put", "s.glb", "cube.obj", "--position", "-.2", "-0.2", "1e0", "-o", "t.glb",
                    "--rotation", "-1", "0", "0", "-0.5")

    def test_errors_as_json(self):
        for arguments, kind, status in ((("run", "none.json", "-o", "s.glb"), "bad input", 2),
                                        (("run", "none.json"), "usage", 2),
                                        (("demo", "breakfast", "-o", "/proc/no/s.glb"), "environment", 3)):
            out, err = self.trivet(*arguments, "--json", status=status)
            error = json.loads(out)["error"]
            self.assertEqual((error["kind"], error["status"]), (kind, status))
            self.assertTrue(error["message"])
            self.assertEqual(err, "")


class NearestNames(Case):
    """A refusal of an unknown name offers the one that was meant."""

    def test_on_the_command_line(self):
        self.trivet("run", self.layout([SLAB, {"name": "mug", "model": "cube.obj"}],
                                       [put("mug", 0, 0, 1)]), "-o", "s.glb")
        for arguments, meant in ((("pusch",), "push"), (("Run", "layout.json"), "run"),
                                 (("run", "layout.json", "-o", "t.glb", "--detector", "GPU"), "gpu"),
                                 (("demo", "brekfast", "-o", "t.glb"), "breakfast"),
                                 (("push", "s.glb", "Mug", "--to", 0, 0, "-o", "t.glb"), "mug"),
                                 (("fix", "s.glb", "slap", "-o", "t.glb"), "slab")):
            self.refused(*arguments, says='did you mean "%s"?' % meant)
        self.refused("check", "s.glb", "--object", "Slab", says='did you mean "slab"?')
        err = self.refused("push", "s.glb", "teapot", "--to", 0, 0, "-o", "t.glb", says="teapot")
        self.assertNotIn("mean", err)

    def check_layout(self, text, meant):
        self.refused("run", self.write("l.json", json.dumps(text)), "-o", "t.glb",
                     says='did you mean "%s"?' % meant)

    def test_in_layouts(self):
        mug = {"name": "mug", "model": "cube.obj"}
        base = {"trivet": 1, "objects": [SLAB, mug]}
        for operation, meant in ((put("Mug", 0, 0, 1), "mug"), ({"op": "Push"}, "push"),
                                 ({"op": "put", "object": "mug", "at": "anywhere", "on": "slap"},
                                  "slab"),
                                 ({"op": "pickup", "object": "mug"}, "pick_up"),
                                 ({**put("mug", 0, 0, 1), "rotaton": [1, 0, 0, 0]}, "rotation"),
                                 ({"op": "push", "object": "mug", "to": [0, 0],
                                   "together": ["Slab"]}, "slab")):
            self.check_layout({**base, "operations": [operation]}, meant)
        self.check_layout({**base, "flor": True}, "floor")
        self.check_layout({**base, "objects": [SLAB, {**mug, "Scale": 2}]}, "scale")

    def test_in_sessions(self):
        lines = [{"query": "Mug"}, {"op": "lock", "object": "mugg"}, {"op": "lok", "object": "mug"}]
        result = subprocess.run([PROGRAM, "session", self.layout([{"name": "mug",
                                                                   "model": "cube.obj"}])],
                                input="".join(json.dumps(line) + "\n" for line in lines).encode(),
                                cwd=self.folder, capture_output=True, timeout=100)
        answers = [json.loads(line) for line in result.stdout.splitlines()][1:]
        for answer, meant in zip(answers, ("mug", "mug", "lock"), strict=True):
            self.assertIn('did you mean "%s"?' % meant, answer["reason"])


class Streams(Case):
    def test_json_prints_the_report(self):
        out, err = self.trivet("run", self.two_cubes(), "-o", "s.glb", "--report", "r.json", "--json")
        self.assertEqual(json.loads(out), self.read_json("r.json"))
        self.assertEqual(err, "")

    def test_a_summary_for_people(self):
        out, err = self.trivet("run", self.two_cubes(), "-o", "s.glb")
        self.assertIn("3 objects, 3 in the scene; 2 operations, 0 refused", out)
        self.assertIn("check: ok", out)
        self.assertEqual(err, "")

    def test_quiet(self):
        self.assertEqual(self.trivet("run", self.two_cubes(), "-o", "s.glb", "--quiet"), ("", ""))

    def on_a_terminal(self, *arguments):
        """The program's standard error on a terminal."""
        ours, theirs = pty.openpty()
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stderr=theirs,
                                   stdout=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
        os.close(theirs)
        text = b""
        try:
            while block := os.read(ours, 4096):
                text += block
        except OSError:  # the other end is closed
            pass
        os.close(ours)
        self.assertEqual(process.wait(timeout=60), 0)
        return text.decode()

    def test_progress_only_on_a_terminal(self):
        run = ("run", self.two_cubes(), "-o", "s.glb")
        text = self.on_a_terminal(*run)
        self.assertIn("put a", text)
        self.assertIn("load slab.obj", text)
        self.assertTrue(text.endswith("\r\033[K"), repr(text))
        self.assertEqual(self.on_a_terminal(*run, "--quiet"), "")

    def test_full_disk_on_standard_output(self):
        with open("/dev/full", "w") as full:
            result = subprocess.run([PROGRAM, "schema"], stdout=full, stderr=subprocess.PIPE)
        self.assertEqual(result.returncode, 3)
        self.assertIn(b"trivet: cannot write to the standard output", result.stderr)


class Info(Case):
    def test_text(self):
        out, _ = self.trivet("info", "slab.obj")
        for part in ("format      obj", "triangles   12, vertices 8, components 1", "closed      yes",
                     "1 1 0.1", "up          z", "by volume", "volume      0.1"):
            self.assertIn(part, out)

    def test_json(self):
        info = json.loads(self.trivet("info", "slab.obj", "--json")[0])
        self.assertEqual((info["triangles"], info["vertices"], info["closed"]), (12, 8, True))
        self.assertEqual(info["mass_rule"], "volume")
        self.assertAlmostEqual(info["volume"], 0.1, places=6)


if __name__ == "__main__":
    main()
