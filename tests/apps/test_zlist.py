"""z-lists of a scene contain exactly its faces."""
import json
import struct
import unittest

from program import Case, main, put


def png_size(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", data[16:24])


class ZLists(Case):
    def zlist(self, *arguments, status=0):
        out, _ = self.trivet("zlist", *arguments, "--json", status=status)
        return json.loads(out)

    def test_cube(self):
        """From above, from the side, and the list of one pixel."""
        found = self.zlist("cube.obj", "--resolution", 10, "--pixel", 3, 6)
        self.assertEqual((found["width"], found["height"]), (10, 10))
        self.assertEqual(found["covered_pixels"], 100)
        self.assertEqual((found["right"], found["up"]), ([1, 0, 0], [0, 1, 0]))
        self.assertAlmostEqual(found["left"], -0.05)
        self.assertAlmostEqual(found["top"], 0.05)
        self.assertTrue(found["objects"][0]["solid"])
        pixel = found["pixel"]
        self.assertEqual((pixel["column"], pixel["row"]), (3, 6))
        tops = [e for e in pixel["list"] if e["crossing"] == "enters"]
        bottoms = [e for e in pixel["list"] if e["crossing"] == "leaves"]
        self.assertTrue(tops and bottoms)
        self.assertEqual(tops + bottoms, pixel["list"])
        for entry, depth in [(e, -0.05) for e in tops] + [(e, 0.05) for e in bottoms]:
            self.assertLessEqual(entry["depth"][0], depth)
            self.assertGreaterEqual(entry["depth"][1], depth)
            self.assertAlmostEqual(sum(entry["depth"]), 2 * depth, delta=1e-7)
        side = self.zlist("slab.obj", "--direction", 0, 5, 0, "--resolution", 19)
        self.assertEqual((side["width"], side["height"]), (19, 2))
        self.assertEqual((side["right"], side["up"]), ([1, 0, 0], [0, 0, 1]))

    def test_dump_holds_all_lists(self):
        layout = self.two_cubes()
        head, *lines = self.dump(layout, "--resolution", 40)
        self.assertEqual(len(lines), head["covered_pixels"])
        self.assertEqual(sum(len(line["list"]) for line in lines), head["entries"])
        self.assertEqual(max(len(line["list"]) for line in lines), head["longest_list"])
        names = [o["name"] for o in head["objects"]]
        self.assertEqual(len(names), 3)
        for line in lines:
            depths = [(entry[2], entry[3]) for entry in line["list"]]
            self.assertEqual(depths, sorted(depths))
        line = lines[len(lines) // 2]
        pixel = self.zlist(layout, "--resolution", 40, "--pixel", *line["pixel"])["pixel"]
        self.assertEqual([[names.index(e["object"]), e["face"], *e["depth"], e["centre"],
                           e["crossing"]] for e in pixel["list"]], line["list"])

    def dump(self, *arguments):
        self.trivet("zlist", *arguments, "--dump", "lists.jsonl")
        return [json.loads(line) for line in self.read("lists.jsonl").splitlines()]

    def test_region_zooms(self):
        """A zoomed pixel contains no new faces."""
        layout = self.two_cubes()
        head = self.zlist(layout, "--resolution", 16, "--pixel", 8, 8)
        size, faces = head["pixel_size"], {(e["object"], e["face"]) for e in head["pixel"]["list"]}
        left, top = head["left"] + 8 * size, head["top"] - 8 * size
        closer, *lines = self.dump(layout, "--resolution", 4, "--region", left, top - size,
                                   left + size, top)
        self.assertEqual((closer["width"], closer["height"]), (4, 4))
        self.assertAlmostEqual(closer["pixel_size"], size / 4)
        names = [o["name"] for o in closer["objects"]]
        found = {(names[e[0]], e[1]) for line in lines for e in line["list"]}
        self.assertTrue(found)
        self.assertLessEqual(found, faces)

    def test_same_with_any_number_of_threads(self):
        texts = set()
        for threads in (1, 2, 5):
            head, *lines = self.dump(self.two_cubes(), "--threads", threads)
            head.pop("milliseconds")
            texts.add(json.dumps([head, lines]))
        self.assertEqual(len(texts), 1)

    def test_scene_and_layout_give_the_same(self):
        layout = self.two_cubes()
        self.trivet("run", layout, "-o", "s.glb")
        lists = [self.dump(name)[1:] for name in (layout, "s.glb")]
        self.assertEqual(*lists)

    def test_refused_operation(self):
        layout = self.layout([{"name": "a", "model": "cube.obj"}, {"name": "b", "model": "cube.obj"}],
                             [put("a", 0, 0, 0.2), put("b", 0, 0, 0.05)])
        found = self.zlist(layout, status=1)
        self.assertEqual([o["name"] for o in found["objects"]], ["a"])

    def test_pictures(self):
        out, err = self.trivet("zlist", "cube.obj", "-o", "p.png", "--resolution", 300,
                               status=(0, 3))
        if "makes no pictures" in err:
            return
        self.assertIn("in the longest", out)
        width, height = png_size(self.read("p.png"))
        self.assertEqual(width, 300)
        self.assertGreater(height, 300)
        pictures = {self.read("p.png")}
        for show in ("depth", "objects"):
            self.trivet("zlist", "cube.obj", "-o", "p.png", "--resolution", 300, "--show", show)
            pictures.add(self.read("p.png"))
        self.assertEqual(len(pictures), 3)

    def test_text(self):
        out, _ = self.trivet("zlist", "cube.obj", "--resolution", 8, "--pixel", 2, 3)
        for words in ("z-lists of 1 object, 12 faces, along 0 0 -1", "pixel 2 3:", "enters", "leaves",
                      "in the longest", "MiB"):
            self.assertIn(words, out)
        self.assertNotIn("-0 ", out)

    def test_bad_arguments(self):
        self.refused("zlist", "cube.obj", "--direction", 0, 0, 0, says=("direction", "0 0 0"))
        self.refused("zlist", "cube.obj", "--resolution", 0, says=("1 to 8192",))
        self.refused("zlist", "cube.obj", "--resolution", 4, "--pixel", 4, 0,
                     says=("--pixel: 4 0", "less than 4 4"))
        self.refused("zlist", "cube.obj", "--region", 0, 0, 0, 1, says=("region", "above 0"))
        self.refused("zlist", "cube.obj", "--show", "red", says=("length, depth, objects",))
        self.refused("zlist", "cube.obj", "-o", "p.jpg", says=(".png",))
        self.refused("zlist", "cube.obj", "--dump", "cube.obj", says=("is an input",))

    def motion(self, *arguments, status=0):
        """The head and the pixels of a dump, which agree with --json."""
        self.trivet("zlist", *arguments, "--dump", "motion.jsonl", status=status)
        head, *pixels = [json.loads(line) for line in self.read("motion.jsonl").splitlines()]
        printed = self.zlist(*arguments)
        for one in (head, printed):
            one.pop("milliseconds")
        self.assertEqual(head, printed)
        return head, pixels

    def scene(self):
        """Two cubes of 0.1 m, "a" on the floor and "b" on it."""
        self.trivet("run", self.layout(
            [{"name": "a", "model": "cube.obj"}, {"name": "b", "model": "cube.obj"}],
            [put("a", 0, 0, 0.1), put("b", 0.03, 0, 0.3)]), "-o", "s.glb")
        return "s.glb"

    def test_drop(self):
        """A cube lifted by 0.2 m falls back onto the other one."""
        head, pixels = self.motion(self.scene(), "--drop", "b", "--raise", 0.2, "--resolution", 16)
        self.assertEqual(head["motion"]["direction"], [0, 0, -1])
        self.assertEqual((head["moving"], head["fixed"]), (["b"], ["a"]))
        self.assertEqual((head["image"]["right"], head["image"]["up"]), ([1, 0, 0], [0, 1, 0]))
        self.assertEqual(head["image"]["unit"], "mm")
        contact, bounds = head["contact"], head["bounds"]
        self.assertEqual((contact["status"], contact["moving"], contact["fixed"]),
                         ("contact", "b", "a"))
        self.assertAlmostEqual(contact["at"], 0.2, places=5)
        self.assertLessEqual(bounds["lower"], contact["at"])
        self.assertGreaterEqual(bounds["upper"], contact["at"])
        self.assertAlmostEqual(bounds["floor"], 0.3, places=4)
        both = [p for p in pixels if p["gap"] is not None]
        self.assertEqual(len(both), head["image"]["pixels"])
        self.assertEqual(sum(p["doubtful"] for p in both), head["image"]["doubtful_pixels"])
        self.assertGreater(len(both), 100)
        for p in both:
            self.assertAlmostEqual(p["gap"], 200, delta=0.5)
            self.assertAlmostEqual(p["fixed"] - p["moving"], p["gap"], delta=1e-3)
        self.assertIn((contact["faces"], True),
                      [([p["face_moving"], p["face_fixed"]], p["not_before"] <= contact["at"])
                       for p in head["pairs"]])
        self.assertEqual(head["work"]["confirmed_pairs"], len(head["pairs"]))

    def test_loads_move_along(self):
        head, _ = self.motion(self.scene(), "--move", "a", "--along", 0, 0, 0.5)
        self.assertEqual((head["moving"], head["fixed"]), (["a", "b"], []))
        self.assertEqual(head["contact"], {"status": "free"})
        self.assertEqual(head["bounds"], {"lower": None, "upper": None, "floor": None})

    def test_turn(self):
        """About a vertical axis beside both cubes, the upper one meets nothing; about a level one, the
        floor's neighbour."""
        free, _ = self.motion(self.scene(), "--turn", "b", "--raise", 0.01,
                              "--centre", 0.5, 0, 0)
        self.assertEqual((free["contact"]["status"], free["image"]["unit"]), ("free", "deg"))
        head, _ = self.motion(self.scene(), "--turn", "b", "--raise", 0.05, "--axis", 0, 2, 0,
                              "--angle-deg", 60, "--centre", -0.3, 0, 0.15)
        self.assertEqual(head["motion"]["axis"], [0, 1, 0])
        self.assertAlmostEqual(head["motion"]["limit"], 60)
        contact, bounds = head["contact"], head["bounds"]
        self.assertEqual((contact["status"], contact["fixed"]), ("contact", "a"))
        self.assertLess(0, contact["at"])
        self.assertLess(contact["at"], 60)
        self.assertLessEqual(bounds["lower"], contact["at"])
        self.assertGreaterEqual(bounds["upper"] or 90, contact["at"])

    def test_picture_and_text_of_a_motion(self):
        scene = self.scene()
        out, err = self.trivet("zlist", scene, "--drop", "b", "--raise", 0.1, "-o", "m.png",
                               status=(0, 3))
        if "makes no pictures" in err:
            return
        for words in ("z-lists of b, moving along 0 0 -1", "doubtful", "bounds: not before", "of a",
                      "proposed by software"):
            self.assertIn(words, out)
        width, height = png_size(self.read("m.png"))
        self.assertGreater(width, 3 * 200)
        self.assertGreater(height, 300)

    def test_the_gpu_finds_the_same_contact(self):
        scene = self.scene()
        a, b = (self.zlist(scene, "--detector", backend, "--drop", "b", "--raise", 0.1)
                for backend in ("software", "gpu"))
        self.assertEqual((a["contact"], a["image"], a["bounds"]),
                         (b["contact"], b["image"], b["bounds"]))

    def test_bad_motions(self):
        scene = self.scene()
        self.refused("zlist", scene, "--drop", "c", says='--drop: there is no object "c"')
        self.refused("zlist", scene, "--move", "b", says=("--move", "--along"))
        self.refused("zlist", scene, "--move", "b", "--along", 0, 0, 0, says=("--along", "but 0"))
        self.refused("zlist", scene, "--turn", "b", "--axis", 0, 0, 0, says=("--axis", "but 0"))
        self.refused("zlist", scene, "--turn", "b", "--angle-deg", 0, says=("--angle-deg", "but not 0"))
        self.refused("zlist", scene, "--turn", "b", "--angle-deg", 91, says=("--angle-deg", "-90 to 90"))
        self.refused("zlist", scene, "--drop", "b", "--turn", "a", says=("--drop", "--turn"))
        self.refused("zlist", scene, "--drop", "b", "--pixel", 1, 1, says=("--pixel",))
        self.refused("zlist", scene, "--drop", "b", "--resolution", 2000, says=("1 to 1024",))
        self.refused("zlist", scene, "--raise", 1, says=("--raise", "--drop"))

    def test_memory_limit(self):
        """Memory is bounded: an error before allocation."""
        quad = "v 0 0 %d\nv 1 0 %d\nv 1 1 %d\nv 0 1 %d\n"
        faces = "".join("f %d %d %d\nf %d %d %d\n" % (a, a + 1, a + 2, a, a + 2, a + 3)
                        for a in range(1, 4000, 4))
        self.write("stack.obj", "".join(quad % (z, z, z, z) for z in range(1000)) + faces)
        self.refused("zlist", "stack.obj", "--resolution", 1024, "--max-memory-mb", 64,
                     says=("1024 x 1024 pixels have more than", "smaller region"))
        self.assertEqual(self.zlist("stack.obj", "--resolution", 16)["longest_list"], 2000)


if __name__ == "__main__":
    main()
