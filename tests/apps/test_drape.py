"""Cloths and cables: the verb, layouts, sessions, checks, exports and films."""
import json
import struct

from live_session import Live, SessionCase
from program import box_obj, grid_obj, main, put

BLOCK = {"name": "block", "model": "block.obj", "up": "z", "fixed": True, "position": [0, 0, 0.150001]}
CLOTH = {"op": "drape", "object": "cloth", "size": [0.3, 0.3], "cell": 0.025, "position": [0, 0, 0.32]}


class Drape(SessionCase):
    def setUp(self):
        super().setUp()
        self.write("block.obj", box_obj(0.08, 0.08, 0.15))

    def draped(self, *operations, name="s.glb", more=()):
        layout = self.layout([BLOCK, {"name": "a", "model": "cube.obj", "scale": 0.4}], [CLOTH, *operations])
        self.trivet("run", layout, "-o", name, "--report", "r.json", *more)
        return self.read_json("r.json")

    def flexible(self, report, name="cloth"):
        return next(o for o in report["objects"] if o["name"] == name)["flexible"]

    def test_layouts_give_the_same_bytes_by_any_number_of_threads(self):
        report = self.draped(put("a", 0, 0, 1))
        self.assertEqual([o["ended"] for o in report["operations"]], ["at_rest", "at_rest"])
        self.assertTrue(report["check"]["all_at_rest"])
        cloth = self.flexible(report)
        self.assertLess(cloth["net_force"], 1e-3)
        self.assertTrue(cloth["stable"])
        self.assertAlmostEqual(cloth["balance"], 1, 4)
        self.assertEqual([s["name"] for s in cloth["supports"]], ["block"])
        for threads in (1, 2, 8):
            self.draped(put("a", 0, 0, 1), name="t.glb", more=("--threads", threads))
            self.assertEqual(self.read("t.glb"), self.read("s.glb"))
        self.trivet("check", "s.glb")

    def test_the_verb_drapes_a_cable_and_a_mesh(self):
        self.write("grid.obj", grid_obj(12))
        layout = self.layout([BLOCK, {"name": "grid", "model": "grid.obj", "up": "z", "scale": 0.3}], [])
        self.trivet("run", layout, "-o", "s.glb")
        self.trivet("drape", "s.glb", "lead", "--path", -0.15, 0, 0.31, 0.35, 0, 0.31, "--cell", 0.02, "-o", "c.glb")
        self.trivet("drape", "c.glb", "napkin", "--of", "grid", "--position", -0.1, -0.15, 0.34, "-o", "n.glb",
                    "--report", "n.json")
        self.assertEqual(self.flexible(self.read_json("n.json"), "napkin")["vertices"], 169)
        self.trivet("check", "n.glb")
        for name, size, z, steps, says in (("block", 0.3, 1, 9, "block"), ("x", 0.3, 0.2, 9, '"block"'),
                                           ("x", 0.3, 0.32, 2, "did not come to rest")):
            out, _ = self.trivet("drape", "s.glb", name, "--size", size, size, "--position", 0, 0, z,
                                 "--steps", steps, "-o", "x.glb", status=1)
            self.assertIn(says, out)
        self.refused("drape", "s.glb", "x", "--path", 0, 0, 1, "-o", "x.glb", says=["two or more"])

    def test_recipes_drape_and_keep_the_shapes_in_scenes(self):
        group = {"name": "a", "models": [{"model": "cube.obj", "scale": 0.2}], "count": 1, "on": "block"}
        self.write("recipe.json", json.dumps({
            "trivet_recipe": 1, "objects": [BLOCK], "operations": [{**CLOTH, "cell": 0.05}], "groups": [group]}))
        self.trivet("batch", "recipe.json", "--count", 1, "--out", "b", "--format", "dir", "--with", "scene")
        self.trivet("check", "b/0000/scenes-000000/000000000.glb")
        # A napkin on each plate.
        self.write("plate.obj", box_obj(0.05, 0.05, 0.005))
        plates = {"name": "plate", "models": [{"model": "plate.obj"}], "count": 2, "on": "floor",
                  "region": [[-0.4, -0.4], [0.4, 0.4]]}
        napkin = {"op": "drape", "group": "plate", "name": "napkin", "size": [0.15, 0.15], "cell": 0.025}
        self.write("napkins.json", json.dumps({"trivet_recipe": 1, "groups": [plates], "then": [napkin]}))
        self.trivet("batch", "napkins.json", "--count", 1, "--out", "n", "--format", "dir", "--with", "scene")
        scene = self.read_json("n/0000/scenes-000000/000000000.json")
        self.assertEqual([o["name"] for o in scene["objects"] if o.get("draped")], ["napkin_0", "napkin_1"])
        self.trivet("check", "n/0000/scenes-000000/000000000.glb")
        for key, value, says in (("material", "lead", "cotton, felt"), ("group", "cups", "the name of a group"),
                                 ("size", [0.3], "size"), ("count", 2, "count")):
            self.write("bad.json", json.dumps({"trivet_recipe": 1, "groups": [plates], "then": [{**napkin, key: value}]}))
            self.refused("batch", "bad.json", "--count", 1, "--out", "x", says=says)
        rows = self.read_json("b/0000/scenes-000000/000000000.json")["objects"]
        self.assertEqual([o["class"] for o in rows if o.get("draped")], ["cloth"])
        self.refused("batch", "materialise", "b", 0, "-o", "m.glb", says=['"cloth", which was draped', "--with scene"])

    def test_check_sees_what_is_gone(self):
        self.draped()
        live = Live(self.folder, "s.glb")
        answer = live.ask(op="delete", object="block")
        self.assertEqual(answer["unsupported"], ["cloth"])
        live.ask(save="t.glb")
        self.assertEqual(live.end(), 0)
        out, _ = self.trivet("check", "t.glb", "--json", status=1)
        self.assertEqual(json.loads(out)["check"]["not_at_rest"], ["cloth"])

    def test_sessions_undo_and_replay_to_the_bit(self):
        self.draped(name="unused.glb")
        self.trivet("run", self.layout([BLOCK], []), "-o", "start.glb")
        live = Live(self.folder, "start.glb", "--journal", "j")
        first = live.ask(**CLOTH)
        self.assertEqual(first["status"], "ok")
        self.assertEqual(live.ask(undo=True)["state"], live.start["state"])
        self.assertEqual(live.ask(redo=True)["state"], first["state"])
        live.ask(save="s.glb")
        self.assertEqual(live.end(), 0)
        self.trivet("replay", "j", "-o", "t.glb")
        self.assertEqual(self.read("t.glb"), self.read("s.glb"))

    def test_scenes_keep_it_whole(self):
        report = self.draped()
        self.trivet("fix", "s.glb", "block", "-o", "t.glb", "--report", "t.json")
        self.assertEqual(self.flexible(self.read_json("t.json")), self.flexible(report))
        self.trivet("check", "t.glb")

    def test_leads_stay_with_their_lamps_in_files_and_are_draped_again(self):
        socket = {**BLOCK, "name": "socket", "position": [0.7, 0, 0.150001]}
        path = [[0.09, 0, 0.25], [0.35, 0, 0.5], [0.61, 0, 0.25]]
        lead = {"op": "drape", "object": "lead", "path": path, "cell": 0.03, "pins": [path[0], path[2]],
                "held_by": ["block", "socket"]}
        self.trivet("run", self.layout([BLOCK, socket], [lead]), "-o", "s.glb", "--report", "s.json")
        names = {s["name"] for s in self.flexible(self.read_json("s.json"), "lead")["supports"]}
        self.assertLessEqual({"block", "socket"}, names)
        self.trivet("check", "s.glb")
        self.trivet("drape", "s.glb", "lead", "--again", "-o", "t.glb", "--report", "t.json")
        again = self.flexible(self.read_json("t.json"), "lead")
        self.assertLess(again["net_force"], 1e-3)
        self.trivet("check", "t.glb")
        out, _ = self.trivet("drape", "s.glb", "socket", "--again", "-o", "x.glb", status=1)
        self.assertIn("flexible", out)

    def test_spoiled_files_are_refused(self):
        self.draped()
        data = self.read("s.glb")
        length = struct.unpack_from("<I", data, 12)[0]
        document = json.loads(data[20:20 + length])

        def spoiled(change):
            copy = json.loads(json.dumps(document))
            entry = next(o for o in self.entries(copy) if o["name"] == "cloth")
            change(entry["flexible"])
            text = json.dumps(copy).encode()
            text += b" " * (-len(text) % 4)
            self.write("x.glb", struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(data) - 20 - length,
                                            len(text), 0x4E4F534A) + text + data[20 + length:])

        for change in (lambda f: f.update(vertices=f["vertices"][:-32]), lambda f: f.update(layer=0),
                       lambda f: f.update(grid=[1e9, 1e9, 1, 1]),
                       lambda f: f.update(grid=[3, 3, 1, 1]), lambda f: f.update(faces="AAAA"),
                       lambda f: f.pop("rest")):
            spoiled(change)
            self.refused("check", "x.glb", says=["flexible"])
        # The program judges what it reads and believes none of it.
        spoiled(lambda f: f.update(layer=f["layer"] / 2))
        self.trivet("check", "x.glb", status=1)

    @staticmethod
    def entries(document):
        """The objects of Trivet's extras, wherever they are."""
        waiting = [document]
        while waiting:
            item = waiting.pop()
            if isinstance(item, dict):
                if "load_support" in item and "objects" in item:
                    return item["objects"]
                waiting += item.values()
            elif isinstance(item, list):
                waiting += item
        raise AssertionError("no extras")

    def test_exports_and_films_have_it(self):
        self.draped()
        for name in ("t.usda", "t.xml"):
            self.trivet("export", "s.glb", "-o", name)
            self.assertIn(b"cloth", self.read(name))
        self.draped(name="t.obj")
        self.assertIn(b"cloth", self.read("t.obj"))
        out, _ = self.trivet("export", "s.glb", "-o", "u.xml", "--report", "u.json")
        self.assertIn("does not bend", self.read("u.json").decode() + out)
        self.draped(name="v.glb", more=("--animation", "film.glb"))
        self.assertIn(b"cloth", self.read("film.glb"))
        self.trivet("render", "s.glb", "-o", "s.png", "--width", 160, "--height", 120, "--samples", 1)


if __name__ == "__main__":
    main()
