"""Scenes of other programs on the command line: check, settle, mend, joint, intent; hostile files."""
import base64
import json
import math
import os
import random
import re
import struct
import time
import unittest
from pathlib import Path

from program import SOURCE_DIR, Case, main

CASES = Path(SOURCE_DIR) / "tests" / "core" / "io" / "foreign" / "cases"
TABLE = """<mujoco><worldbody><geom type="plane" size="2 2 .1"/>
<body name="table" pos="0 0 .2"><geom type="box" size=".5 .5 .2"/></body>
<body name="a" pos="0 0 .447"><freejoint/><geom type="box" size=".05 .05 .05"/></body>
<body name="b" pos=".097 0 .46"><freejoint/><geom type="box" size=".05 .05 .05"/></body>
</worldbody></mujoco>
"""
GOOD = TABLE.replace(".447", ".45").replace(".097 0 .46", ".3 0 .45")


class ScenesCase(Case):
    def setUp(self):
        super().setUp()
        self.write("drawer.xml", (CASES / "drawer.xml").read_bytes())
        self.write("table.xml", TABLE)

    def checked(self, *arguments, status=0):
        out, _ = self.trivet("check", *arguments, "--json", status=status)
        return [json.loads(line) for line in out.splitlines()]


class Checking(ScenesCase):
    def test_findings_have_depth_height_and_names(self):
        (verdict,) = self.checked("drawer.xml", status=1)
        self.assertEqual(verdict["format"], "MJCF")
        self.assertEqual(verdict["key"], "open")
        self.assertEqual(verdict["joints"], 2)
        sunk, floating = verdict["findings"]
        self.assertEqual((sunk["kind"], sunk["object"], sunk["other"]), ("passes through", "sunk", "table"))
        self.assertAlmostEqual(sunk["depth"], 0.002, places=7)
        self.assertEqual((floating["kind"], floating["object"], floating["other"]), ("floats", "in the drawer", "drawer"))
        self.assertAlmostEqual(floating["height"], 0.01, places=9)

    def test_people_get_lines(self):
        out, _ = self.trivet("check", "drawer.xml", status=1)
        self.assertIn('"sunk" and "table"', out)
        self.assertIn("2 mm deep", out)
        self.assertIn("failed: 1 pair interpenetrates, 1 object floats", out)

    def page(self, name):
        page = self.read(name).decode()
        self.assertNotIn("://", page)
        self.assertEqual(page.count("</script>"), 2)
        return json.loads(re.search(r'id="scene">(.*?)</script>', page, re.S).group(1))

    def test_a_page_marks_the_findings(self):
        self.trivet("check", "drawer.xml", "--html", "page.html", status=1)
        data = self.page("page.html")
        names = [one["name"] for one in data["objects"]]
        self.assertEqual({name for name, one in zip(names, data["objects"]) if one["highlight"]},
                         {"sunk", "table", "in the drawer", "drawer"})
        self.assertEqual(data["verdict"], "drawer.xml: failed")
        sunk, floats = data["findings"]
        self.assertIn('"sunk" and "table" interpenetrate, 2 mm deep', sunk["text"])
        self.assertEqual([names[i] for i in sunk["objects"]], ["sunk", "table"])
        self.assertIn('"in the drawer" floats, 10 mm above "drawer"', floats["text"])
        (verdict,) = self.checked("drawer.xml", status=1)
        at = verdict["findings"][0]["point"]  # the floor is at 0 in the file, and the page's origin its middle
        self.assertAlmostEqual(sunk["point"][2] - data["floor"], at[2], places=6)
        mesh = data["meshes"][0]
        self.assertEqual(len(base64.b64decode(mesh["hull"])), 4 * 2 * 12)

    def test_pages_of_trivets_own_and_of_many(self):
        self.trivet("run", self.two_cubes(), "-o", "own.glb", "--quiet")
        self.trivet("check", "own.glb", "--html", "own.html")
        self.assertEqual(self.page("own.html")["findings"], [])
        self.trivet("check", "layout.json", "--html", "layout.html")
        self.assertEqual([one["name"] for one in self.page("layout.html")["objects"]], ["slab", "a", "b"])
        self.write("good </script>.xml", GOOD.replace('"a"', '"&lt;/script>"'))
        self.trivet("check", "table.xml", "good </script>.xml", "own.glb", "--html", "pages {}.html", status=1)
        self.assertEqual([len(self.page("pages %d.html" % k)["findings"]) for k in (1, 2, 3)], [2, 0, 0])
        self.refused("check", "table.xml", "own.glb", "--html", "page.html", says="a name with {} for the number")
        self.refused("check", "table.xml", "--html", "table.xml", says="table.xml")
        self.refused("check", "own.glb", "--html", "own.glb", says="own.glb")

    def test_many_files_are_a_table_and_lines_of_json(self):
        for i in range(3):
            self.write("set/%d.xml" % i, GOOD)
        self.write("set/bad/x.xml", TABLE)
        self.write("set/broken.xml", "<mujoco><worldbody>")
        out, _ = self.trivet("check", "set", "--report", "lines.jsonl", status=2)
        self.assertIn("5 scenes: 3 ok", out)
        self.assertIn("1 not read", out)
        lines = [json.loads(line) for line in self.read("lines.jsonl").splitlines()]
        self.assertEqual([line.get("ok") for line in lines], [True, True, True, False, None])
        self.assertIn("line 1", lines[4]["error"])

    def test_a_file_that_is_none_is_one_line_of_json_too(self):
        self.write("none.xml", "no scene")
        for others in ([], ["drawer.xml"]):
            rows = self.checked("none.xml", *others, status=2)
            self.assertEqual(len(rows), 1 + len(others))
            self.assertIn("line 1", rows[0]["error"])

    def test_a_hundred_scenes_are_quick(self):
        for i in range(100):
            self.write("set/%03d.xml" % i, GOOD)
        begin = time.monotonic()
        verdicts = self.checked("set")
        self.assertEqual(sum(v["ok"] for v in verdicts), 100)
        self.assertLess(time.monotonic() - begin, 60)

    def test_other_formats(self):
        self.write("r.urdf", """<robot name="r"><link name="l"><collision><geometry><box size="1 1 1"/></geometry>
          </collision></link></robot>""")
        self.write("w.sdf", """<sdf version="1.8"><world name="w"><model name="g"><static>1</static><link name="l">
          <collision name="c"><geometry><plane/></geometry></collision></link></model><model name="m"><pose>0 0 .6 0 0 0</pose>
          <link name="l"><collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision></link></model>
          </world></sdf>""")
        urdf, sdf = self.checked("r.urdf", "w.sdf", status=1)
        self.assertTrue(urdf["ok"])
        self.assertEqual(sdf["findings"][0]["kind"], "floats")
        self.assertAlmostEqual(sdf["findings"][0]["height"], 0.1, places=9)

    def test_usd_that_trivet_exports_comes_back(self):
        """The same verdict, pairs, joints and poses, to the last digit."""
        self.trivet("run", self.two_cubes(), "-o", "ours.glb", "--quiet")
        self.write("drawer.usda", (CASES / "drawer.usda").read_bytes())
        for name, status in (("ours.glb", 0), ("drawer.usda", 1)):
            self.trivet("export", name, "-o", "back.usda", "--quiet")
            before, after = self.checked(name, "back.usda", status=status)
            self.assertEqual(after["format"], "USD")
            for key in ("ok", "whole", "objects", "free", "joints", "pairs"):
                self.assertEqual(after[key], before[key], key)
            self.assertEqual([f["object"] for f in after["findings"]], [f["object"] for f in before["findings"]])
            poses = []
            for scene in (name, "back.usda"):
                self.trivet("export", scene, "-o", "poses.jsonl", "--quiet")
                rows = [json.loads(line) for line in self.read("poses.jsonl").decode().splitlines()]
                poses.append({row["name"]: [row[k] for k in ("x", "y", "z", "qw", "qx", "qy", "qz", "fixed")] for row in rows})
            self.assertEqual(poses[0], poses[1])
        self.assertEqual(self.trivet("joint", "back.usda")[0], self.trivet("joint", "drawer.usda")[0])

    def test_a_layout_and_a_scene_of_ours_are_judged_as_ever(self):
        self.trivet("run", self.two_cubes(), "-o", "ours.glb", "--quiet")
        self.assertIn("stable", self.trivet("check", "ours.glb")[0])
        ours, other = self.checked("ours.glb", "table.xml", status=1)
        self.assertEqual((ours["format"], ours["ok"], other["ok"]), ("Trivet", True, False))


