"""Every text of the editor's sources has a translation: lists those that have none, which are shown in English.

translations.py SOURCES. Fails if any is missing, or if a translation lost a %1 or its underlined letter. Status 77: no lupdate.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

kLupdate = shutil.which("lupdate", path="/usr/lib/qt6/bin:/usr/lib64/qt6/bin:/usr/bin")


def messages(file):
    for context in ElementTree.parse(file).getroot().iter("context"):
        for message in context.iter("message"):
            yield context.find("name").text, message


def texts_of(translation):
    forms = translation.findall("numerusform")
    return [form.text or "" for form in forms] if forms else [translation.text or ""]


def placeholders(text):
    return sorted(re.findall(r"%\d|%n", text))


def wrong_with(message):
    source, translation = message.find("source").text, message.find("translation")
    if translation.get("type") == "unfinished":
        return None
    for text in texts_of(translation):
        if not text:
            return "is empty"
        if placeholders(text) != placeholders(source):
            return f"has other placeholders: {text!r}"
        if ("&" in source) != ("&" in text) and "<" not in source:
            return f"has another mnemonic: {text!r}"
    return None


def check(sources, file):
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / file.name
        shutil.copy(file, copy)
        subprocess.run([kLupdate, "-silent", "-no-obsolete", "-locations", "none", "-I", ".", "apps/edit", "-ts", copy],
                       cwd=sources, check=True)
        found = list(messages(copy))
    missing = [f"{context}: {m.find('source').text!r}" for context, m in found
               if m.find("translation").get("type") == "unfinished"]
    wrong = [f"{m.find('source').text!r} {why}" for _, m in found if (why := wrong_with(m))]
    print(f"{file.name}: {len(found)} texts, {len(missing)} without a translation, {len(wrong)} wrong")
    for line in missing + wrong:
        print("  " + line)
    return len(found) > 400 and not missing and not wrong


def main():
    if not kLupdate:
        print("skipped: no lupdate (Debian: qt6-l10n-tools)")
        return 77
    sources = pathlib.Path(sys.argv[1])
    files = sorted((sources / "apps/edit/languages").glob("*.ts"))
    return 0 if files and all([check(sources, file) for file in files]) else 1


if __name__ == "__main__":
    sys.exit(main())
