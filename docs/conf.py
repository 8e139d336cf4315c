"""Configuration of the documentation site. docs/build.sh builds it; see there for what must be importable and on the path."""
import json
import os
import re
import subprocess

from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList
from sphinx.util.nodes import nested_parse_with_titles

import trivet

PROGRAM = os.environ.get("TRIVET_PROGRAM", "trivet")

project = "Trivet"
copyright = "the authors of Trivet"
version = release = trivet.__version__
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.mathjax", "numpydoc"]
myst_enable_extensions = ["dollarmath", "colon_fence", "deflist"]
myst_heading_anchors = 3
exclude_patterns = ["doxygen", "python/notebooks/.ipynb_checkpoints", "README.md"]
html_theme = "furo"
html_title = f"Trivet {version}"
html_show_sphinx = False
html_show_copyright = False
html_static_path = ["static"]
html_css_files = ["narrow.css"]
# Pages are read without a network: Debian's copy of MathJax is put beside them by build.sh.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_HTML"
# MyST tells MathJax 3 to look at formulas alone; Debian's is MathJax 2.
myst_update_mathjax = False
mathjax2_config = {"tex2jax": {"inlineMath": [["\\(", "\\)"]], "displayMath": [["\\[", "\\]"]], "processClass": "math"}}
nitpicky = False
autodoc_member_order = "bysource"
autodoc_typehints = "none"  # Docstrings give types with shapes and units.
numpydoc_show_class_members = False


class ProgramHelp(Directive):
    """``.. trivet-help::``: the text of ``--help`` of every verb, in the order in which the program of this build lists them."""

    def run(self):
        return self.verbs_below([])

    def verbs_below(self, words):
        result = []
        for verb in re.findall(r"^  ([a-z][a-z-]*) ", self.help(words).partition("\nSubcommands:\n")[2].partition("\n\n")[0], re.M):
            result += [self.section([*words, verb]), *self.verbs_below([*words, verb])]
        return result

    def section(self, words):
        text = self.help(words)
        section = nodes.section(ids=[nodes.make_id("-".join(["trivet", *words]))])
        section += nodes.title("", " ".join(["trivet", *words]))
        section += nodes.container("", nodes.literal_block(text, text, language="text"), classes=["program-help"])
        return section

    def help(self, words):
        return subprocess.run([PROGRAM, *words, "--help"], capture_output=True, text=True, check=True).stdout


class SchemaKeys(Directive):
    """``.. trivet-schema:: layout``: one table of keys for each object of a JSON Schema that the program prints."""

    required_arguments = 1

    def run(self):
        done = subprocess.run([PROGRAM, "schema", self.arguments[0]], capture_output=True, text=True, check=True)
        schema = json.loads(done.stdout)
        lines = []
        for title, part in [(schema["title"], schema)] + self.operations(schema) + sorted(schema.get("$defs", {}).items()):
            lines += self.table(title, part)
        holder = nodes.section()
        holder.document = self.state.document
        nested_parse_with_titles(self.state, StringList(lines, source=self.arguments[0]), holder)
        return holder.children

    def operations(self, schema):
        forms = schema["properties"].get("operations", {}).get("items", {}).get("oneOf", [])
        return [("operation " + form["properties"]["op"]["const"], form) for form in forms if "properties" in form]

    def table(self, title, part):
        keys = part.get("properties")
        if not keys:
            return []
        lines = [title, "-" * len(title), "", part.get("description", ""), "", ".. list-table::", "   :widths: 20 25 55",
                 "   :header-rows: 1", "", "   * - key", "     - value", "     - meaning"]
        required = part.get("required", [])
        for name, value in keys.items():
            lines += [f"   * - ``{name}``{' (required)' if name in required else ''}", f"     - {self.kind(value)}",
                      f"     - {' '.join(value.get('description', '').split())}"]
        return lines + [""]

    def kind(self, value):
        if "$ref" in value:
            return value["$ref"].rsplit("/", 1)[-1]
        if "const" in value:
            return f"``{json.dumps(value['const'])}``"
        if "enum" in value:
            return ", ".join(f"``{json.dumps(one)}``" for one in value["enum"])
        for key in ("oneOf", "anyOf"):
            if key in value:
                return " or ".join(dict.fromkeys(self.kind(one) for one in value[key]))
        kind = value.get("type", "")
        if kind == "array" and isinstance(value.get("items"), dict):
            return f"list of {self.kind(value['items'])}"
        return " or ".join(kind) if isinstance(kind, list) else kind


def setup(app):
    app.add_directive("trivet-help", ProgramHelp)
    app.add_directive("trivet-schema", SchemaKeys)
    return {"parallel_read_safe": True}
