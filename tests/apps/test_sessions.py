"""Live sessions over standard input, their journals, and their bytes."""
import json
from pathlib import Path

from live_session import Live, SessionCase
from program import SLAB, SOURCE_DIR, main, put

CASES = Path(SOURCE_DIR) / "tests/core/io/foreign/cases"


class Sessions(SessionCase):
    def test_a_dialogue(self):
        live = Live(self.folder, self.start_layout())
        self.assertEqual(live.start["done"], 0)
        first = live.ask(**put("b", 0.01, 0.02, 1))
        self.assertEqual((first["status"], first["done"], first["modified"]), ("ok", 1, True))
        self.assertEqual(live.ask(undo=True)["state"], live.start["state"])
        self.assertEqual(live.ask(undo=True)["status"], "refused")
        self.assertEqual(live.ask(redo=True)["state"], first["state"])
        held = live.ask(query="b")
        self.assertEqual([h["name"] for h in held["held_by"]], ["a"])
        self.assertEqual(live.ask(query="slab")["carries"], ["a", "b"])
        self.assertTrue(held["with_all_free"]["stable"])
        self.assertEqual(live.ask(save="s.glb")["modified"], False)
        for line in ({"nonsense": 1}, {"undo": False}, {"cancel": False},
                     {"undo": True, "redo": True}):
            answer = live.ask(**line)
            self.assertEqual(answer["status"], "error", line)
            self.assertIn("accepted", answer["reason"])
        self.assertEqual(live.ask(save="s.txt")["status"], "error")
        self.assertIn("reaches below", live.ask(**put("b", 0, 0, -1))["reason"])
        self.assertEqual(live.end(), 0)
        self.trivet("check", "s.glb")

    def test_journal_replays_to_the_same_bits(self):
        live = Live(self.folder, self.start_layout(), "--journal", "j")
        live.ask(**put("b", 0.01, 0.02, 1))
        live.ask(op="append", object="c", model="cube.obj", scale=0.5)
        last = live.ask(**put("c", 0.1, 0, 1))
        live.ask(op="delete", object="a")
        self.assertEqual(live.ask(undo=True)["state"], last["state"])
        live.ask(save="s.glb")
        self.assertEqual(live.end(), 0)
        self.trivet("replay", "j", "-o", "t.glb", "--report", "t.json")
        self.assertEqual(self.read("t.glb"), self.read("s.glb"))
        operations = self.read_json("t.json")["operations"]
        self.assertEqual([(o["op"], o["ended"]) for o in operations],
                         [("put", "at_rest"), ("append", "done"), ("put", "at_rest")])
        self.assertGreater(operations[0]["motions"], 0)
        again = Live(self.folder, "--journal", "j")
        self.assertEqual(again.start["state"], last["state"])
        self.assertEqual((again.start["done"], again.start["steps"]), (3, 4))
        self.assertEqual(again.ask(redo=True)["done"], 4)
        self.assertEqual(again.end(), 0)

    def test_undo_and_redo_give_the_same_bytes(self):
        live = Live(self.folder, self.start_layout())
        live.ask(**put("b", 0.01, 0.02, 1))
        live.ask(save="before.glb")
        steps = (put("b", 900, 0, 1), {"op": "push", "object": "a", "to": [0.3, 0.1]},
                 {"op": "delete", "object": "a"})
        for i, step in enumerate(steps):
            self.assertEqual(live.ask(**step)["status"], "ok")
            live.ask(save="done%d.glb" % i)
            live.ask(undo=True)
            live.ask(save="undone.glb")
            self.assertEqual(self.read("undone.glb"), self.read("before.glb"), step)
            live.ask(redo=True)
            live.ask(save="redone.glb")
            self.assertEqual(self.read("redone.glb"), self.read("done%d.glb" % i), step)
            live.ask(undo=True)
        self.assertEqual(live.end(), 0)

    def test_replay_gives_the_bytes_that_the_session_saved(self):
        live = Live(self.folder, self.start_layout(), "--journal", "j")
        live.ask(**put("b", 0.01, 0.02, 1))
        live.ask(**put("b", 900, 0, 1))  # and back: its clearance stays that of the large scene
        live.ask(**put("b", 0.012, 0.023, 1))
        for to in ([0.3, 0.1], [0.123, -0.21], [0.05, 0.3]):
            self.assertEqual(live.ask(op="push", object="a", to=to)["carried"], ["b"])
            live.ask(op="turn", object="a", angle_deg=37)
        live.ask(save="s.glb")
        self.assertEqual(live.end(), 0)
        self.trivet("replay", "j", "-o", "t.glb")
        self.assertEqual(self.read("t.glb"), self.read("s.glb"))
        again = Live(self.folder, "--journal", "j")
        again.ask(save="u.glb")
        self.assertEqual(again.end(), 0)
        self.assertEqual(self.read("u.glb"), self.read("s.glb"))

    def test_mending_is_a_step_that_replays_to_the_same_bits(self):
        live = Live(self.folder, self.start_layout(), "--journal", "j")
        live.ask(**put("b", 0.2, 0, 1))
        live.ask(op="translate", object="b", by=[-0.11, 0, 0], free=True)
        wrong = live.ask(query="check")
        self.assertEqual([(f["kind"], f["object"], f["other"]) for f in wrong["findings"]], [("passes through", "a", "b")])
        mended = live.ask(mend={"tolerance": 0.02})
        self.assertEqual((mended["status"], mended["done"], mended["unable"]), ("ok", 3, []))
        self.assertEqual({p["object"] for p in mended["poses"]}, {m["object"] for m in mended["moved"]})
        self.assertTrue(live.ask(query="check")["ok"])
        self.assertEqual(live.ask(mend=True)["moved"], [])
        self.assertEqual(live.ask(undo=True)["state"], wrong["state"])
        self.assertEqual(live.ask(redo=True)["state"], mended["state"])
        live.ask(save="s.glb")
        self.assertEqual(live.end(), 0)
        self.trivet("replay", "j", "-o", "t.glb")
        self.assertEqual(self.read("t.glb"), self.read("s.glb"))
        again = Live(self.folder, "--journal", "j")
        self.assertEqual(again.start["state"], mended["state"])
        self.assertEqual(again.ask(settle=True)["moved"], [])
        for line in ({"mend": {"tolerance": -1}}, {"mend": {"only": ["nobody"]}}, {"mend": 1}, {"settle": {"tolerance": 1}},
                     {"move_joint": "door", "to": 1}):
            self.assertEqual(again.ask(**line)["status"], "error", line)
        self.assertEqual(again.end(), 0)

    def test_a_scene_of_another_program(self):
        self.write("drawer.xml", (CASES / "drawer.xml").read_bytes())
        live = Live(self.folder, "drawer.xml")
        self.assertEqual(len(live.ask(mend=True)["moved"]), 2)
        joint = live.ask(query="joints")["joints"][0]
        move = live.ask(move_joint="slide", to="lower")
        self.assertEqual((move["status"], move["end"], move["carried"]), ("ok", "reached", ["in the drawer"]))
        self.assertLess(move["value"], joint["value"])
        self.assertEqual(live.ask(move_joint="slide", by=-1)["end"], "limit")
        live.ask(undo=True)
        self.assertEqual(live.ask(query="joints")["joints"][0], joint)
        live.ask(**put("sunk", 0, 0, 2))  # steps that were undone are forgotten, joints too
        self.assertEqual(live.ask(query="joints")["joints"][0], joint)
        for line in ({"move_joint": "slide"}, {"move_joint": "slide", "to": "far"}, {"move_joint": "slide", "to": 0, "by": 0},
                     {"op": "delete", "object": "sunk"}, {"save": "x.glb"}):
            answer = live.ask(**line)
            self.assertEqual(answer["status"], "error", line)
            self.assertIn("accepted", answer["reason"])
        self.assertEqual(live.ask(save="x.xml")["modified"], False)
        self.assertEqual(live.end(), 0)
        self.trivet("check", "x.xml")
        self.refused("session", "drawer.xml", "--journal", "j", says="is of another program")

    def test_objects_are_arranged_in_a_drawer(self):
        for name, slide, drawer, thing in (("drawer.xml", "slide", "drawer", "sunk"), ("drawer.urdf", "slide", "drawer", "cube"),
                                           ("drawer.sdf", "unit::slide", "unit::drawer", "cube"),
                                           ("drawer.usda", "slide", "drawer", "cube")):
            for file in (name, name + ".joints.json"):
                if (CASES / file).exists():
                    self.write(file, (CASES / file).read_bytes())
            live = Live(self.folder, name)
            live.ask(settle=True)
            self.assertEqual(live.ask(move_joint=slide, to="upper")["end"], "reached")
            things = {"op": "arrange", "things": [{"objects": thing}], "relations": [{"is": "in", "a": thing, "b": drawer}]}
            answer = live.ask(**things)
            self.assertEqual((answer["status"], answer["settled"]), ("ok", [thing]))
            self.assertEqual([one["name"] for one in live.ask(query=thing)["held_by"]], [drawer])
            move = live.ask(move_joint=slide, to=0.15)
            self.assertEqual(move["end"], "reached")
            self.assertIn(thing, move["carried"])
            self.assertTrue(live.ask(query="check")["ok"])
            live.ask(save="saved " + name)
            self.assertEqual(live.end(), 0)
            self.trivet("check", "saved " + name)

    def test_ids_come_back(self):
        live = Live(self.folder, self.start_layout())
        self.assertNotIn("id", live.start)
        for i in ("a text", "", 0, -7, 1.5, 2**53 + 1):
            for line in (put("b", 0, 0, 1), {"query": "b"}, {"undo": True}, {"cancel": True},
                         {"nonsense": 1}, {"query": "none"}):
                self.assertEqual(live.ask(**line, id=i)["id"], i)
        for i in (None, True, [1], {"a": 1}):
            answer = live.ask(cancel=True, id=i)
            self.assertEqual(answer["status"], "error")
            self.assertIn("text or a number", answer["reason"])
        self.assertNotIn("id", live.ask(cancel=True))
        self.assertEqual(live.end(), 0)

    def test_answers_have_the_poses_of_all_that_moved(self):
        live = Live(self.folder, self.start_layout())
        known = {o["object"]: o for o in live.ask(query="objects")["objects"]}
        self.assertEqual(list(known), ["slab", "a", "b"])
        self.assertEqual((known["b"]["position"], known["b"]["state"]), (None, "unplaced"))
        self.assertTrue(known["slab"]["fixed"])
        moved = []
        for line in (put("b", 0.01, 0.02, 1), {"op": "push", "object": "a", "to": [0.3, 0]},
                     {"undo": True}, {"redo": True}, {"op": "delete", "object": "b"},
                     {"op": "lock", "object": "slab"}, {"undo": True}, {"undo": True},
                     {"op": "duplicate", "object": "b", "as": "c"},
                     {"op": "rename", "object": "a", "to": "d"}, {"undo": True}):
            poses = live.ask(**line)["poses"]
            moved.append([p["object"] for p in poses])
            for pose in poses:
                self.assertEqual(list(pose), ["object", "position", "rotation"])
                known[pose["object"]] = {**known.get(pose["object"], {}), **pose}
        self.assertEqual(moved, [["b"], ["a", "b"], ["a", "b"], ["a", "b"], ["b"], [], [], ["b"],
                                 ["c"], ["a", "d"], ["d", "a"]])
        self.assertIsNone(known["c"]["position"])
        for now in live.ask(query="objects")["objects"]:
            for key in ("position", "rotation"):
                self.assertEqual(now[key], known[now["object"]][key], now["object"])
        self.assertEqual(live.ask(query="b")["poses"], [])
        self.assertEqual(live.end(), 0)

    def test_a_name_that_another_object_takes_is_not_gone(self):
        live = Live(self.folder, self.layout(
            [SLAB, {"name": "b", "model": "cube.obj"}, {"name": "a", "model": "cube.obj"}],
            [put("b", 0, 0, 1), put("a", 0.3, 0, 1)]))
        answer = live.ask(do=[{"op": "delete", "object": "a"}, {"op": "rename", "object": "b", "to": "a"}])
        self.assertEqual([(p["object"], p["position"] is None) for p in answer["poses"]],
                         [("b", True), ("a", False)])
        undone = live.ask(undo=True)
        self.assertEqual(sorted((p["object"], p["position"] is None) for p in undone["poses"]),
                         [("a", False), ("b", False)])
        self.assertEqual(live.end(), 0)

    def test_an_object_called_objects(self):
        live = Live(self.folder, self.start_layout())
        live.ask(op="duplicate", object="a", **{"as": "objects"})
        self.assertEqual(len(live.ask(query="objects")["objects"]), 4)
        self.assertEqual(live.ask(query={"object": "objects"})["name"], "objects")
        self.assertEqual(live.ask(query={"name": "a"})["status"], "error")
        self.assertEqual(live.end(), 0)

    def test_several_operations_as_one_step(self):
        live = Live(self.folder, self.start_layout(), "--journal", "j")
        push = {"op": "push", "object": "a", "to": [0.3, 0]}
        answer = live.ask(do=[put("b", 0.01, 0.02, 1), push])
        self.assertEqual((answer["status"], answer["done"]), ("ok", 1))
        self.assertEqual([(r["op"], r["object"], r["ended"]) for r in answer["results"]],
                         [("put", "b", "at_rest"), ("push", "a", "reached")])
        self.assertEqual([p["object"] for p in answer["poses"]], ["a", "b"])
        # All or nothing.
        refused = live.ask(do=[{"op": "unfix", "object": "slab"}, put("b", 0, 0, -1)])
        self.assertEqual((refused["status"], refused["poses"]), ("refused", []))
        self.assertIn("reaches below", refused["reason"])
        for wrong in ([], push, [push, {"undo": True}]):
            self.assertEqual(live.ask(do=wrong)["status"], "error", wrong)
        state = live.ask(cancel=True)
        self.assertEqual((state["state"], state["done"]), (answer["state"], 1))
        live.ask(save="s.glb")
        self.assertEqual(live.ask(undo=True)["state"], live.start["state"])
        live.ask(redo=True)
        self.assertEqual(live.end(), 0)
        self.trivet("replay", "j", "-o", "t.glb")
        self.assertEqual(self.read("t.glb"), self.read("s.glb"))

    def test_answers_report_the_outcome(self):
        live = Live(self.folder, self.start_layout())
        answer = live.ask(**put("b", 0.01, 0.02, 1))
        self.assertEqual(answer["ended"], "at_rest")
        answer = live.ask(op="push", object="a", to=[0.3, 0])
        self.assertEqual((answer["ended"], answer["carried"]), ("reached", ["b"]))
        self.assertAlmostEqual(answer["moved"], 0.3, places=4)
        answer = live.ask(op="pick_up", object="slab", distance=1)
        self.assertEqual(answer["status"], "refused")
        answer = live.ask(op="translate", object="b", by=[0, 0, -0.02], free=True)
        self.assertEqual(answer["interpenetrates"], ["a"])
        live.ask(undo=True)
        answer = live.ask(op="delete", object="a")
        self.assertEqual((answer["ended"], answer.get("unsupported")), ("done", None))
        self.assertEqual([g["name"] for g in answer["gave_way"]], ["b"])
        self.assertGreater(answer["gave_way"][0]["moved"], 0.05)
        self.assertEqual(live.end(), 0)

    def test_objects_alone_stay_where_nothing_holds_them(self):
        live = Live(self.folder, self.start_layout(), "--objects-alone")
        live.ask(**put("b", 0.01, 0.02, 1))
        answer = live.ask(op="delete", object="a")
        self.assertEqual((answer["ended"], answer["unsupported"]), ("done", ["b"]))
        self.assertEqual(live.end(), 0)

    def test_timeout_keeps_the_scene(self):
        live = Live(self.folder, self.start_layout(), "--operation-seconds", "1e-9")
        answer = live.ask(**put("b", 0.01, 0.02, 1))
        self.assertEqual(answer["status"], "out of time")
        self.assertIn('put of "b" did not end within 1e-09 s', answer["reason"])
        now = live.ask(query="a")
        self.assertEqual(now["status"], "ok")
        self.assertEqual(live.ask(cancel=True)["state"], live.start["state"])
        self.assertEqual(live.end(), 0)
        self.refused("session", "layout.json", "--operation-seconds", "-1",
                     says='"-1" is not accepted')

    def test_later_line_cancels(self):
        live = Live(self.folder, self.start_layout())
        # Pushed back and forth, which takes far longer than reading the next line.
        ways = [[0.2 * (-1) ** i, 0.3] for i in range(20000)]
        push = {"op": "push", "object": "a", "to": [0, 0.3], "via": ways}
        for line in (push, put("b", 0, 0, 1), {"cancel": True}, put("b", 0.2, 0.2, 1)):
            live.process.stdin.write(json.dumps(line) + "\n")
        live.process.stdin.flush()
        answers = [json.loads(live.process.stdout.readline()) for _ in range(4)]
        self.assertEqual([a["status"] for a in answers], ["cancelled", "cancelled", "ok", "ok"])
        self.assertIn('push of "a" was cancelled', answers[0]["reason"])
        self.assertEqual(answers[2]["state"], live.start["state"])
        self.assertEqual(answers[3]["done"], 1)
        self.assertEqual(live.end(), 0)

    def test_bad_starts(self):
        self.refused("session", says="missing START")
        self.refused("session", "none.json", says="none.json")
        self.refused("session", "cube.obj", says=("cube.obj: is not glTF", "accepted"))
        self.refused("session", self.start_layout(), "--journal", "nowhere/j", status=3,
                     says='nowhere/j: there is no folder "nowhere"')
        self.refused("session", "--journal", "none", says="none")
        self.refused("replay", "cube.obj", "-o", "s.glb", says="is no journal")
        self.refused("replay", "none", "-o", "s.glb", says="none")

if __name__ == "__main__":
    main()