class Repairing(ScenesCase):
    def test_settled_scenes_differ_in_numbers_alone(self):
        self.trivet("settle", "drawer.xml", "-o", "out.xml")
        before, after = self.read("drawer.xml").splitlines(), self.read("out.xml").splitlines()
        self.assertEqual(len(before), len(after))
        self.assertEqual(sum(a != b for a, b in zip(before, after)), 1)
        self.assertTrue(self.checked("out.xml")[0]["ok"])

    def test_a_true_scene_is_written_as_it_is(self):
        self.write("good.xml", GOOD)
        for verb in ("settle", "mend"):
            self.trivet(verb, "good.xml", "-o", verb + ".xml")
            self.assertEqual(self.read(verb + ".xml"), GOOD.encode())

    def test_mending_parts_what_settling_would_stack(self):
        out, _ = self.trivet("mend", "table.xml", "-o", "out.xml", "--json")
        report = json.loads(out)
        self.assertTrue(report["verdict"]["ok"])
        self.assertEqual(report["supports_kept"], report["supports_meant"])
        for move in report["moved"]:
            self.assertLess(move["metres"], 0.02, move)
            self.assertAlmostEqual(move["to"][2], 0.45, places=3)
        lines = self.trivet("mend", "table.xml", "-o", "told.xml")[0].splitlines()
        self.assertEqual(lines[0], "%d objects moved" % len(report["moved"]))
        self.assertRegex(lines[1], r'^  "\w+": [\d.]+ mm( up| down)?, turned by [\d.e-]+ degrees$')

    def test_numbers_of_all_joints_as_an_array(self):
        # Bodies of one tag have no place of their own in the file.
        self.write("three.xml", '<mujoco><worldbody><geom type="plane" size="3 3 .1"/><replicate count="3" offset=".3 0 0">'
                                '<body name="b" pos="0 0 .2"><freejoint/><geom type="box" size=".05 .05 .05"/></body>'
                                '</replicate></worldbody></mujoco>')
        self.refused("settle", "three.xml", "-o", "out.xml", says="NAME.npy")
        self.trivet("settle", "three.xml", "-o", "start.npy")
        bytes_of = self.read("start.npy")
        self.assertEqual(len(bytes_of), 128 + 21 * 8)
        numbers = struct.unpack("<21d", bytes_of[128:])
        for i in range(3):
            self.assertEqual(numbers[7 * i + 3:7 * i + 7], (1, 0, 0, 0))
            self.assertAlmostEqual(numbers[7 * i + 2], 0.05, places=4)
        self.assertTrue(self.checked("three.xml", "--key", "start.npy")[0]["ok"])
        self.trivet("mend", "three.xml", "--key", "start.npy", "-o", "again.npy")
        self.assertEqual(self.read("again.npy"), bytes_of)
        self.refused("settle", "three.xml", "--key", "start.npy", "-o", "out.xml", says="accepted: .npy")
        self.refused("settle", "three.xml", "--key", "start.npy", "-o", "start.npy", says="start.npy")
        self.trivet("joint", "drawer.xml", "slide", "--to", "0.15", "-o", "ajar.npy")
        self.assertIn("at 0.15 m", self.trivet("joint", "drawer.xml", "--key", "ajar.npy")[0])

    def test_arrays_that_do_not_fit(self):
        self.trivet("settle", "table.xml", "-o", "two.npy")
        good = self.read("two.npy")
        for name, content, says in (("short.npy", good[:-8], "14 numbers"), ("none.npy", b"", "no array"),
                                    ("long.npy", good[:8] + b"\xff\xff" + good[10:], "no array"),
                                    ("nan.npy", good[:-8] + struct.pack("<d", math.nan), "not finite"),
                                    ("int.npy", good.replace(b"<f8", b"<i8"), "float64")):
            self.write(name, content)
            self.refused("check", "table.xml", "--key", name, says=says)
        self.refused("check", "drawer.xml", "--key", "two.npy", says="in one row")
        self.refused("check", "table.xml", "--key", "missing.npy", says="cannot be read")
        self.write("f4.npy", good.replace(b"<f8", b"<f4")[:128] + struct.pack("<14f", *struct.unpack("<14d", good[128:])))
        self.assertTrue(self.checked("table.xml", "--key", "f4.npy")[0]["ok"])

    def test_no_format_is_written_under_the_name_of_another(self):
        for out in ("out.urdf", "out.glb", "out.usda"):
            self.refused("settle", "drawer.xml", "-o", out, says="accepted: .xml, .mjcf")
        self.write("world.sdf", (CASES / "world.sdf").read_bytes())
        self.refused("settle", "world.sdf", "-o", "out.npy", says="MJCF")

    def test_included_files_go_along(self):
        self.write("in/scene.xml", '<mujoco><include file="parts/a.xml"/><worldbody><geom type="plane" size="1 1 1"/>'
                                   "</worldbody></mujoco>")
        self.write("in/parts/a.xml", '<mujocoinclude><worldbody><body name="a" pos="0 0 .06"><freejoint/>'
                                     '<geom type="box" size=".05 .05 .05"/></body></worldbody></mujocoinclude>')
        os.makedirs(self.path("out/parts"))
        self.trivet("settle", "in/scene.xml", "-o", "out/scene.xml")
        self.assertEqual(self.read("out/scene.xml"), self.read("in/scene.xml"))
        self.assertIn(b'pos="0 0 0.05', self.read("out/parts/a.xml"))

    def test_what_stands_elsewhere_is_not_written(self):
        self.write("part.xml", '<mujocoinclude><worldbody><body name="a" pos="0 0 .06"><freejoint/>'
                               '<geom type="box" size=".05 .05 .05"/></body></worldbody></mujocoinclude>')
        self.write("in/scene.xml", '<mujoco><include file="../part.xml"/><worldbody><geom type="plane" size="1 1 1"/>'
                                   "</worldbody></mujoco>")
        os.makedirs(self.path("deep/out"))
        self.refused("settle", "in/scene.xml", "-o", "deep/out/scene.xml", says="outside its folder")
        self.refused("settle", "in/scene.xml", "--root", ".", "-o", "deep/out/scene.xml",
                     says="outside the folder of the scene")

    def test_layouts_and_scenes_of_ours_are_mended(self):
        data = json.loads(self.read(self.two_cubes()))
        data["operations"] = []
        for one, x in zip(data["objects"][1:], (0, 0.096)):  # 4 mm in each other
            one["position"] = [x, 0, 0.150002]
        self.write("meant.json", json.dumps(data))
        self.trivet("run", "meant.json", "-o", "refused.glb", status=1)
        out, _ = self.trivet("mend", "meant.json", "-o", "mended.glb")
        self.assertRegex(out, r"mend: [12] objects? moved\n")
        self.assertIn("supports kept; poses were taken to be off by", out)
        self.trivet("check", "mended.glb")
        self.trivet("mend", "mended.glb", "-o", "again.glb", "--quiet")
        out, _ = self.trivet("settle", "mended.glb", "-o", "third.glb")
        self.assertIn("settle: 0 objects moved\n", out)
        self.refused("mend", "meant.json", "--only", "nobody", "-o", "x.glb", says="no object")
        self.refused("mend", "mended.glb", "--only", "nobody", "-o", "x.glb", says="nobody")
        data["operations"] = [{"op": "mend", "tolerance": 0.01}]
        self.write("steps.json", json.dumps(data))
        self.trivet("run", "steps.json", "-o", "steps.glb", "--report", "steps_report.json")
        repaired = json.loads(self.read("steps_report.json"))["operations"][0]["repaired"]
        self.assertEqual(repaired["unable"], [])
        self.assertEqual(repaired["supports_kept"], repaired["supports_meant"])

    def test_inputs_stay(self):
        self.refused("settle", "table.xml", "-o", "table.xml", says="table.xml")
        self.refused("mend", "cube.obj", "-o", "out.xml", says="accepted: MJCF")


