"""Linked copies of objects with all below them."""

from __future__ import annotations

import bpy


def copy_tree(owner: bpy.types.Object, collection: bpy.types.Collection) -> bpy.types.Object:
    """A linked copy of an object and all below it: other objects, the same meshes."""
    copies = {}
    for one in [owner, *owner.children_recursive]:
        copies[one] = one.copy()
        collection.objects.link(copies[one])
        copies[one].select_set(False)
    for one, copy in copies.items():
        if one is not owner:
            copy.parent = copies[one.parent]
            copy.matrix_parent_inverse = one.matrix_parent_inverse
    return copies[owner]


def remove_tree(owner: bpy.types.Object) -> None:
    for one in [*owner.children_recursive, owner]:
        bpy.data.objects.remove(one)


def home_of(owner: bpy.types.Object, context) -> bpy.types.Collection:
    """The collection in which copies of an object belong."""
    return owner.users_collection[0] if owner.users_collection else context.scene.collection
