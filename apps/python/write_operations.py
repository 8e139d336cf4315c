"""Writes the methods of objects that are operations, _operations.py, from the schema of layouts.

The schema is made of the operations' tables (ops/operations/table.h): names, types, units, defaults and help.

Usage: write_operations.py LAYOUT_SCHEMA OUTPUT
"""
import json
import sys
import textwrap

# Methods of the scene, properties of objects, or methods that return an object.
OTHERS = {"append", "arrange", "drape", "duplicate", "rename", "lock", "unlock", "fix", "unfix", "material", "group",
          "ungroup"}
METHODS = {"delete": "remove"}
PARAMETERS = {"angle_deg": "degrees", "rotation": "wxyz", "with": "with_", "from": "from_"}
POSITIONAL = {"rotation", "about"}  # beside what is required
KINDS = {  # the type as it is written, and as documents have it
    "flag": ("bool", "bool"), "number": ("float", "float"), "whole": ("int", "int"), "text": ("str", "str"),
    "word": ("str", "str"), "vector2": ("ArrayLike", "(2,) array"), "vector3": ("ArrayLike", "(3,) array"),
    "vector4": ("ArrayLike", "(4,) array"), "points2": ("Sequence[ArrayLike]", "sequence of (2,) arrays"),
    "points3": ("Sequence[ArrayLike]", "sequence of (3,) arrays"), "place": ("Union[str, ArrayLike]", '(2,) array or "anywhere"'),
    "name": ("Other", 'Object or "floor"'), "names": ("Sequence[Other]", "sequence of Object")}
NOTES = {("put", "position"): " Default: where it is now."}  # where methods take more than layouts
DROPPED = {"flag", "number", "whole"}  # not passed on where they have their default

HEAD = '''"""Operations on an object; written by write_operations.py from the schema of layouts. Do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional, Sequence, Union

from numpy.typing import ArrayLike

from ._given import given
from ._properties import Properties
from ._results import Result, checked

if TYPE_CHECKING:
    from ._object import Other

'''
END = '''
        Returns
        -------
        Result
            How far it went and why it ended, what moved along, what lost its support.

        Raises
        ------
        Refused
            With a `code` and the `objects` in the way.
        OutOfTime, Cancelled, KeyboardInterrupt
            The scene is as it was.
        BadInputError
            An argument is not accepted, or one is missing.
'''


def kind_of(value):
    reference = value.get("$ref", "").rpartition("/")[2]
    if "oneOf" in value:
        return "place"
    if reference:
        return {"name_of_object": "name", "support": "name", "rotation": "vector4"}.get(reference, "text")
    if "enum" in value:
        return "word"
    if value["type"] == "array":
        items = value["items"]
        if "maxItems" in value:
            return "vector%d" % value["maxItems"]
        return "names" if "$ref" in items else "points%d" % items["maxItems"]
    return {"boolean": "flag", "number": "number", "integer": "whole"}[value["type"]]


class Parameter:
    def __init__(self, key, value, forms):
        self.key, self.name, self.kind = key, PARAMETERS.get(key, key), kind_of(value)
        here = [form for form in forms if key in form["properties"]]
        self.required = [key in form["required"] for form in here]
        self.always = all(self.required) and len(here) == len(forms)
        self.default = value.get("default") if self.kind in DROPPED or self.kind == "word" else None
        self.text = value["description"]
        if self.kind == "word":
            words = [word for form in reversed(here) for word in form["properties"][key]["enum"]]
            self.text += " " + ", ".join('"%s"' % word for word in dict.fromkeys(words)) + "."
        if self.kind == "vector3" and "default" in value:
            self.text += " Default: (%s)." % ", ".join("%g" % x for x in value["default"])
        others = [form for form in forms if key not in form["properties"]]
        if others and not any(self.required):
            beside = self.goes_with(here[0], others[0])
            self.text = beside + self.text[0].lower() + self.text[1:] if beside else self.text
        self.text += NOTES.get((forms[0]["properties"]["op"]["const"], key), "")

    def goes_with(self, form, other):
        """The arguments that must be given beside this one."""
        for key in form["required"]:
            words = form["properties"][key].get("enum")
            if words and key != "op":
                return "With %s, " % " or ".join('`%s="%s"`' % (key, word) for word in words)
        marks = ["`%s`" % key for key in form["required"] if key not in other["required"]]
        return "With %s, " % " and ".join(marks) if marks else ""

    def signature(self):
        kind = KINDS[self.kind][0]
        if self.always:
            return "%s: %s" % (self.name, kind)
        if self.default is not None:
            return "%s: %s = %r" % (self.name, kind, self.default)
        return "%s: Optional[%s] = None" % (self.name, kind)

    def document(self):
        kind = KINDS[self.kind][1] + ("" if self.always or self.default is not None else ", optional")
        text = textwrap.fill(self.text, 108, initial_indent=" " * 12, subsequent_indent=" " * 12)
        return "        %s : %s\n%s\n" % (self.name, kind, text)

    def read(self):
        default = self.default if self.kind in DROPPED else None
        return '("%s", "%s", "%s", %s, %r)' % (self.key, self.name, self.kind, self.name, default)


