"""Every sentence of an error of files, or of a conflict of arrangements, has a pattern that the editor translates.

known_sentences.py SOURCES. Reads the calls that make such sentences, with "§" for what is not literal, and lists the words that no
pattern of apps/edit/document/patterns_*.cpp has.
"""
import pathlib
import re
import sys

# Sources of sentences that the editor can show.
kSources = ["core/io", "core/base/bad_input.h", "ops/files/arrange", "ops/files/json", "ops/files/layout", "ops/files/report",
            "ops/session/journal.cpp", "ops/session/journal_text.cpp", "ops/session/restore.cpp", "ops/session/recorded_sources.cpp", "ops/arrange",
            "ops/simulation/scene_formats.cpp", "ops/simulation/simulate_mujoco.cpp", "apps/edit/document"]
kCall = re.compile(r"\b(?:bad_file|bad_input|bad|fail|fail_environment|fail_changed|refuse|note|Error|notes\.push_back|insert)\s*\(")
kLiteral = re.compile(r'"((?:[^"\\]|\\.)*)"')
kLeast = 200  # calls: fewer would mean that none is found
kMark = "§"
# Words of formats, of the program's own language and of keys, the same in every language.
kNames = re.compile(r'"[^"]*"|\'[^\']*\'|/[a-z/]+|\[[^\]]*\]|\{[^}]*\}|--\w[\w-]*|\.[a-z]+')


def patterns(folder):
    for file in folder.glob("patterns_*.cpp"):
        text = file.read_text()
        for call in re.finditer(r'QT_TRANSLATE_NOOP\("refusal",((?:\s*"(?:[^"\\]|\\.)*")+)\)', text):
            yield "".join(kLiteral.findall(call.group(1))).replace('\\"', '"')


def arguments(text, begin):
    """Of a call, split at its commas."""
    depth, i, out, start = 0, begin, [], begin + 1
    while i < len(text):
        if text[i] == '"':
            i = kLiteral.match(text, i).end() - 1
        elif text[i] == "'":
            i = text.index("'", i + (3 if text[i + 1] == "\\" else 2))
        elif text[i] in "([{":
            depth += 1
        elif text[i] in ")]}":
            depth -= 1
            if depth == 0:
                return out + [text[start:i]]
        elif text[i] == "," and depth == 1:
            out.append(text[start:i])
            start = i + 1
        i += 1
    return []


def sentence(argument):
    """Literals in their order, with marks for what is between them; of a choice both sides, one after the other."""
    out, end = "", 0
    for literal in kLiteral.finditer(argument):
        if argument[end:literal.start()].strip(" \n+("):
            out += kMark
        out += literal.group(1).replace('\\"', '"')
        end = literal.end()
    return out + (kMark if argument[end:].strip(" \n+)") else "")


class Reader:
    def __init__(self, all_patterns):
        self.known = []
        for pattern in all_patterns:
            between = re.split(r"%\d", pattern)
            self.known.append((len("".join(between)), between))
        self.known.sort(key=lambda one: -one[0])

    def left(self, text, depth=0):
        """What no pattern has."""
        if depth < 16:
            for _, between in self.known:
                parts = self.parts(text, between)
                if parts is not None:
                    return [word for part in parts for word in self.left(part, depth + 1)]
        if any(text in piece for _, between in self.known for piece in between):
            return []
        return [word for word in re.findall(r"[A-Za-z]{2,}", kNames.sub("", text)) if not word.isupper()]

    @staticmethod
    def parts(text, between):
        if len(between) == 1:
            return [] if text == between[0] else None
        if not text.startswith(between[0]):
            return None
        out, begin = [], len(between[0])
        for i, following in enumerate(between[1:], 1):
            last = i + 1 == len(between)
            end = len(text) - len(following) if last and text.endswith(following) else -1 if last else text.find(following, begin)
            if end <= begin:
                return None
            part = text[begin:end]
            if between[i - 1].endswith('"') and following.startswith('"') and '"' in part:
                return None
            out.append(part)
            begin = end + len(following)
        return out


def pieces(said):
    """Of a sentence that is made of others: what stands between marks and what joins sentences."""
    return [piece.strip(' "\'') for piece in re.split(f"{kMark}|; accepted(?: for|:)|: |; ", said) if piece.strip()]


def calls(root):
    for source in kSources:
        at = root / source
        for file in sorted(at.rglob("*.cpp")) + sorted(at.rglob("*.h")) if at.is_dir() else [at]:
            if "patterns_" in file.name:
                continue
            text = re.sub(r"^\s*//.*$", "", file.read_text(), flags=re.M)
            for call in kCall.finditer(text):
                for argument in arguments(text, call.end() - 1):
                    said = sentence(argument)
                    if re.search("[a-z]{2,} [a-z]{2,}", said):
                        yield file.relative_to(root), said


def main():
    root = pathlib.Path(sys.argv[1])
    reader = Reader(list(patterns(root / "apps/edit/document")))
    count = num_bad = 0
    for file, said in calls(root):
        count += 1
        left = [w for part in pieces(said) for w in reader.left(part)] if reader.left(said) else []
        if left:
            num_bad += 1
            print(f"  {file}: {said!r}: {' '.join(left)}")
    print(f"{count} sentences, {num_bad} without a pattern")
    return 0 if count >= kLeast and num_bad == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
