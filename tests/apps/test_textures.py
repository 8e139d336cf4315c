"""Textured models through the program: pictures, saved scenes, notes on what is not drawn, hostile images."""
import base64
import json
import os
import struct
import subprocess
import sys
import unittest
import zlib

from label_files import read_png
from program import SLAB, SOURCE_DIR, Case, main, put

SIZE = ("--width", 96, "--height", 72, "--samples", 8, "--renderer", "path")


def png(width, height, texels, size=None):
    """An RGBA image; `size`: what its header says."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    rows = b"".join(b"\0" + bytes(texels[4 * width * y:4 * width * (y + 1)]) for y in range(height))
    header = struct.pack(">IIBBBBB", *(size or (width, height)), 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + \
        chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def checker():
    red, blue = (210, 30, 30, 255), (30, 30, 210, 255)
    return png(32, 32, [c for y in range(32) for x in range(32)
                        for c in (red, blue)[(x // 8 + y // 8) % 2]])


def textured_box(half=0.05, image="checker.png"):
    """OBJ and MTL of a box with the whole image on each side."""
    corners = [(half * (1 if i & 1 else -1), half * (1 if i & 2 else -1), half * (1 if i & 4 else -1))
               for i in range(8)]
    sides = ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6))
    obj = "mtllib box.mtl\nusemtl skin\n" + "".join("v %g %g %g\n" % c for c in corners)
    obj += "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    for s in sides:
        obj += "f %d/1 %d/2 %d/3\nf %d/1 %d/3 %d/4\n" % (
            s[0] + 1, s[1] + 1, s[2] + 1, s[0] + 1, s[2] + 1, s[3] + 1)
    return obj, "newmtl skin\nKd 1 1 1\nmap_Kd %s\n" % image


def textured_square(extension, image, required):
    """A glTF of two triangles whose texture has an image by this extension alone."""
    buffer = struct.pack("<12f8f6H", 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 1, 2, 0, 2, 3) + image
    views = [(0, 48), (48, 32), (80, 12), (92, len(image))]
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "extensionsUsed": [extension], **({"extensionsRequired": [extension]} if required else {}),
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"extensions": {extension: {"source": 0}}}],
        "images": [{"name": "bark", "bufferView": 3, "mimeType": "image/ktx2"}],
        "accessors": [{"bufferView": i, "componentType": c, "count": n, "type": t, **more} for i, (c, n, t, more) in
                      enumerate(((5126, 4, "VEC3", {"min": [0, 0, 0], "max": [1, 1, 0]}), (5126, 4, "VEC2", {}),
                                 (5123, 6, "SCALAR", {})))],
        "bufferViews": [{"buffer": 0, "byteOffset": at, "byteLength": size} for at, size in views],
        "buffers": [{"byteLength": len(buffer),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(buffer).decode()}]})


class Textures(Case):
    def write_box(self, image="checker.png"):
        obj, mtl = textured_box(image=image)
        self.write("box.obj", obj)
        self.write("box.mtl", mtl)

    def colours(self, name):
        """Shares of clearly red and clearly blue pixels."""
        width, height, channels, values = read_png(self.read(name))
        pixels = [values[i:i + 3] for i in range(0, len(values), channels)]
        red = sum(p[0] > p[2] + 60 for p in pixels) / len(pixels)
        blue = sum(p[2] > p[0] + 60 for p in pixels) / len(pixels)
        return red, blue

    def test_a_checker_box_is_red_and_blue(self):
        self.write("checker.png", checker())
        self.write_box()
        self.trivet("render", "box.obj", "-o", "p.png", *SIZE)
        for share in self.colours("p.png"):
            self.assertGreater(share, 0.05)
        os.remove(self.path("checker.png"))
        self.trivet("render", "box.obj", "-o", "q.png", *SIZE)
        self.assertEqual(self.colours("q.png"), (0, 0))

    def test_info_lists_images_and_a_likely_unit(self):
        self.write("checker.png", checker())
        self.write_box()
        out, _ = self.trivet("info", "box.obj")
        self.assertIn('image       "checker", PNG, 32 x 32 texels', out)
        self.assertIn("likely m\n", out)
        info = json.loads(self.trivet("info", "box.obj", "--json")[0])
        self.assertEqual(info["images"], [{"name": "checker", "kind": "PNG", "bytes": len(checker()),
                                           "width": 32, "height": 32}])

    def test_saved_scenes_keep_their_textures(self):
        self.write("checker.png", checker())
        self.write_box()
        layout = self.layout([{"name": "box", "model": "box.obj"}], [put("box", 0, 0, 0.5)])
        self.trivet("run", layout, "-o", "s.glb")
        self.trivet("render", "s.glb", "-o", "run.png", *SIZE)
        for name in ("box.obj", "box.mtl", "checker.png"):
            os.remove(self.path(name))
        self.trivet("render", "s.glb", "-o", "p.png", *SIZE)
        self.assertEqual(self.read("run.png"), self.read("p.png"))
        for share in self.colours("p.png"):
            self.assertGreater(share, 0.005)

    def test_geometry_and_poses_do_not_depend_on_textures(self):
        self.write("checker.png", checker())
        self.write_box()
        layout = self.layout([SLAB, {"name": "box", "model": "box.obj"}], [put("box", 0, 0, 0.5)])
        poses = []
        for _ in range(2):
            self.trivet("run", layout, "-o", "s.glb", "--report", "r.json")
            poses.append([o["world_from_file"] for o in self.read_json("r.json")["objects"]])
            obj = self.read("box.obj").decode()
            for corner in "1234":
                obj = obj.replace("/" + corner, "")
            self.write("box.obj", "\n".join(line for line in obj.split("\n")
                                            if not line.startswith(("vt", "mtllib", "usemtl"))))
        self.assertEqual(poses[0], poses[1])

    def test_what_is_not_drawn_is_named(self):
        whole = checker()
        for image, says in ((whole[:-20], "damaged PNG"), (b"KTX 20", "neither PNG, JPEG nor WebP"),
                            (png(8, 8, [0] * 256, size=(60000, 60000)), "not drawn"),
                            (png(1, 1, [0] * 4, size=(16384, 16384)), "16384 x 16384 texels")):
            self.write("checker.png", image)
            self.write_box()
            out, _ = self.trivet("info", "box.obj")
            self.assertIn(says, out)
            self.trivet("render", "box.obj", "-o", "p.png", *SIZE)
            self.assertEqual(self.colours("p.png"), (0, 0))

    def test_compressed_textures_are_named_and_kept(self):
        for extension, kind, image in (("KHR_texture_basisu", "KTX2", b"\xabKTX 20\xbb\r\n\x1a\n" + bytes(68)),
                                       ("MSFT_texture_dds", "DDS", b"DDS " + bytes(124)),
                                       ("EXT_texture_avif", "AVIF", bytes(4) + b"ftypavif" + bytes(40))):
            for required in (False, True):
                self.write("square.gltf", textured_square(extension, image, required))
                out, _ = self.trivet("info", "square.gltf")
                self.assertIn('not drawn: the image "bark" is of the kind %s; accepted: PNG, JPEG, WebP' % kind, out)
                layout = self.layout([{"name": "square", "model": "square.gltf", "position": [0, 0, 1], "fixed": True}], [])
                out, err = self.trivet("run", layout, "-o", "s.glb")
                self.assertIn("bark", out + err)
                self.assertIn(image, self.read("s.glb"))

    def test_images_outside_the_folder_are_not_opened(self):
        self.write("outside.png", checker())
        os.makedirs(self.path("models"))
        obj, mtl = textured_box(image="../outside.png")
        self.write("models/box.obj", obj)
        self.write("models/box.mtl", mtl)
        os.symlink(self.path("outside.png"), self.path("models/link.png"))
        for image in ("../outside.png", self.path("outside.png"), "link.png"):
            self.write("models/box.mtl", mtl.replace("../outside.png", image))
            out, _ = self.trivet("info", "models/box.obj")
            self.assertIn("left out: the texture", out)
            self.trivet("render", "models/box.obj", "-o", "p.png", *SIZE)
            self.assertEqual(self.colours("p.png"), (0, 0))

    def test_the_scene_of_the_readme(self):
        subprocess.run([sys.executable, os.path.join(SOURCE_DIR, "apps", "textured_scene.py"), self.folder, "0.125"],
                       check=True, timeout=300)
        self.trivet("run", "layout.json", "-o", "s.glb")
        out, _ = self.trivet("info", "globe.obj")
        self.assertIn("closed      yes, oriented yes", out)
        self.assertIn("64 x 64 texels", out)

    def test_models_without_colours_differ(self):
        pictures = set()
        for name in ("alpha.obj", "beta.obj", "gamma.obj"):
            self.write(name, self.read("cube.obj"))
            self.trivet("render", name, "-o", "p.png", *SIZE)
            pictures.add(self.read("p.png"))
            self.trivet("render", name, "-o", "q.png", *SIZE)
            self.assertEqual(self.read("p.png"), self.read("q.png"))
        self.assertEqual(len(pictures), 3)


if __name__ == "__main__":
    main()
