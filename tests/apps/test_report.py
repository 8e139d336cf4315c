"""`trivet report`: a command with its files, as a case that anybody can repeat."""
import hashlib
import json
import os
import subprocess
import tarfile

from live_session import Live
from program import PROGRAM, SLAB, Case, box_obj, main, put

LAYOUT = {"trivet": 1, "objects": [SLAB, {"name": "mug", "model": "models/mug.obj"}],
          "operations": [put("mug", 0, 0, 1)]}


class Report(Case):
    def setUp(self):
        super().setUp()
        self.write("models/mug.obj", "mtllib mug.mtl\nusemtl a\n" + box_obj(0.04, 0.04, 0.05))
        self.write("models/mug.mtl", "newmtl a\nKd 1 0 0\n")
        self.write("layout.json", json.dumps(LAYOUT))

    def pack(self, *command, options=()):
        self.trivet("report", "-o", "case.tar", *options, "--", *command)
        with tarfile.open(self.path("case.tar")) as tar:
            members = {m.name: tar.extractfile(m).read() for m in tar.getmembers()}
        return json.loads(members.pop("case.json")), members

    def unpack(self, members, folder):
        for name, content in members.items():
            self.assertNotIn("..", name.split("/"))
            self.assertFalse(name.startswith("/"), name)
            self.write(folder + "/" + name, content)

    def test_repeats_a_layout_elsewhere(self):
        case, members = self.pack("run", "layout.json", "-o", "scene.glb")
        self.assertEqual(case["outcome"], "exit status 0")
        self.assertEqual({f["name"] for f in case["files"]},
                         {"files/layout.json", "files/slab.obj", "files/models/mug.obj", "files/models/mug.mtl"})
        for file in case["files"]:
            self.assertEqual(file["sha256"], hashlib.sha256(members[file["name"]]).hexdigest())
        self.unpack(members, "elsewhere")
        subprocess.run([PROGRAM, *case["command"]], cwd=os.path.join(self.path("elsewhere"), case["folder"]), check=True,
                       capture_output=True)
        self.assertEqual(self.read(os.path.join("elsewhere", case["folder"], "scene.glb")), self.read("scene.glb"))

    def test_keeps_refusals_and_errors(self):
        self.write("layout.json", json.dumps({**LAYOUT, "operations": [put("mug", 0, 0, 0.05)]}))
        case, members = self.pack("run", "layout.json", "-o", "scene.glb", "--json")
        self.assertEqual(case["outcome"], "exit status 1")
        self.assertIn(b"refused", members["output.txt"])
        case, members = self.pack("info", "none.obj")
        self.assertEqual((case["outcome"], case["files"]), ("exit status 2", []))
        self.assertIn(b"none.obj", members["error.txt"])

    def test_lists_files_without_them(self):
        case, members = self.pack("run", "layout.json", "-o", "scene.glb", options=["--without-files"])
        self.assertEqual(len(case["files"]), 4)
        self.assertEqual(set(members), {"output.txt", "error.txt"})

    def test_stops_a_command_that_does_not_end(self):
        os.mkfifo(self.path("pipe.json"))
        case, _ = self.pack("run", "pipe.json", "-o", "scene.glb", options=["--seconds", "0.3"])
        self.assertIn("out of time", case["outcome"])

    def test_names_the_files_of_a_journal(self):
        self.trivet("run", "layout.json", "-o", "scene.glb")
        live = Live(self.folder, "layout.json", "--journal", "steps.journal")
        self.assertEqual(live.ask(op="push", object="mug", direction=[1, 0], distance=0.1)["status"], "ok")
        self.assertEqual(live.end(), 0)
        case, _ = self.pack("replay", "steps.journal", "-o", "again.glb")
        self.assertEqual(case["outcome"], "exit status 0")
        self.assertLessEqual({"files/steps.journal", "files/steps.journal.start", "files/layout.json",
                              "files/models/mug.obj", "files/models/mug.mtl"}, {f["name"] for f in case["files"]})

    def test_never_replaces_an_input(self):
        before = self.read("layout.json")
        self.refused("report", "-o", "layout.json", "--", "run", "layout.json", "-o", "scene.glb", says=["is an input"])
        self.write("case.tar", before)
        self.refused("report", "-o", "case.tar", "--", "run", "case.tar", "-o", "scene.glb", says=["is an input"])
        self.assertEqual(self.read("layout.json"), before)


if __name__ == "__main__":
    main()
