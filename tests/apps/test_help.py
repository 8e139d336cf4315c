"""--help of every verb: its own options first, defaults, and examples that run as they stand."""
import json
import os
import re
import signal
import subprocess
import unittest

from program import PROGRAM, SLAB, SOURCE_DIR, Case, main, put

COMMON = "Options of all verbs:"
RECIPE = {"trivet_recipe": 1, "objects": [SLAB],
          "groups": [{"name": "mug", "models": [{"model": "mug.obj"}], "count": 1, "rotation": "yaw", "on": "slab"}]}
PROBLEM = {"trivet": 1, "objects": [SLAB, {"name": "mug", "model": "mug.obj"}],
           "arrange": {"relations": [{"is": "on", "a": "mug", "b": "slab"}]}}
OPERATIONS = '{"op": "push", "object": "mug", "direction": [1, 0], "distance": 0.1}\n{"query": "mug"}\n'

REQUESTS = '{"jsonrpc": "2.0", "id": 1, "method": "tools/list"}\n'

KITCHEN = """<mujoco><worldbody>
  <geom type="plane" size="1 1 1"/>
  <body name="drawer" pos="0.5 0 0.2"><joint name="drawer" type="slide" axis="0 -1 0" range="0 0.3"/>
    <geom type="box" size="0.2 0.2 0.02"/></body>
  <body name="pan" pos="0 0 0.05"><freejoint/><geom type="box" size="0.1 0.1 0.05"/></body>
</worldbody></mujoco>
"""


class HelpCase(Case):
    def help(self, *verb):
        text, err = self.trivet(*verb, "--help")
        self.assertEqual(err, "")
        return text

    def verbs(self):
        listed = self.help().split("Subcommands:\n")[1].split("\n\n")[0]
        return re.findall(r"^  ([a-z-]+) ", listed, re.M)


class Layout(HelpCase):
    def test_own_options_come_before_those_of_all_verbs(self):
        verbs = self.verbs()
        self.assertGreater(len(verbs), 20)
        for verb in verbs:
            text = self.help(verb)
            with self.subTest(verb=verb):
                self.assertEqual(text.count(COMMON), 1)
                own, common = text.split(COMMON)
                options = re.findall(r"^  (-.*?)(?:  |$)", common.split("Examples:")[0], re.M)
                self.assertEqual(len(options), 8)
                for option in options:
                    self.assertRegex(option, "detector|device|threads|json|quiet|verbose|help|version")
                    self.assertNotIn("\n  " + option + " ", own)
                self.assertEqual(" ".join(text.split()).count("not depend on it"), 1)

    def test_lines_fit(self):
        for verb in ([], *([verb] for verb in self.verbs())):
            for line in self.help(*verb).split("Examples:")[0].splitlines():
                if line.startswith(" " * 30):
                    self.assertLessEqual(len(line), 100, verb)

    def test_defaults_types_and_accepted_values(self):
        text = " ".join(self.help("serve").split())
        self.assertIn("--max-sessions INTEGER Sessions at a time (default: 64)", text)
        self.assertIn("--socket PATH", text)
        self.assertIn("(not with --address, --host, --port)", text)
        text = " ".join(self.help("put").split())
        self.assertIn("(default: 1 0 0 0)", text)
        self.assertIn("--up y|z", text)
        self.assertIn("from which it falls (metres)", text)
        self.assertIn("--detector, --backend auto|bvh|software|gpu|framebuffer|compute", text)
        for verb in self.verbs():
            self.assertNotRegex(self.help(verb), r"default: .*\(default:|TEXT=|\{false\}|\[\]")


class Words(HelpCase):
    def test_the_page_of_words_has_the_texts_of_the_program(self):
        with open(os.path.join(SOURCE_DIR, "docs/design/words.md"), encoding="utf-8") as page:
            rows = re.findall(r"^\| `(.+?)` \| (.+?) \| (.+?) \|$", page.read(), re.M)
        self.assertEqual(len(rows), 20)
        for option, before, now in rows:
            verb, _, name = option.partition(" ")
            text = " ".join(self.help(verb).split())
            with self.subTest(option=option):
                self.assertIn(name, text)
                self.assertIn(now, text)
                self.assertNotIn(before, text)


