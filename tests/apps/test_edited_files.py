"""Sessions whose start and models are edited while they run, and that are killed: what their journals restore."""
import os
import random
import signal

from live_session import Live, SessionCase
from program import SLAB, box_obj, main, put

EDITS = max(5, int(200 * float(os.environ.get("TRIVET_TEST_EFFORT", "1"))))
EACH = 5  # edits of a session
KINDS = ("in place", "replaced", "truncated", "removed", "touched")
FILES = ("layout.json", "cube.obj", "slab.obj")


class EditedFiles(SessionCase):
    def make_files(self):
        self.write("cube.obj", box_obj(0.05, 0.05, 0.05))
        self.write("slab.obj", box_obj(0.5, 0.5, 0.05))
        self.layout([SLAB, {"name": "a", "model": "cube.obj"}, {"name": "b", "model": "cube.obj"}],
                    [put("a", 0, 0, 1)])

    def other_content(self, name, chance):
        if name == "layout.json":
            return '{"trivet": 1, "objects": []}'
        return box_obj(*([0.5, 0.5, 0.05] if name == "slab.obj" else [0.05] * 3)[:2], chance.choice((0.0501, 0.2)))

    def edit(self, kind, name, chance):
        path = self.path(name)
        if kind == "touched":
            if os.path.exists(path):
                os.utime(path)
        elif kind == "removed":
            if os.path.exists(path):
                os.remove(path)
        elif kind == "truncated":
            if os.path.exists(path):
                os.truncate(path, chance.randrange(os.path.getsize(path) + 1))
        elif kind == "in place":
            with open(path, "r+" if os.path.exists(path) else "w") as file:
                file.write(self.other_content(name, chance))
        else:
            self.write("new", self.other_content(name, chance))
            os.rename(self.path("new"), path)

    def some_step(self, chance, names):
        kind = chance.random()
        if kind < 0.15:
            return {"undo": True}
        if kind < 0.25:
            return {"redo": True}
        if kind < 0.4:
            names.append("n%d" % len(names))
            return {"op": "append", "object": names[-1], "model": "cube.obj"}
        if kind < 0.45:
            return {"op": "delete", "object": chance.choice(names)}
        if kind < 0.5:
            return {"op": "fix", "object": chance.choice(names)}
        if kind < 0.6:
            return {"op": "push", "object": chance.choice(names), "direction": [1, 0], "distance": 0.02}
        return put(chance.choice(names), chance.uniform(-.2, .2), chance.uniform(-.2, .2), 1)

    def poses(self, objects):
        return {o["object"]: (o["position"], o["rotation"]) for o in objects}

    def one_session(self, seed, *options):
        """@return kinds of edits, the number of steps, and the poses at the end."""
        chance = random.Random(seed)
        self.make_files()
        for name in ("j", "j.start"):
            if os.path.exists(self.path(name)):
                os.remove(self.path(name))
        live = Live(self.folder, "layout.json", "--journal", "j", *options)
        names, edits, steps = ["a", "b"], [], 0
        for i in range(4 * EACH):
            if i % 4 == 3:
                edits.append((chance.choice(KINDS), chance.choice(FILES)))
                self.edit(*edits[-1], chance)
            steps += live.ask(**self.some_step(chance, names))["status"] == "ok"
        poses = self.poses(live.ask(query="objects")["objects"])
        live.process.kill()
        self.assertEqual(live.process.wait(), -signal.SIGKILL)
        for stream in (live.process.stdin, live.process.stdout, live.process.stderr):
            stream.close()
        return edits, steps, poses

    def replayed(self):
        self.trivet("replay", "j", "-o", "r.glb", status=(0, 1))
        live = Live(self.folder, "r.glb")
        poses = self.poses(live.ask(query="objects")["objects"])
        self.assertEqual(live.end(), 0)
        return poses

    def test_edits_at_any_moment_lose_no_step(self):
        table = {}
        steps = 0
        for seed in range(EDITS // EACH):
            edits, num, expected = self.one_session(seed)
            steps += num
            self.assertEqual(self.replayed(), expected, "seed %d: %s" % (seed, edits))
            for kind in edits:
                table[kind] = table.get(kind, 0) + 1
        print("%d edits, %d steps, 0 lost" % (sum(table.values()), steps))
        for kind in KINDS:
            print("  %-10s" % kind, *("%s %d" % (f, table.get((kind, f), 0)) for f in FILES))

    def test_kept_models_restore_to_the_bit(self):
        for seed in range(max(1, EDITS // EACH // 8)):
            _, _, expected = self.one_session(1000 + seed, "--keep-models")
            self.assertEqual(self.replayed(), expected)
            live = Live(self.folder, "--journal", "j")  # it goes on
            self.assertEqual(self.poses(live.ask(query="objects")["objects"]), expected)
            self.assertEqual(live.end(), 0)

    def test_replay_says_which_model_changed(self):
        self.make_files()
        live = Live(self.folder, "layout.json", "--journal", "j")
        self.assertEqual(live.ask(**put("b", 0.2, 0.2, 1))["status"], "ok")
        self.assertEqual(live.end(), 0)
        self.write("cube.obj", box_obj(0.0501, 0.0501, 0.0501))
        _, err = self.trivet("replay", "j", "-o", "r.glb", status=1)
        self.assertIn('"cube.obj" has changed since the session', err)
        self.trivet("session", "--journal", "j", status=2)


if __name__ == "__main__":
    main()
