"""Every sentence that the editor can show is a pattern in the sources, and has a translation.

known_sentences.py SOURCES. Fails for a pattern without a finished translation, and for an error whose text is put together from
strings, which nothing could translate.
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

kLeast = 500  # patterns: fewer would mean that they are not found
kThrown = re.compile(r"\b(?:Error|bad_input|bad_file|environment_error|say|refuse|fail|fail_environment|cannot_listen)\s*\(")


def translated(file):
    for context in ElementTree.parse(file).getroot().iter("context"):
        if context.find("name").text == "refusal":
            for message in context.iter("message"):
                if message.find("translation").get("type") is None:
                    yield message.find("source").text


def put_together(text, patterns):
    """Arguments of sentences that add strings to a literal."""
    for call in kThrown.finditer(text):
        for argument in patterns.arguments(text[call.end():patterns.end_of_group(text, call.end() - 1) - 1]):
            if re.match(r'\s*(?:std::string\()?"[^"]*[a-z]{2} [^"]*"\)?\s*\+', argument) or re.search(
                    r'\+\s*"[^"]*[a-z]{2} [^"]*"\s*$', argument):
                yield " ".join(argument.split())


def main():
    root = pathlib.Path(sys.argv[1])
    languages = root / "apps/edit/languages"
    sys.path.insert(0, str(languages))
    sys.dont_write_bytecode = True
    import patterns

    found, known = patterns.patterns(root), set(translated(languages / "trivet-edit_de.ts"))
    bad = [f"{file}: {pattern!r} has no translation" for pattern, file in found.items() if pattern not in known]
    bad += [f"{file.relative_to(root)}: {text} is put together" for file, content in patterns.sources(root)
            for text in put_together(content, patterns)]
    for line in bad:
        print("  " + line)
    print(f"{len(found)} patterns, {len(bad)} findings")
    return 0 if len(found) >= kLeast and not bad else 1


if __name__ == "__main__":
    sys.exit(main())
