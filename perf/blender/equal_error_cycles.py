"""The half of equal_error.py that runs in Blender: -- SCENE.glb FOLDER CONVERGED SAMPLES...      writes FOLDER/cycles.json"""
import json
import os
import pathlib
import sys
import time

import bpy
import numpy
from mathutils import Matrix

if not hasattr(numpy, "bool"):  # Debian 12's Blender uses a name that its numpy has removed
    numpy.bool = bool
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.dont_write_bytecode = True
import render as studio  # noqa: E402  the lights of compare.sh


def add_camera(scene, of):
    """OpenCV's axes to Blender's: y and z the other way."""
    (width, height), k = of["size"], of["K"]
    world_from_camera = Matrix([[*row, 0] if len(row) == 3 else row for row in of["camera_from_world"]][:3] + [[0, 0, 0, 1]])
    world_from_camera.invert()
    camera = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
    camera.matrix_world = world_from_camera @ Matrix.Diagonal((1, -1, -1, 1))
    camera.data.sensor_fit, camera.data.sensor_width = "HORIZONTAL", 36
    camera.data.lens = 36 * k[0][0] / width
    camera.data.clip_start = .001
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.resolution_x, scene.render.resolution_y = width, height
    studio.EYE = camera.matrix_world.translation
    studio.TARGET = studio.EYE - camera.matrix_world.to_3x3().col[2]


def pixels_of(file):
    image = bpy.data.images.load(str(file))
    image.colorspace_settings.name = "Non-Color"
    out = numpy.array(image.pixels[:], float).reshape(image.size[1], image.size[0], 4)[:, :, :3] * 255
    bpy.data.images.remove(image)
    return out


def main():
    words = sys.argv[sys.argv.index("--") + 1:]
    folder, converged, samples = pathlib.Path(words[1]), int(words[2]), [int(word) for word in words[3:]]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    bpy.ops.import_scene.gltf(filepath=words[0])
    add_camera(scene, json.loads((folder / "camera.json").read_text()))
    studio.add_key_light(scene), studio.add_sky(scene), studio.add_floor()
    scene.render.engine = "CYCLES"
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.max_bounces = scene.cycles.diffuse_bounces = 3
    scene.view_settings.view_transform = "Standard"
    scene.render.image_settings.file_format = "PNG"

    def picture(count):
        scene.cycles.samples = count
        scene.render.filepath = str(folder / ("cycles_%d.png" % count))
        begin = time.process_time()
        bpy.ops.render.render(write_still=True)
        return time.process_time() - begin, pixels_of(scene.render.filepath)

    _, best = picture(converged)
    rows = []
    for count in samples:
        seconds, pixels = picture(count)
        rows.append([count, seconds, float(numpy.sqrt(((pixels - best) ** 2).mean()))])
    (folder / "cycles.json").write_text(json.dumps(rows))


main()
