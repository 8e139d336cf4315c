"""Pictures of models by Blender's Cycles, with the camera and nearly the lights of `trivet render` (core/picture):

    blender -b --factory-startup -P render.py -- SIDE SAMPLES FOLDER MODEL.gltf...      writes FOLDER/MODEL.png
"""
import math
import os
import sys

import bpy
import numpy
from mathutils import Matrix, Vector

if not hasattr(numpy, "bool"):  # Debian 12's Blender uses a name that its numpy has removed
    numpy.bool = bool

EYE, TARGET, FOV_DEG = Vector((.35, -.5, .38)), Vector((0, 0, .085)), 30
KEY_SHARE, KEY_ELEVATION_DEG, KEY_TURN_DEG, KEY_RADIUS_DEG = .58, 52, 55, 5
SKY_HORIZON = .65
FLOOR = .62  # its albedo
HEIGHT = 1e-4  # of the models over it


def add_camera(scene):
    camera = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
    camera.location = EYE
    camera.rotation_euler = (TARGET - EYE).to_track_quat("-Z", "Y").to_euler()
    camera.data.sensor_fit, camera.data.angle = "VERTICAL", math.radians(FOV_DEG)
    camera.data.clip_start = .001
    scene.collection.objects.link(camera)
    scene.camera = camera


def add_key_light(scene):
    ahead = TARGET - EYE
    azimuth = math.atan2(-ahead.x, ahead.y) - math.pi / 2 - math.radians(KEY_TURN_DEG)
    z = math.sin(math.radians(KEY_ELEVATION_DEG))
    towards = Vector((math.cos(azimuth) * math.sqrt(1 - z * z), math.sin(azimuth) * math.sqrt(1 - z * z), z))
    sun = bpy.data.objects.new("key", bpy.data.lights.new("key", "SUN"))
    sun.data.energy, sun.data.color = KEY_SHARE * math.pi / z, (1.02, 1, .96)
    sun.data.angle = 2 * math.radians(KEY_RADIUS_DEG)
    sun.rotation_euler = towards.to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(sun)


def add_sky(scene):
    """Radiance s (h + (1 - h) z) above the horizon, of an irradiance of (1 - KEY_SHARE) pi on the floor."""
    strength = (1 - KEY_SHARE) / (SKY_HORIZON + 2 / 3 * (1 - SKY_HORIZON))
    world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    place, axes, rise = (nodes.new(kind) for kind in ("ShaderNodeTexCoord", "ShaderNodeSeparateXYZ", "ShaderNodeMath"))
    rise.operation = "MULTIPLY_ADD"
    rise.inputs[1].default_value, rise.inputs[2].default_value = strength * (1 - SKY_HORIZON), strength * SKY_HORIZON
    links.new(place.outputs["Generated"], axes.inputs[0])
    links.new(axes.outputs["Z"], rise.inputs[0])
    links.new(rise.outputs[0], nodes["Background"].inputs[1])
    nodes["Background"].inputs[0].default_value = (.97, 1, 1.05, 1)
    scene.world = world


def add_floor():
    bpy.ops.mesh.primitive_plane_add(size=20)
    material = bpy.data.materials.new("floor")
    material.use_nodes = True
    surface = material.node_tree.nodes["Principled BSDF"]
    surface.inputs["Base Color"].default_value = (FLOOR, FLOOR, FLOOR, 1)
    surface.inputs["Roughness"].default_value, surface.inputs["Specular"].default_value = 1, 0
    bpy.context.object.data.materials.append(material)


def show_vertex_colours():
    """The importer of Blender 3.4 reads COLOR_0, but does not use it."""
    for mesh in bpy.data.meshes:
        if not mesh.color_attributes:
            continue
        tree = mesh.materials[0].node_tree
        colours = tree.nodes.new("ShaderNodeVertexColor")
        colours.layer_name = mesh.color_attributes[0].name
        tree.links.new(colours.outputs[0], tree.nodes["Principled BSDF"].inputs["Base Color"])


def render(model, side, samples, folder):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    bpy.ops.import_scene.gltf(filepath=model)
    for thing in scene.objects:
        if not thing.parent:
            thing.location.z += HEIGHT
    show_vertex_colours()
    add_camera(scene)
    add_key_light(scene)
    add_sky(scene)
    add_floor()
    scene.render.engine, scene.cycles.device, scene.cycles.samples = "CYCLES", "CPU", samples
    scene.cycles.use_denoising, scene.cycles.max_bounces = False, 4
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x = scene.render.resolution_y = side
    scene.render.filepath = os.path.join(folder, os.path.splitext(os.path.basename(model))[0] + ".png")
    bpy.ops.render.render(write_still=True)


if __name__ == "__main__":
    side, samples, folder, *models = sys.argv[sys.argv.index("--") + 1:]
    for path in models:
        render(path, int(side), int(samples), folder)
