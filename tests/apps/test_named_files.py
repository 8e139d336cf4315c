"""No file that a model or scene names is overwritten, by whatever writes files."""
import json
import os
import struct
import zlib

from program import SLAB, Case, box_obj, main, put


def png(colour):
    """A picture of one texel."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)) + \
        chunk(b"IDAT", zlib.compress(b"\0" + bytes(colour))) + chunk(b"IEND", b"")


def dae(texture):
    """A tetrahedron in Collada whose only material names a texture."""
    return """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Z_UP</up_axis></asset>
<library_images><image id="i"><init_from>%s</init_from></image></library_images>
<library_effects><effect id="e"><profile_COMMON>
<newparam sid="s"><surface type="2D"><init_from>i</init_from></surface></newparam>
<newparam sid="t"><sampler2D><source>s</source></sampler2D></newparam>
<technique sid="c"><lambert><diffuse><texture texture="t" texcoord="u"/></diffuse></lambert></technique>
</profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 0.1 0 0 0 0.1 0 0 0 0.1</float_array>
<technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<source id="q"><float_array id="qa" count="2">0 0</float_array>
<technique_common><accessor source="#qa" count="1" stride="2"><param name="S" type="float"/>
<param name="T" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4" material="k"><input semantic="VERTEX" source="#v" offset="0"/>
<input semantic="TEXCOORD" source="#q" offset="1" set="0"/>
<p>0 0 2 0 1 0 0 0 1 0 3 0 0 0 3 0 2 0 1 0 2 0 3 0</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="w"><node id="n"><instance_geometry url="#g"><bind_material>
<technique_common><instance_material symbol="k" target="#m"><bind_vertex_input_set semantic="u"
input_semantic="TEXCOORD" input_set="0"/></instance_material></technique_common></bind_material>
</instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#w"/></scene></COLLADA>
""" % texture


class NamedFiles(Case):
    def setUp(self):
        super().setUp()
        self.write("wood.png", png((120, 80, 40)))
        self.write("maps/grain.png", png((90, 60, 30)))
        self.write("old.tga", b"not read, but named")
        self.write("model.dae", dae("wood.png"))
        self.write("below.dae", dae("maps/grain.png"))
        self.write("shiny.obj", "mtllib shiny.mtl\nusemtl a\n" + box_obj(0.05, 0.05, 0.05))
        self.write("shiny.mtl", "newmtl a\nKd 1 1 1\nmap_Kd -s 1 1 1 wood.png\nmap_Ks old.tga\nmap_bump maps/grain.png\n")
        self.trivet("run", self.layout([SLAB], name="slab.json"), "-o", "buffered.gltf", "--quiet")
        gltf = self.read_json("buffered.gltf")
        gltf["images"] = [{"uri": "maps/grain.png"}]
        del gltf["scenes"][0]["extras"]
        for node in gltf["nodes"]:
            node.pop("extras", None)
        self.write("buffered.gltf", json.dumps(gltf))

    def laid_out(self, model):
        return self.layout([SLAB, {"name": "a", "model": model}], [put("a", 0, 0, 1)])

    def scene_of(self, model, name="scene.glb"):
        self.trivet("run", self.laid_out(model), "-o", name, "--quiet")
        return name

    def kept(self, *arguments, named_by):
        self.refused(*arguments, "--quiet", says=("is an input, named by " + named_by, "would be overwritten"))

    def test_outputs_of_runs(self):
        for model, file in (("model.dae", "wood.png"), ("below.dae", "maps/grain.png"),
                            ("shiny.obj", "wood.png"), ("shiny.obj", "maps/grain.png"),
                            ("buffered.gltf", "maps/grain.png")):
            self.kept("run", self.laid_out(model), "-o", "s.glb", "--report", file, named_by=model)
            self.kept("run", self.laid_out(model), "-o", "s.glb", "--report", file,
                      "--import-in-process", named_by=model)
        self.kept("run", self.laid_out("model.dae"), "-o", "s.glb", "--picture", "wood.png", named_by="model.dae")

    def test_whatever_leads_there(self):
        os.link(self.path("wood.png"), self.path("hard.png"))
        os.symlink("wood.png", self.path("soft.png"))
        for file in ("hard.png", "soft.png", "maps/../wood.png", self.path("wood.png")):
            self.kept("run", self.laid_out("model.dae"), "-o", "s.glb", "--report", file, named_by="model.dae")

    def test_files_that_are_named_but_not_read(self):
        self.kept("run", self.laid_out("shiny.obj"), "-o", "s.glb", "--report", "old.tga", named_by="shiny.obj")

    def test_side_files(self):
        self.kept("run", self.laid_out("shiny.obj"), "-o", "s.glb", "--report", "shiny.mtl", named_by="shiny.obj")
        self.kept("run", self.laid_out("buffered.gltf"), "-o", "s.glb", "--report", "buffered.bin",
                  named_by="buffered.gltf")
        self.refused("run", self.laid_out("shiny.obj"), "-o", "shiny.obj", says="would be overwritten")

    def test_pictures_of_models(self):
        self.kept("render", "model.dae", "-o", "wood.png", named_by="model.dae")
        self.kept("render", "model.dae", "--ids", "wood.png", "--cameras", self.camera(), named_by="model.dae")
        self.kept("zlist", "model.dae", "-o", "wood.png", named_by="model.dae")

    def camera(self):
        return self.write("cameras.json", json.dumps([{"eye": [1, 1, 1], "target": [0, 0, 0]}]))

    def test_data_sets(self):
        size = ("--dome", 1, "--width", 32, "--height", 24)
        for kind, folder, list_of_all in (("--coco", "coco", "coco/annotations.json"), ("--bop", "bop", "bop/models/models_info.json")):
            self.trivet("render", "cube.obj", kind, folder, *size)
            for picture in [f for f in self.files() if f.startswith(folder + "/") and f.endswith(".png")][:2]:
                model, before = self.write("over.dae", dae(picture)), self.read(picture)
                self.trivet("render", model, kind, folder, *size)  # sets grow: what is there stays
                self.assertEqual(self.read(picture), before)
            model, before = self.write("over.dae", dae(list_of_all)), self.read(list_of_all)
            self.assertIn("named by over.dae", self.trivet("render", model, kind, folder, *size, status=2)[1])
            self.assertEqual(self.read(list_of_all), before)

    # Scenes hold the geometry of models, which name files even when nobody reads them again.
    def test_models_of_scenes(self):
        scene = self.scene_of("model.dae")
        for arguments in (("put", scene, "cube.obj", "--position", 0.3, 0.3, 1, "-o", "t.glb", "--picture", "wood.png"),
                          ("translate", scene, "a", "--by", 0, 0, 0.5, "-o", "t.glb", "--picture", "wood.png"),
                          ("render", scene, "-o", "wood.png"),
                          ("check", scene, "--report", "wood.png"),
                          ("zlist", scene, "-o", "wood.png")):
            self.kept(*arguments, named_by="model.dae")

    def test_own_files_of_an_export_are_replaced(self):
        for name in ("out.gltf", "out.obj"):
            for _ in range(2):
                self.scene_of("model.dae", name)
        gltf = self.scene_of("below.dae", "own.gltf")
        before = self.read(gltf)
        self.trivet("run", self.laid_out("below.dae"), "-o", gltf, "--quiet")
        self.assertEqual(self.read(gltf), before)

    def test_exported_demos(self):
        self.write("d/mug.obj", "v 0 0 0\n")
        self.trivet("demo", "spoon-saucer", "--export", "d", "-o", "s.glb")
        self.trivet("demo", "spoon-saucer", "--export", "d", "-o", "s.glb")  # its own files
        for name in ("layout.json", "spoon.glb"):
            file = self.write("%s.d/%s" % (name, name), b"of somebody else")
            self.refused("demo", "spoon-saucer", "--export", name + ".d", "-o", "t.glb",
                         says=(file + ": is there already", "accepted: another folder"))


if __name__ == "__main__":
    main()
