"""Patterns of sentences in the sources that the editor links: what its translations must have.

patterns.py [FILE]. Writes them as texts for lupdate. A pattern is a literal in a call of a function that takes a Sentence, or that
a function returns as one.
"""
import pathlib
import re
import sys

kSources = ["apps/demo", "apps/edit", "core", "gpu", "ops", "raster"]
# The editor reads cabinets of MJCF, URDF and SDF, but opens and writes no scenes of other programs.
kNotShown = ["core/io/foreign/usd", "core/io/foreign/joint_loads.cpp", "core/io/foreign/write_back.cpp",
             "ops/files/foreign/gltf_objects.cpp", "ops/files/foreign/joint_moves.cpp"]
kLiteral = re.compile(r'"((?:[^"\\]|\\.)*)"')
kParameters = r"\(((?:[^()]|\([^()]*\))*(?:\bSentence(?:&|&&)?\s+\w+|\bSentence>? \w+|const char\* pattern\b)(?:[^()]|\([^()]*\))*)\)"
kFunction = re.compile(r"^([ \t]*)[^\n;(){}=]*?\b(\w+)" + kParameters, re.M)
kLambda = re.compile(r"\b(\w+) = \[[^\]]*\]" + kParameters)
kReturning = re.compile(r"(?:^|\s)(?:Sentence|std::optional<Sentence>|Maybe|const char\*) [\w:]+\([^;{}]*\)(?: const)? \{")
kBody = re.compile(r"\s*(?:const\s*)?\{")
kVariable = re.compile(r"\bSentence \w+\s*[={(]")
kAlways = ["Error", "bad_input", "bad_file", "say", "Sentence", "TRIVET_SENTENCE"]
kAggregates = {"InvalidArgument": (2, 3)}  # the members that are sentences
kAll = range(99)
kWord = re.compile(r"[a-z]{2}")
kKey = re.compile(r"[a-z]+_[a-z_]+")


def without_comments(text):
    return re.sub(r"^\s*//.*$|(?<=[;{},)])\s+//[^\n\"]*$", "", text, flags=re.M)


def end_of_string(text, i):
    return kLiteral.match(text, i).end()


def end_of_group(text, begin):
    """Behind the bracket that closes the one here."""
    depth, i = 0, begin
    while i < len(text):
        if text[i] == '"':
            i = end_of_string(text, i)
            continue
        if text[i] == "'" and not text[i - 1].isalnum():
            i = text.index("'", i + (3 if text[i + 1] == "\\" else 2))
        elif text[i] in "([{":
            depth += 1
        elif text[i] in ")]}":
            depth -= 1
            if depth == 0:
                return i + 1
        i += 1
    return len(text)


def literals(text):
    """The literals that are whole values of an expression, its choices and its lists; not those of calls in it."""
    out, i = [], 0
    while i < len(text):
        if text[i] == '"':
            begin = i
            while i < len(text) and text[i] == '"':
                i = end_of_string(text, i)
                while i < len(text) and text[i].isspace():
                    i += 1
            before = text[:begin].rstrip()[-2:]
            if not before.endswith(("+", "=", "<", ">")) and text[i:i + 1] not in ("+", "]", "."):
                out.append("".join(kLiteral.findall(text[begin:i])).replace('\\"', '"').replace("\\\\", "\\"))
            continue
        if text[i] == "'" and not text[i - 1:i].isalnum():
            i = text.index("'", i + (3 if text[i + 1] == "\\" else 2))
        elif text[i] in "([" and (text[:i].rstrip()[-1:].isalnum() or text[:i].rstrip()[-1:] in ("_", "]")):
            i = end_of_group(text, i) - 1
        i += 1
    return out


def arguments(text):
    out, i, begin = [], 0, 0
    while i < len(text):
        if text[i] == '"':
            i = end_of_string(text, i)
        elif text[i] in "([{":
            i = end_of_group(text, i)
        else:
            if text[i] == ",":
                out.append(text[begin:i])
                begin = i + 1
            i += 1
    return out + [text[begin:]]


def functions_of(text):
    """By name of free functions and of members: the numbers of their parameters that are sentences."""
    free, members = {}, {}
    for found in [*kFunction.finditer(text), *kLambda.finditer(text)]:
        *indent, name, parameters = found.groups()
        numbers = [i for i, p in enumerate(parameters.split(",")) if "Sentence" in p or "* pattern" in p]
        (members if indent and indent[0] else free).setdefault(name, set()).update(numbers)
    return free, members


def statement(text, begin):
    """Up to its semicolon."""
    i = begin
    while i < len(text) and text[i] != ";":
        if text[i] == '"':
            i = end_of_string(text, i)
        elif text[i] in "([{":
            i = end_of_group(text, i)
        elif text[i] in ")]}":
            break
        else:
            i += 1
    return text[begin:i]


def patterns_of(text, free, members):
    own_free, own_members = functions_of(text)
    bare = {**free, **own_free, **own_members, **dict.fromkeys(kAlways, kAll), **kAggregates}
    for call in re.finditer(r"(\.|->)?\b(notes\.push_back|\w+)\s*([({])", text):
        name = call.group(2)
        numbers = kAll if name.startswith("notes.") else bare.get(name) or (members.get(name) if call.group(1) else None)
        if numbers:
            given = arguments(text[call.end():end_of_group(text, call.end() - 1) - 1])
            for number, argument in enumerate(given):
                if number in numbers:
                    yield from literals(argument)
    for variable in kVariable.finditer(text):
        begin = variable.end() - (variable.group(0)[-1] in "({")
        if text[begin] != "(" or not kBody.match(text, end_of_group(text, begin)):
            yield from literals(statement(text, begin))
    for function in kReturning.finditer(text):
        if "const char*" in function.group(0):
            continue
        body = text[function.end() - 1:end_of_group(text, function.end() - 1)]
        for back in re.finditer(r"\breturn\b", body):
            yield from literals(statement(body, back.end()))


def sources(root):
    for source in kSources:
        for file in sorted((root / source).rglob("*")):
            shown = not any(file.is_relative_to(root / folder) for folder in kNotShown)
            if shown and file.suffix in (".h", ".cpp"):
                yield file, without_comments(file.read_text())


def patterns(root):
    """By pattern the file in which it comes first."""
    texts = list(sources(root))
    free, members = {}, {}
    for file, text in texts:
        if file.suffix == ".h":
            for all_names, names in zip((free, members), functions_of(text)):
                for name, numbers in names.items():
                    all_names.setdefault(name, set()).update(numbers)
    out = {}
    for file, text in texts:
        for pattern in patterns_of(text, free, members):
            if kWord.search(pattern) and not kKey.fullmatch(pattern):
                out.setdefault(pattern, file.relative_to(root))
    return out


def quoted(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def main():
    root = pathlib.Path(__file__).resolve().parents[3]
    lines = ["// Made by patterns.py."] + ["QT_TRANSLATE_NOOP(\"refusal\", %s)" % quoted(p) for p in sorted(patterns(root))]
    text = "\n".join(lines) + "\n"
    if len(sys.argv) > 1:
        pathlib.Path(sys.argv[1]).write_text(text)
    else:
        print(text, end="")


if __name__ == "__main__":
    main()