class Examples(HelpCase):
    """Runs what each verb's help shows, in a folder with the files it names."""

    def setUp(self):
        super().setUp()
        self.write("mug.obj", self.read("cube.obj"))
        self.write("layout.json", json.dumps({"trivet": 1, "objects": [SLAB, {"name": "mug", "model": "mug.obj"}],
                                              "operations": [put("mug", 0, 0, 0.5)]}))
        self.write("recipe.json", json.dumps(RECIPE))
        self.write("problem.json", json.dumps(PROBLEM))
        self.write("operations.jsonl", OPERATIONS)
        self.write("kitchen.xml", KITCHEN)
        self.write("models/mug.obj", self.read("cube.obj"))
        self.write("requests.jsonl", REQUESTS)
        self.environment = {**os.environ, "PATH": os.path.dirname(PROGRAM) + ":" + os.environ["PATH"],
                            "XDG_CACHE_HOME": self.path("cache")}
        self.trivet("run", "layout.json", "-o", "scene.glb", "--report", "first.json")
        joints = {"drawer": {"slide": [1, 0, 0], "lower": 0, "upper": 0.2}, "door": {"hinge": [0, 0, 1]}}
        links = [{"name": name, "model": "cube.obj", "position": [3 * n, 0, 2], "joint": {"in": SLAB["name"], **joint}}
                 for n, (name, joint) in enumerate(joints.items())]
        self.write("kitchen.json", json.dumps({"trivet": 1, "objects": [SLAB, *links]}))
        self.trivet("run", "kitchen.json", "-o", "kitchen.glb")

    def examples(self, verb):
        lines = self.help(verb).split("Examples:\n")[1].splitlines()
        return [line.strip() for line in lines if line.strip()]

    def run_line(self, line):
        result = subprocess.run(["bash", "-c", line], cwd=self.folder, env=self.environment, capture_output=True,
                                text=True, timeout=300, stdin=subprocess.DEVNULL)
        held_up = " pick-up " in line  # in the air, so that the check fails
        self.assertEqual(result.returncode, int(held_up), line + "\n" + result.stdout + result.stderr)

    def run_server(self, line):
        server = subprocess.Popen(["bash", "-c", "exec " + line.replace("8080", "0")], cwd=self.folder,
                                  env=self.environment, stdout=subprocess.PIPE, text=True)
        self.assertIn("serving", server.stdout.readline())
        server.send_signal(signal.SIGTERM)
        self.assertEqual(server.wait(60), 0, line)
        server.stdout.close()

    def check_verb(self, verb):
        examples = self.examples(verb)
        self.assertGreaterEqual(len(examples), 2)
        for line in examples:
            with self.subTest(line=line):
                self.assertIn("trivet " + verb + " ", line + " ")
                if verb == "serve":
                    self.run_server(line)
                else:
                    self.run_line(line)

    def test_no_option_of_all_verbs_is_refused(self):
        """Each verb accepts all that --help offers every verb; detectors take turns, test_batch_detectors.py tries all."""
        scene, texts = self.read("scene.glb"), {verb: self.help(verb) for verb in sorted(self.verbs())}
        for n, (verb, text) in enumerate(texts.items()):
            if verb in ("serve", "replay"):  # wait for clients; need a journal
                continue
            detectors = re.search(r"--detector, --backend (\S+)", text).group(1).split("|")
            self.assertEqual(len(detectors), 6)
            for detector, more in ((detectors[n % 6], "--device auto --threads 2 --quiet"),
                                   (detectors[(n + 3) % 6], "--json --verbose")):
                self.write("scene.glb", scene)  # examples may write another
                with self.subTest(verb=verb, detector=detector):
                    self.run_line(self.examples(verb)[0].replace(
                        "trivet " + verb, f"trivet {verb} --detector {detector} {more}", 1))

    def test_every_verb_has_some_that_run(self):
        verbs = self.verbs()
        if not self.trivet("serve", "scene.glb", "--address", "nowhere", status=(2, 3))[1].count("nowhere"):
            verbs.remove("serve")  # built without the server
        for verb in sorted(verbs, key=lambda verb: verb == "replay"):  # restores the session of an example
            self.check_verb(verb)


class MissingFolders(Case):
    def test_are_made_when_all_is_written(self):
        self.trivet("run", self.two_cubes(), "-o", "a/b/s.glb", "--report", "c/r.json", "--picture", "d/p.png")
        for name in ("a/b/s.glb", "c/r.json", "d/p.png"):
            self.assertTrue(os.path.getsize(self.path(name)))
        self.trivet("export", "a/b/s.glb", "-o", "sim/s.xml")
        self.trivet("render", "a/b/s.glb", "-o", "e/f.png", "--width", 32, "--height", 32)

    def test_are_not_left_by_what_fails(self):
        self.write("bad.json", "{}")
        self.refused("run", "bad.json", "-o", "a/s.glb", says="trivet")
        self.assertFalse(os.path.exists(self.path("a")))


class WrongKinds(Case):
    def test_scenes_and_layouts_are_told_apart(self):
        layout = self.two_cubes()
        self.trivet("run", layout, "-o", "s.glb")
        self.refused("run", "s.glb", "-o", "t.glb", says=["s.glb: is a scene", "run takes a layout (.json)"])
        self.refused("push", layout, "a", "--to", 0, 0, "-o", "t.glb", says=[layout, "run makes of a layout"])


if __name__ == "__main__":
    main()