def parameters_of(forms):
    """Parameters of all forms; those of the plain form, which is the last one, come first."""
    out = {}
    for form in reversed(forms):
        for key, value in form["properties"].items():
            if key not in ("op", "object") and key not in out:
                out[key] = Parameter(key, value, forms)
    plain = forms[-1]
    first = [out[key] for key in plain["required"] if key in out] + [out[key] for key in out if key in POSITIONAL]
    rest = [one for one in out.values() if one not in first]
    rest.sort(key=lambda one: all(one.key in form["properties"] for form in forms))
    return (first, rest) if first else (rest, [])


def wrapped(head, parts, tail, indent):
    whole = [part.replace(" ", "\0") for part in parts]
    return textwrap.fill(head + ", ".join(whole) + tail.replace(" ", "\0"), 116, subsequent_indent=" " * indent, break_long_words=False,
                         break_on_hyphens=False).replace("\0", " ")


def method(op, forms):
    first, rest = parameters_of(forms)
    name = METHODS.get(op, op)
    signature = ["self", *(one.signature() for one in first), "*", *(one.signature() for one in rest),
                 "budget: Optional[float] = None"]
    passed = [*(one.name for one in first), *("%s=%s" % (one.name, one.name) for one in rest), "budget=budget"]
    lines = textwrap.wrap(forms[-1]["description"], 108, initial_indent='        """', subsequent_indent=" " * 8)
    text = "\n" + wrapped("    def %s(" % name, signature, ") -> Result:", 9 + len(name)) + "\n"
    text += "\n".join(lines) + "\n\n        Parameters\n        ----------\n"
    text += "".join(one.document() for one in [*first, *rest])
    text += "        budget : float, optional\n            Seconds; `OutOfTime` is raised beyond.\n" + END + '        """\n'
    text += wrapped("        return checked(self.try_%s(" % name, passed, "))", 16) + "\n"
    text += "\n" + wrapped("    def try_%s(" % name, signature, ") -> Result:", 13 + len(name)) + "\n"
    text += '        """As `%s`, with its parameters, but a refusal is returned: a `Result` that is false."""\n' % name
    text += '        return self._perform("%s", budget, given(self._scene' % op
    text += "".join(",\n            " + one.read() for one in [*first, *rest]) + "))\n"
    return text


def table(operations):
    """Table of the parameters of each operation, for drags."""
    text = "\n\n# Key in layouts and kind of each parameter.\nPARAMETERS: dict[str, dict[str, tuple[str, str]]] = {\n"
    for op, forms in operations.items():
        first, rest = parameters_of(forms)
        pairs = ['"%s": ("%s", "%s")' % (one.name, one.key, one.kind) for one in [*first, *rest]]
        text += wrapped('    "%s": {' % op, pairs, "},", 8) + "\n"
    return text + "}\n"


def main(schema, output):
    with open(schema, encoding="utf-8") as file:
        forms = json.load(file)["properties"]["operations"]["items"]["oneOf"]
    operations = {}
    for form in forms:
        op = form.get("properties", {}).get("op", {}).get("const", "arrange")
        if op not in OTHERS:
            operations.setdefault(op, []).append(form)
    methods = "".join(method(op, forms) for op, forms in operations.items())
    text = HEAD + '\nclass Operations(Properties):\n    """How an object is placed and moved; see `trivet.Object`."""\n'
    with open(output, "w", encoding="utf-8") as file:
        file.write(text + "\n    __slots__ = ()\n" + methods + table(operations))


if __name__ == "__main__":
    main(*sys.argv[1:])