class Joints(ScenesCase):
    def test_they_are_listed(self):
        out, _ = self.trivet("joint", "drawer.xml")
        self.assertIn('"slide": slide of "drawer", at 0.2 m of 0 to 0.3', out)
        self.assertIn('"lid": hinge of "lid", at 0 degrees of 0 to 90', out)

    def test_a_drawer_closes_with_what_is_in_it(self):
        self.trivet("settle", "drawer.xml", "-o", "settled.xml")
        out, _ = self.trivet("joint", "settled.xml", "slide", "--to", "lower", "-o", "closed.xml")
        self.assertIn('"slide": reached, at 0 m', out)
        self.assertIn('"in the drawer" came along', out)
        self.assertTrue(self.checked("closed.xml")[0]["ok"])
        move = json.loads(self.trivet("joint", "closed.xml", "slide", "--by", "0.1", "-o", "ajar.xml", "--json")[0])
        self.assertEqual((move["end"], move["value"], move["carried"]), ("reached", 0.1, ["in the drawer"]))

    def test_of_urdf_and_sdf(self):
        for name, slide, cube in (("drawer.urdf", "slide", "cube"), ("drawer.sdf", "unit::slide", "cube")):
            self.write(name, (CASES / name).read_bytes())
            self.write(name + ".joints.json", (CASES / (name + ".joints.json")).read_bytes())
            out, _ = self.trivet("joint", name)
            self.assertIn('"%s": slide of' % slide, out)
            self.assertIn("at 0.2 m of 0 to 0.3", out)
            self.trivet("settle", name, "-o", "settled-" + name)
            self.assertEqual(self.read("settled-%s.joints.json" % name).decode().split(), ['{', '"%s":' % (slide[:-5] + "lid"), '0.0,',
                                                                                  '"%s":' % slide, '0.2', '}'])
            out, _ = self.trivet("joint", "settled-" + name, slide, "--to", "lower", "-o", "closed-" + name)
            self.assertIn('"%s" came along' % cube, out)
            (verdict,) = self.checked("closed-" + name)
            self.assertTrue(verdict["ok"])
            self.assertIn("the values of joints are those of closed-%s.joints.json" % name, verdict["notes"])
            self.refused("joint", "closed-" + name, slide, "--to", "0.1", "-o", "closed-" + name, says="overwritten")

    def test_of_usd(self):
        self.write("drawer.usda", (CASES / "drawer.usda").read_bytes())
        out, _ = self.trivet("joint", "drawer.usda")
        self.assertIn('"slide": slide of "drawer", at 0.2 m of 0 to 0.3', out)
        (verdict,) = self.checked("drawer.usda", status=1)
        self.assertEqual((verdict["format"], verdict["joints"], verdict["whole"]), ("USD", 2, True))
        (floating,) = verdict["findings"]
        self.assertEqual((floating["kind"], floating["object"], floating["other"]), ("floats", "cube", "drawer"))
        self.assertAlmostEqual(floating["height"], 0.01, places=9)
        self.trivet("settle", "drawer.usda", "-o", "settled.usda")
        layer = self.read("settled.usda").decode()
        self.assertIn("@./drawer.usda@", layer)
        self.assertEqual((layer.count("over "), layer.count("xformOp")), (2, 1))
        out, _ = self.trivet("joint", "settled.usda", "slide", "--to", "lower", "-o", "closed.usda")
        self.assertIn('"cube" came along', out)
        self.assertTrue(self.checked("closed.usda")[0]["ok"])
        self.assertIn("at 0 m", self.trivet("joint", "closed.usda")[0])
        self.assertEqual(self.read("drawer.usda"), (CASES / "drawer.usda").read_bytes())
        self.refused("settle", "drawer.usda", "-o", "drawer.usda", says="input")
        self.refused("settle", "drawer.usda", "-o", "drawer.xml", says="accepted: .usda")

    def test_values_that_mimic(self):
        self.write("cabinet.urdf", (CASES / "cabinet.urdf").read_bytes())
        out, _ = self.trivet("joint", "cabinet.urdf")
        self.assertIn('held: it follows "door"', out)
        out, _ = self.trivet("joint", "cabinet.urdf", "door", "--to", "10", "-o", "out.urdf", status=1)
        self.assertIn('"door": refused: the joint "door" cannot be moved: "second" follows it', out)
        out, _ = self.trivet("joint", "cabinet.urdf", "door", "--to", "10", "--json", status=1)
        self.assertEqual(json.loads(out)["status"], "refused")
        self.assertNotIn("out.urdf", self.files())

    def test_a_slope_that_is_too_steep(self):
        self.write("slope.xml", """<mujoco><worldbody><geom type="plane" size="3 3 .1" euler="50 0 0"/>
<body name="box" pos="0 0 1" euler="50 0 0"><freejoint/><geom type="box" size=".1 .1 .1" friction="0.3"/></body>
</worldbody></mujoco>""")
        out, _ = self.trivet("settle", "slope.xml", "-o", "out.xml", status=1)
        self.assertIn('"box" slides or tips off what is below it', out)

    def test_what_check_finds_true_is_not_moved(self):
        """Ten micrometres up: contact by the wider clearance that files of others may have been settled with."""
        ball = '<mujoco><worldbody><geom type="plane" size="3 3 .1"/>\n<body name="ball" pos="0.1 0.2 1.00001"><freejoint/>' \
            '<geom type="sphere" size="1"/></body></worldbody></mujoco>'
        self.write("ball.xml", ball)
        self.assertIn("ok: ", self.trivet("check", "ball.xml")[0])
        for verb in ("settle", "mend"):
            self.trivet(verb, "ball.xml", "-o", verb + ".xml")
            self.assertEqual(self.read(verb + ".xml").decode(), ball)

    def test_own_exports_are_read_without_a_note_on_margins(self):
        self.trivet("demo", "spoon-saucer", "-o", "s.glb", "--quiet")
        self.trivet("export", "s.glb", "-o", "s.xml", "--quiet")
        out, _ = self.trivet("check", "s.xml")
        self.assertNotIn("margin", out)

    def test_wrong_words(self):
        self.refused("joint", "drawer.xml", "door", "--to", "0", says='accepted: "slide", "lid"')
        self.refused("joint", "drawer.xml", "lid", "--to", "far", says='accepted: a number, "lower", "upper"')
        self.refused("joint", "drawer.xml", "lid", says="accepted: a number")


