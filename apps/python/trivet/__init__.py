"""Trivet lays out 3D objects so that they never interpenetrate and always lie at rest.

>>> import trivet
>>> scene = trivet.Scene()
>>> cup = scene.add("cup", trivet.Shape(vertices, faces))      # doctest: +SKIP
>>> cup.put([0.1, 0.2, 1.5])                                   # doctest: +SKIP

Metres, z up, gravity along -z, quaternions w x y z, 4x4 matrices that take shapes to the world. Results are values: they
do not change with the scene. What cannot be done raises `Refused`, with a `code` and the `objects` in the way, and leaves
the scene as it was.
"""

from . import _errors  # first: the compiled module raises what it defines
from ._camera import Camera
from ._drag import Drag
from ._errors import (BadInputError, Cancelled, EnvironmentFailure, NoSuchObject, NotDone, OutOfTime, Refused, SceneBusy,
                      TrivetError)
from ._film import Film
from ._foreign_scene import Foreign
from ._geometry import Interpenetration, first_contact, interpenetrations, random_rotation
from ._labels import FLOOR, Labels
from ._object import Object
from ._recipe import MadeScene, Recipe, batch_export, batch_pictures
from ._results import (CAUSES, Check, Contacts, Crossing, Export, FirstContact, GaveWay, Overlap, Result, Simulated,
                       SupportGraph)
from ._scene import Scene, materials
from ._settle import Settle
from ._shape import Shape
from ._snapshot import Snapshot, TrivetWarning
from ._trivet import __version__
from ._view import View, encode_png
from ._zlists import ZList, ZLists

__all__ = [
    "BadInputError", "CAUSES", "Camera", "Cancelled", "Check", "Contacts", "Crossing", "Drag", "EnvironmentFailure",
    "Export", "FLOOR", "Film", "FirstContact", "Foreign", "GaveWay", "Interpenetration", "Labels", "MadeScene", "NoSuchObject", "NotDone", "Object",
    "OutOfTime", "Overlap", "Recipe", "Refused", "Result", "Scene", "SceneBusy", "Settle", "Shape", "Simulated", "Snapshot", "SupportGraph",
    "TrivetError", "TrivetWarning", "View", "ZList", "ZLists",
    "__version__", "batch_export", "batch_pictures", "encode_png", "first_contact", "interpenetrations", "materials", "random_rotation",
]
