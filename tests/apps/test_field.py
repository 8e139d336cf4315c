"""perf/field: Trivet's own row is true, and the judge finds what is wrong in anybody's poses."""
import json
import os
import subprocess
import sys

from program import PROGRAM, SOURCE_DIR, Case, main

FIELD = os.path.join(SOURCE_DIR, "perf", "field")
# An engine that leaves everything in the air, as README.md describes engines.
STILL = """
import json, os, sys
seconds, scene = sys.argv[1:]
with open(os.path.join(os.path.dirname(scene), "start.json")) as file:
    objects = json.load(file)["objects"]
print("a line that is no result")
print(json.dumps({"simulator": "Still 1", "objects": [
    {key: o[key] for key in ("name", "position", "rotation")} for o in objects if not o.get("fixed")]}))
"""


class Field(Case):
    def run_field(self, *arguments, status=0):
        done = subprocess.run([sys.executable, "-B", os.path.join(FIELD, "field.py"), "--trivet", PROGRAM, "--work", "work",
                               "--json", "verdicts.json", *arguments], capture_output=True, text=True, cwd=self.path("."))
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def verdicts(self, engine):
        return [v for v in self.read_json("verdicts.json") if v["engine"] == engine]

    def test_trivet_is_true_and_what_hangs_is_not(self):
        self.write("still.py", STILL)
        done = self.run_field("--engines", f"trivet,still={sys.executable} {self.path('still.py')}", "--kinds", "pair,start",
                              "--most", "1")
        own, still = self.verdicts("Trivet"), self.verdicts("Still 1")
        self.assertEqual([v["case"] for v in own], ["pair-00", "start-00"])
        for v in own:
            self.assertEqual((v["true"], v["missing"], v["interpenetrating"]), (v["objects"], 0, 0), v)
        self.assertEqual((still[0]["true"], still[0]["interpenetrating"], still[0]["drift_m"]), (0, 0, 0.0))
        self.assertGreater(still[0]["hovering_m"], 1e-3)
        # Start states have errors of up to 3 mm: some objects stand in others.
        self.assertGreater(still[1]["interpenetrating"], 3)
        self.assertTrue(1e-3 < still[1]["deepest_m"] < 6e-3, still[1])
        self.assertIn("| start | Still 1 |", done.stdout)

    def test_anybodys_poses_are_judged(self):
        layout = {"trivet": 1, "objects": [{"name": "a", "model": "cube.obj", "position": [0, 0, 1], "rotation": [1, 0, 0, 0]}]}
        self.write("start.json", json.dumps(layout))
        floor = -min(float(line.split()[3]) for line in self.read("cube.obj").decode().splitlines() if line.startswith("v "))
        for height, true, crossing in ((floor + 5e-8, 1, 0), (floor + 0.01, 0, 0), (floor - 0.01, 0, 1)):
            self.write("poses.json", json.dumps({"a": {"position": [0, 0, height], "rotation": [1, 0, 0, 0]}}))
            done = subprocess.run([sys.executable, "-B", os.path.join(FIELD, "judge.py"), "--trivet", PROGRAM, "start.json",
                                   "poses.json"], capture_output=True, text=True, check=True, cwd=self.path("."))
            verdict = json.loads(done.stdout)
            self.assertEqual((verdict["true"], verdict["interpenetrating"]), (true, crossing), verdict)

    def test_unknown_engines_and_kinds_are_named(self):
        for arguments, says in ((("--engines", "newton"), "there is no 'newton'; accepted: trivet, mujoco"),
                                (("--kinds", "moon"), "there is no 'moon'; accepted: single, pair")):
            self.assertIn(says, self.run_field(*arguments, status=1).stderr)


if __name__ == "__main__":
    main()
