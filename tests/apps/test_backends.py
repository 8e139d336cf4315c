"""Every backend gives the same report, apart from what it says about itself."""
import json
import os
import unittest

from program import SOURCE_DIR, Case, main, put

MODELS = os.path.join(SOURCE_DIR, "..", "shared", "data", "models")
OWN_KEYS = ("backend", "device", "work")


def common_part(report):
    report = {key: value for key, value in report.items() if key not in OWN_KEYS}
    for operation in report["operations"]:
        operation.pop("milliseconds")
    return json.dumps(report)


class Backends(Case):
    def reports(self, *arguments, statuses=(0,)):
        """What each backend reports; the common part must be the same."""
        found, texts = {}, set()
        for backend in ("bvh", "software", "gpu"):
            _, err = self.trivet(*arguments, "-o", backend + ".glb", "--report", "r.json", "--backend",
                                 backend, status=statuses)
            report = self.read_json("r.json")
            found[backend] = {key: report[key] for key in OWN_KEYS}
            texts.add(common_part(report))
            if backend == "gpu" and report["backend"] != "gpu":
                self.assertEqual(report["backend"], "software")
                self.assertIn("used instead of the GPU", err)
            else:
                self.assertEqual(report["backend"], backend)
        self.assertEqual(len(texts), 1)
        self.assertEqual(self.read("bvh.glb"), self.read("software.glb"))
        self.assertEqual(self.read("bvh.glb"), self.read("gpu.glb"))
        return found

    def test_demo(self):
        found = self.reports("demo", "spoon-saucer")
        self.assertEqual(found["bvh"]["device"], "cpu")
        self.assertGreater(found["bvh"]["work"]["node_pairs"], 0)
        self.assertEqual(found["software"]["work"]["fallbacks"], 0)
        self.assertLess(found["software"]["work"]["node_pairs"],  # of the floor
                        found["bvh"]["work"]["node_pairs"])
        self.assertGreater(found["software"]["work"]["doubtful_pixels"], 0)
        queries = {f["work"]["queries"] for f in found.values()}
        self.assertEqual(len(queries), 1)

    def test_cubes(self):
        self.reports("run", self.two_cubes())

    @unittest.skipUnless(os.path.isdir(MODELS), "the models beside the project are not there")
    def test_real_models(self):
        names = sorted(name for name in os.listdir(MODELS) if name.endswith((".obj", ".stl", ".ply"))
                       and os.path.getsize(os.path.join(MODELS, name)) < 200000)[:6]
        self.assertGreater(len(names), 3)
        objects, operations = [], []
        for i, name in enumerate(names):
            objects.append({"name": "o%d" % i, "model": os.path.join(MODELS, name)})
            operations.append(put("o%d" % i, 0.02 * i, 0.01 * i, 5 + 5 * i, [1, 0.2 * i, 0.1, 0.3]))
        layout = self.layout(objects, operations)
        self.reports("run", layout, statuses=(0, 1))

    def test_verbose_tells_what_the_stages_left(self):
        _, err = self.trivet("run", self.two_cubes(), "-o", "s.glb", "--backend", "software",
                             "--verbose")
        for words in ("stage 1, boxes:", "stage 2, depths:", "stage 3, lists:", "decided:"):
            self.assertIn(words, err)


if __name__ == "__main__":
    main()
