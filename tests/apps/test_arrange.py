"""Computer-aided layout end to end: poses and surfaces of models."""
import json
import unittest

from program import Case, box_obj, main


def shelf_obj(boards, half_x=0.4, half_y=0.15, thick=0.02):
    """OBJ text of boards at these heights of their upper sides, between two sides."""
    text, count = "", 0
    sides = [((x, 0, boards[-1] / 2), (0.01, half_y, boards[-1] / 2))
             for x in (-half_x - 0.01, half_x + 0.01)]
    for centre, half in sides + [((0, 0, z - thick / 2), (half_x, half_y, thick / 2)) for z in boards]:
        for line in box_obj(*half).splitlines():
            kind, *values = line.split()
            values = [float(v) + c for v, c in zip(values, centre)] if kind == "v" else \
                [int(v) + count for v in values]
            text += kind + "".join(" %r" % v for v in values) + "\n"
        count += 8
    return text


class Info(Case):
    def text(self, *arguments):
        return self.trivet("info", *arguments)[0]

    def info(self, *arguments):
        return json.loads(self.text(*arguments, "--json"))

    def test_poses(self):
        self.write("book.obj", box_obj(0.015, 0.08, 0.11))
        info = self.info("book.obj", "--poses")
        self.assertEqual(len(info["poses"]), 6)
        self.assertAlmostEqual(sum(p["probability"] for p in info["poses"]), 1, places=14)
        upright = info["poses"][info["upright"]]
        self.assertEqual(upright["rotation"], [1, 0, 0, 0])
        self.assertAlmostEqual(upright["margin"], 0.015, places=9)
        self.assertNotIn("surfaces", info)
        self.assertIn("upright", self.text("book.obj", "--poses"))

    def test_poses_without_an_upright_one(self):
        self.write("top.obj", "v 0 0 0\nv 1 0 2\nv -0.5 0.9 2\nv -0.5 -0.9 2\n"
                              "f 1 2 4\nf 1 4 3\nf 1 3 2\nf 2 3 4\n")
        info = self.info("top.obj", "--poses")
        self.assertIsNone(info["upright"])
        self.assertIn("does not stand upright: its nearest stable pose is tilted by",
                      info["upright_reason"])

    def test_surfaces(self):
        self.write("shelf.obj", shelf_obj([0.1, 0.4, 0.75]))
        info = self.info("shelf.obj", "--surfaces")
        self.assertEqual([round(s["height"], 6) for s in info["surfaces"]], [0.1, 0.4, 0.75])
        self.assertAlmostEqual(info["surfaces"][0]["head_room"], 0.28, places=6)
        self.assertIsNone(info["surfaces"][2]["head_room"])
        self.assertAlmostEqual(info["surfaces"][1]["area"], 0.24, places=6)
        self.assertIn("open above", self.text("shelf.obj", "--surfaces"))


if __name__ == "__main__":
    main()
