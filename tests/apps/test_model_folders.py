"""Models see their own folder: files elsewhere are neither read nor told of."""
import json
import os

from program import SLAB, Case, main

SECRET = "SECRET-7319"


class ModelsSeeTheirFolder(Case):
    """Files outside a model's folder are neither read nor told of."""

    def setUp(self):
        super().setUp()
        os.mkdir(self.path("m"))
        self.trivet("run", self.layout([SLAB], name="slab.json"), "-o", "m/slab.gltf", "--quiet")
        self.buffer = self.read("m/slab.bin")
        self.write("secret.bin", self.buffer)
        self.write("secret.txt", SECRET)
        self.write("secret.mtl", "newmtl red\nKd 1 0 0\nmap_Kd secret.png\nnewmtl %s\n" % SECRET)
        self.write("secret.png", b"\x89PNG\r\n\x1a\n" + SECRET.encode())
        os.symlink("../secret.bin", self.path("m/link.bin"))
        os.symlink("..", self.path("m/up"))
        os.symlink("../secret.mtl", self.path("m/link.mtl"))
        os.symlink("../secret.png", self.path("m/link.png"))

    def gltf(self, uri, name="m/slab.gltf"):
        json_ = json.loads(self.read("m/slab.gltf"))
        json_["buffers"][0]["uri"] = uri
        return self.write(name, json.dumps(json_))

    def both(self, *arguments):
        return (arguments, (*arguments, "--import-in-process"))

    def test_buffers_of_gltf(self):
        for uri in ("../secret.bin", "%2e%2e/secret.bin", "x/../../secret.bin",
                    self.path("secret.bin"), "link.bin", "up/secret.bin", "../secret.txt",
                    "/etc/passwd", "../m/../secret.bin", "/dev/zero", "../none.bin"):
            self.gltf(uri)
            for arguments in self.both("info", "m/slab.gltf"):
                err = self.refused(*arguments, says=("m/slab.gltf: ", "outside its folder",
                                                     "accepted: files in the folder"))
                for leak in (SECRET, "root:", "bytes", "missing"):
                    self.assertNotIn(leak, err)
        layout = self.layout([], [], scene="m/slab.gltf")
        self.refused("run", layout, "-o", "s.gltf", says="outside its folder")

    def test_files_in_the_folder_and_below(self):
        self.write("m/below/b.bin", self.buffer)
        os.symlink("below/b.bin", self.path("m/inside.bin"))
        for uri in ("slab.bin", "below/b.bin", "inside.bin", "../m/slab.bin", "up/m/slab.bin"):
            self.gltf(uri, "m/ok.gltf")
            for arguments in self.both("info", "m/ok.gltf"):
                self.trivet(*arguments)
        os.symlink("m/slab.gltf", self.path("linked.gltf"))  # the files are where the link leads
        self.write("slab.bin", "")
        os.remove(self.path("slab.bin"))
        self.gltf("slab.bin")
        os.symlink("m/slab.bin", self.path("slab.bin"))
        self.trivet("info", "linked.gltf")

    def notes(self, name, *more):
        out = self.trivet("info", name, "--json", *more)[0]
        self.assertNotIn(SECRET, out)
        return json.loads(out)["notes"]

    def test_materials_of_obj(self):
        cube = self.read("cube.obj").decode()
        for name in ("../secret.mtl", self.path("secret.mtl"), "link.mtl", "up/secret.mtl"):
            self.write("m/a.obj", "mtllib %s\nusemtl red\n" % name + cube)
            for arguments in self.both():
                text = " ".join(self.notes("m/a.obj", *arguments))
                # assimp takes absolute names for relative ones: such a file is not there.
                if not os.path.isabs(name):
                    self.assertIn("outside its folder", text, name)
        self.write("m/own.mtl", "newmtl red\nKd 1 0 0\n")
        self.write("m/a.obj", "mtllib own.mtl\nusemtl red\n" + cube)
        self.assertEqual(self.notes("m/a.obj"), [])

    def test_textures(self):
        obj = "mtllib own.mtl\nusemtl red\nvt 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/1\n"
        self.write("m/a.obj", obj)
        for name in ("../secret.png", self.path("secret.png"), "link.png", "up/secret.png"):
            self.write("m/own.mtl", "newmtl red\nmap_Kd %s\n" % name)
            for arguments in self.both():
                self.assertIn("left out: the texture", " ".join(self.notes("m/a.obj", *arguments)))
            self.trivet("run", self.layout([{**SLAB, "model": "m/a.obj"}]), "-o", "s.glb")
            self.assertNotIn(SECRET.encode(), self.read("s.glb"))

    def test_images_of_gltf(self):
        json_ = json.loads(self.read("m/slab.gltf"))
        for name in ("../secret.png", self.path("secret.png"), "link.png", "up/secret.png"):
            json_["images"] = [{"uri": name}]
            json_["textures"] = [{"source": 0}]
            json_["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
            self.write("m/a.gltf", json.dumps(json_))
            self.trivet("run", self.layout([{**SLAB, "model": "m/a.gltf"}]), "-o", "s.glb")
            self.assertNotIn(SECRET.encode(), self.read("s.glb"))

    def test_batches_store_nothing_from_elsewhere(self):
        self.write("m/own.mtl", "newmtl own\nKd 0 1 0\nmap_Kd link.png\nmap_Ks up/secret.png\n")
        os.mkdir(self.path("m/below"))
        self.write("m/below/b.mtl", "newmtl below\nKd 0 0 1\n")
        os.symlink("below/b.mtl", self.path("m/inside.mtl"))
        self.write("m/cube.obj", b"mtllib own.mtl\nmtllib link.mtl\nmtllib up/secret.mtl\nmtllib inside.mtl\n"
                                 b"mtllib ../secret.mtl\n" + self.read("cube.obj"))
        self.write("r.json", json.dumps({
            "trivet_recipe": 1, "objects": [SLAB],
            "groups": [{"name": "box", "models": [{"model": "m/cube.obj"}], "count": 1, "on": "slab"}]}))
        self.trivet("batch", "r.json", "--count", 2, "--out", "out", "--quiet", status=(0, 1))
        stored = [name for name in self.files() if name.startswith("out/models/")]
        self.assertEqual(sorted(os.path.basename(name) for name in stored), ["cube.obj", "inside.mtl", "own.mtl", "slab.obj"])
        for name in self.files():
            if name.startswith("out/"):
                self.assertNotIn(SECRET.encode(), self.read(name), name)
                self.assertFalse(os.path.islink(self.path(name)), name)
        self.trivet("batch", "verify", "out")

    def test_pipes_are_no_files_of_a_model(self):
        os.mkfifo(self.path("m/fifo.bin"))
        self.gltf("fifo.bin")
        for arguments in self.both("info", "m/slab.gltf"):
            out, err = self.trivet(*arguments, status=2)
            self.assertIn("m/slab.gltf", err)

if __name__ == "__main__":
    main()