class Meaning(ScenesCase):
    def test_intent_of_bad_poses(self):
        out, _ = self.trivet("intent", "table.xml")
        self.assertIn('"a": on "table" 100 %; is sunk by 3 mm', out)
        self.assertIn('"b": on "table" 100 %; floats by 10 mm', out)
        intent = json.loads(self.trivet("intent", "table.xml", "--json")[0])
        self.assertEqual([o["on"][0]["object"] for o in intent["objects"]], ["table", "table"])

    def test_what_stands_beside_what_and_leans(self):
        leaning = """<mujoco><worldbody><geom type="plane" size="2 2 .1"/>
<body name="wall" pos="0 0 .2"><geom type="box" size=".05 .3 .2"/></body>
<body name="board" pos=".15 0 .1523" euler="0 -30 0"><freejoint/><geom type="box" size=".01 .1 .17"/></body>
<body name="a" pos=".5 0 .05"><freejoint/><geom type="box" size=".05 .05 .05"/></body>
<body name="b" pos=".602 0 .05"><freejoint/><geom type="box" size=".05 .05 .05"/></body>
<body name="c" pos=".8 0 .05"><freejoint/><geom type="box" size=".05 .05 .05"/></body>
</worldbody></mujoco>"""
        self.write("lean.xml", leaning)
        found = {o["object"]: o for o in
                 json.loads(self.trivet("intent", "lean.xml", "--tolerance", "0.01", "--json")[0])["objects"]}
        self.assertEqual((found["board"]["leans_on"], found["board"]["level"]), (["wall"], False))
        self.assertEqual((found["a"]["beside"], found["b"]["beside"]), (["b"], ["a"]))
        self.assertNotIn("beside", found["c"])
        out, _ = self.trivet("intent", "lean.xml", "--tolerance", "0.01")
        self.assertIn('"board": on "floor" 100 %', out)
        self.assertIn('leans on "wall"', out)
        self.assertIn('beside "b"', out)

    def test_two_sheets_may_lie_either_way(self):
        sheets = """<mujoco><worldbody><geom type="plane" size="2 2 .1"/>
<body name="a" pos="0 0 .001"><freejoint/><geom type="box" size=".1 .1 .001"/></body>
<body name="b" pos=".001 0 .001"><freejoint/><geom type="box" size=".1 .1 .001"/></body>
</worldbody></mujoco>"""
        self.write("sheets.xml", sheets)
        found = json.loads(self.trivet("intent", "sheets.xml", "--tolerance", "0.005", "--json")[0])["objects"]
        self.assertEqual([s.get("either_way") for o in found for s in o["on"]], [None, True])


