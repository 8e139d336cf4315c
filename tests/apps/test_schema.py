"""The published schema and the reader accept the same layouts, on the corpus of the reader's test."""
import copy
import json
import os
import unittest

from program import SOURCE_DIR, Case, main

try:
    import jsonschema
except ImportError:
    jsonschema = None


def place(document, pointer):
    """Container and key of a JSON pointer."""
    steps = [s.replace("~1", "/").replace("~0", "~") for s in pointer.split("/")[1:]]
    for step in steps[:-1]:
        document = document[int(step)] if isinstance(document, list) else document[step]
    return document, int(steps[-1]) if isinstance(document, list) else steps[-1]


def no_constant(name):
    raise ValueError(name + " is not JSON")


def document_of(case, base):
    """The layout of a case; None if it is not JSON."""
    if "text" in case:
        try:
            return json.loads(case["text"], parse_constant=no_constant)
        except ValueError:
            return None
    document = copy.deepcopy(base)
    for pointer, value in case.get("set", {}).items():
        container, key = place(document, pointer)
        container[key] = value
    for pointer in case.get("remove", []):
        container, key = place(document, pointer)
        del container[key]
    return document


@unittest.skipIf(jsonschema is None, "Python has no jsonschema (Debian: python3-jsonschema)")
class Schema(Case):
    def test_layouts_schema_and_reader_agree(self):
        self.check_agreement("layout", "tests/ops/files/layout/corpus.json", 65)

    def test_recipes_schema_and_reader_agree(self):
        self.check_agreement("recipe", "tests/apps/farm/recipes.json", 45)

    def check_agreement(self, kind, cases, least):
        with open(os.path.join(SOURCE_DIR, cases)) as file:
            corpus = json.load(file)
        schema = json.loads(self.trivet("schema", kind)[0])
        jsonschema.Draft202012Validator.check_schema(schema)
        validator = jsonschema.Draft202012Validator(schema)
        num_compared = 0
        for case in corpus["cases"]:
            document = document_of(case, corpus["base"])
            if document is None:
                self.assertIn("message", case, case["what"])
                continue
            accepted = "message" not in case or case.get("beyond_schema", False)
            self.assertEqual(validator.is_valid(document), accepted, case["what"])
            num_compared += 1
        self.assertGreater(num_compared, least)


if __name__ == "__main__":
    main()
