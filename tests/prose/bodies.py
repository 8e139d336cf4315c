"""Comments in bodies of functions of the algorithms, in C++."""
import re

# Folders whose comments, read alone, tell how the engine works.
ALGORITHMS = ("core/candidates/", "core/contact/", "core/convex/", "core/exact/", "core/flex/", "core/index/", "core/mesh/",
              "core/motion/", "core/scene/", "gpu/zlist/", "ops/arrange/", "ops/check/", "ops/detect/", "ops/free_places/",
              "ops/mend/", "ops/operations/", "ops/placement/", "ops/settle/", "ops/stability/", "raster/height_map/",
              "raster/path/", "raster/zlist/")
# Strings, comments, characters and lines of the preprocessor: their braces mean nothing.
SKIPPED = re.compile(r'R"([^(\s]*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\''
                     r'|^[ \t]*#(?:\\\n|[^\n])*', re.DOTALL | re.MULTILINE)
SCOPE = re.compile(r"(?:template\s*<[^{]*>\s*)?(?:inline\s+)?(?:namespace|class|struct|union|enum|extern)\b")


def bodies(text):
    """Yields the lines between the braces of each outermost body of a function."""
    lines = text.split("\n")
    plain = SKIPPED.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)
    depth, outermost, begin, head = 0, None, None, 0
    for mark in re.finditer(r"[{};]", plain):
        before, head = plain[head:mark.start()].strip(), mark.end()
        if mark[0] == "{":
            depth += 1
            if outermost is None and ("(" in before or not SCOPE.match(before)):
                # A body, or an initialiser, which may hold calls but no function.
                outermost, begin = depth, None if before.endswith("=") or "(" not in before else mark.start()
        elif mark[0] == "}":
            if outermost == depth:
                if begin is not None:
                    yield lines[plain.count("\n", 0, begin) + 1:plain.count("\n", 0, mark.start())]
                outermost = None
            depth -= 1


def counts(text):
    """(lines of comments, all lines) in bodies of functions."""
    inside = [line for body in bodies(text) for line in body]
    return sum(line.lstrip().startswith("//") for line in inside), len(inside)