class Hostile(ScenesCase):
    def test_binary_usd_is_named(self):
        for name in ("room.usdc", "room.usdz", "room.usd"):
            self.write(name, b"PXR-USDC" + bytes(16))
            self.refused("check", name, says="usdcat")

    def test_broken_files_get_one_line(self):
        for text, says in (("", "no element"), ("<mujoco", "line 1"), ("<x/>", "accepted: <mujoco>"),
                           ('<!DOCTYPE m [<!ENTITY a "b">]><mujoco/>', "entities"),
                           ("<mujoco>" * 300, "nested too deeply"),
                           ('<mujoco><include file="/etc/passwd"/></mujoco>', "outside its folder"),
                           ('<mujoco><worldbody><geom size="1e999"/></worldbody></mujoco>', "accepted"),
                           ('<mujoco><worldbody><replicate count="100000"><replicate count="100000"><body/>'
                            "</replicate></replicate></worldbody></mujoco>", "too many bodies")):
            self.write("x.xml", text)
            self.refused("check", "x.xml", says=says)

    def test_a_billion_laughs(self):
        entities = "".join('<!ENTITY l%d "%s">' % (i, "&l%d;" % (i - 1) * 10) for i in range(1, 10))
        self.write("x.xml", '<!DOCTYPE m [<!ENTITY l0 "ha">%s]><mujoco>&l9;</mujoco>' % entities)
        self.refused("check", "x.xml", says="entities")
        self.write("x.xml", '<!DOCTYPE m SYSTEM "file:///etc/passwd"><mujoco><worldbody/></mujoco>')
        self.trivet("check", "x.xml", status=(0, 2))

    def test_changed_bytes_never_crash(self):
        random.seed(5)
        text = (CASES / "drawer.xml").read_bytes() + (CASES / "world.sdf").read_bytes()
        for name in ("drawer.xml", "frames.xml", "cabinet.urdf", "world.sdf", "drawer.urdf", "drawer.sdf", "drawer.usda"):
            bytes_ = bytearray((CASES / name).read_bytes())
            for trial in range(25):
                changed = bytearray(bytes_)
                for _ in range(random.choice((1, 3, 20))):
                    at = random.randrange(len(changed))
                    if random.random() < 0.5:
                        changed[at] = random.randrange(256)
                    else:
                        length = random.randrange(40)
                        begin = random.randrange(len(text) - 40)
                        changed[at:at + random.randrange(40)] = text[begin:begin + length]
                self.write("set/%s.%d%s" % (name, trial, os.path.splitext(name)[1]), bytes(changed))
        out, err = self.trivet("check", "set", status=(0, 1, 2))
        self.assertIn("175 scenes", out, err)


if __name__ == "__main__":
    main()
