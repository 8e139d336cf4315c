"""Files that an earlier version wrote (tests/fixtures): layouts, scenes, journals, recipes, batches open with the same bits."""
import json
import os
import shutil

from live_session import Live
from program import SOURCE_DIR, Case, main

FIXTURES = os.path.join(SOURCE_DIR, "tests", "fixtures")


class EarlierFiles(Case):
    """Every folder of fixtures holds the files of one version, and in expected.json the poses and states that it gave."""

    def versions(self):
        for name in sorted(os.listdir(FIXTURES)):
            shutil.copytree(os.path.join(FIXTURES, name), self.path(name))
            yield name + "/", self.read_json(name + "/expected.json")

    def poses(self, report):
        return {o["name"]: o["world_from_file"] for o in self.read_json(report)["objects"]}

    def expect_poses(self, found, expected):
        """The same but for roundings: text is read as doubles since, and clearances follow what is near."""
        self.assertEqual(set(found), set(expected))
        for name, matrix in expected.items():
            if matrix is None:
                self.assertIsNone(found[name])
                continue
            for a, b in zip(found[name], matrix):
                self.assertAlmostEqual(a, b, 4, name)

    def state(self, *arguments):
        live = Live(self.folder, *arguments)
        self.assertEqual(live.end(), 0)
        return live.start["state"]

    def test_layouts_and_arrangements(self):
        for folder, expected in self.versions():
            self.trivet("run", folder + "layout.json", "-o", "l.glb", "--report", "l.json")
            self.expect_poses(self.poses("l.json"), expected["layout.json"])
            self.trivet("arrange", folder + "arrange.json", "-o", "a.glb", "--report", "a.json")
            self.expect_poses(self.poses("a.json"), expected["arrange.json"])

    def test_scenes(self):
        for folder, expected in self.versions():
            for scene in ("scene.glb", "scene.gltf"):
                self.trivet("check", folder + scene)
                self.state(folder + scene)
                self.trivet("fix", folder + scene, "a", "-o", folder + "changed.glb", "--report", "s.json")
                self.assertEqual(self.poses("s.json"), expected["layout.json"])

    def test_journals(self):
        for folder, expected in self.versions():
            for journal in ("of-layout.journal", "of-scene.journal"):
                self.trivet("replay", folder + journal, "-o", "j.glb", "--report", "j.json", status=(0, 1))
                self.expect_poses(self.poses("j.json"), expected[journal])
                before = self.read(folder + journal)
                live = Live(self.folder, "--journal", folder + journal)
                state = live.start["state"]
                self.assertEqual(live.ask(undo=True)["status"], "ok")
                self.assertEqual(live.ask(redo=True)["state"], state)
                self.assertEqual(live.end(), 0)
                self.assertTrue(self.read(folder + journal).startswith(before))
                self.assertEqual(self.state("--journal", folder + journal), state)

    def test_recipes_and_batches(self):
        for folder, _ in self.versions():
            self.trivet("batch", "verify", folder + "batch")
            self.trivet("batch", "merge", folder + "batch", "-o", "m.jsonl")
            rows = [json.loads(line) for line in self.read("m.jsonl").splitlines()]
            self.assertEqual([row["status"] for row in rows], ["ok"] * 6)
            self.trivet("batch", "materialise", folder + "batch", 3, "-o", "3.glb")
            self.trivet("check", "3.glb")
            # Another version does not go on with a batch; the recipe gives nearly the same poses anew.
            again = (folder + "recipe.json", "--count", 6, "--seed", 7, "--per-tar", 3, "--quiet")
            before = {name: self.read(name) for name in self.files() if name.startswith(folder + "batch/")}
            self.refused("batch", *again, "--with", "scene", "--out", folder + "batch", says=["version"])
            self.assertEqual({name: self.read(name) for name in before}, before)
            self.trivet("batch", *again, "--out", folder + "anew")
            for k in range(6):
                self.expect_poses(self.poses_of(folder + "anew", k), self.poses_of(folder + "batch", k))

    def poses_of(self, batch, k):
        self.trivet("batch", "materialise", batch, k, "-o", "k.glb")
        self.trivet("export", "k.glb", "-o", "k.jsonl")
        rows = [json.loads(line) for line in self.read("k.jsonl").splitlines()]
        return {row["name"]: None if row["x"] is None else [row[f"m{i}{j}"] for i in range(3) for j in range(4)] for row in rows}


if __name__ == "__main__":
    main()
