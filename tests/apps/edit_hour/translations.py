"""Every text of the editor's sources has a translation: lists those that have none, which are shown in English.

translations.py SOURCES. Fails if any is missing, or if a translation lost a %1 or its underlined letter. Status 77: no lupdate.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

kLupdate = shutil.which("lupdate", path="/usr/lib/qt6/bin:/usr/lib64/qt6/bin:/usr/bin")
kLeast = {"trivet-edit_de.ts": 700, "trivet-edit_en.ts": 8}  # texts; English has those with a number alone


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


def check(file):
    found = list(messages(file))
    missing = [f"{context}: {m.find('source').text!r}" for context, m in found
               if m.find("translation").get("type") == "unfinished"]
    wrong = [f"{m.find('source').text!r} {why}" for _, m in found if (why := wrong_with(m))]
    print(f"{file.name}: {len(found)} texts, {len(missing)} without a translation, {len(wrong)} wrong")
    for line in missing + wrong:
        print("  " + line)
    return len(found) >= kLeast[file.name] and not missing and not wrong


def main():
    if not kLupdate:
        print("skipped: no lupdate (Debian: qt6-l10n-tools)")
        return 77
    languages = pathlib.Path(sys.argv[1]) / "apps/edit/languages"
    with tempfile.TemporaryDirectory() as folder:
        for name in kLeast:
            shutil.copy(languages / name, folder)
        subprocess.run(["bash", languages / "update.sh", folder], env={**os.environ, "LUPDATE": kLupdate}, check=True)
        return 0 if all([check(pathlib.Path(folder) / name) for name in kLeast]) else 1


if __name__ == "__main__":
    sys.exit(main())
