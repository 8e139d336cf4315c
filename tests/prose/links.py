#!/usr/bin/env python3
"""Looks for links that lead nowhere: files, and places in pages.
    tests/prose/links.py ROOT           relative links of the Markdown files of a checkout
    tests/prose/links.py --site FOLDER  links, pictures and anchors of the pages of a site
Prints each finding; the status is 1 where there is one. Addresses of other machines are counted, not opened."""
import html.parser
import re
import subprocess
import sys
import urllib.parse
from pathlib import Path

LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
CODE = re.compile(r"^```.*?^```$|`[^`\n]*`", re.M | re.S)
OTHERS = ("http:", "https:", "mailto:", "data:")


class Page(html.parser.HTMLParser):
    """Links and anchors of a page."""

    def __init__(self, path):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for key, value in attributes:
            if key == "id" or (tag == "a" and key == "name"):
                self.anchors.add(value)
            elif key in ("href", "src") and value:
                self.links.append(value)


def heading_anchor(heading):
    """As GitHub and MyST name a heading."""
    return re.sub(r"[^\w\- ]", "", re.sub(r"[`*]|\]\([^)]*\)", "", heading).strip().lower()).replace(" ", "-")


def markdown_pages(root):
    done = subprocess.run(["git", "-C", root, "ls-files", "*.md"], capture_output=True, text=True, check=True)
    for name in done.stdout.split("\n"):
        if name:
            text = CODE.sub(lambda found: "\n" * found.group().count("\n"), (root / name).read_text(encoding="utf-8"))
            anchors = {heading_anchor(one) for one in re.findall(r"^#+ (.*)$", (root / name).read_text(encoding="utf-8"), re.M)}
            yield root / name, LINK.findall(text), anchors


def site_pages(root):
    for path in sorted(root.rglob("*.html")):
        if "_static" not in path.parts:
            page = Page(path)
            yield path, page.links, page.anchors


def main():
    is_site = sys.argv[1] == "--site"
    root = Path(sys.argv[-1]).resolve()
    pages = {path: (links, anchors) for path, links, anchors in (site_pages(root) if is_site else markdown_pages(root))}
    num_links = num_others = 0
    wrong = []
    for path, (links, _) in pages.items():
        for link in links:
            if link.startswith(OTHERS):
                num_others += 1
                continue
            num_links += 1
            file, _, anchor = urllib.parse.unquote(link).partition("#")
            target = (path.parent / file.partition("?")[0]).resolve() if file else path
            if not target.exists():
                wrong.append(f"{path.relative_to(root)}: {link}: there is no such file")
            elif anchor and target in pages and anchor not in pages[target][1]:
                wrong.append(f"{path.relative_to(root)}: {link}: the page has no such place")
    print("\n".join(wrong + [f"{len(pages)} pages, {num_links} links, {num_others} to other machines, {len(wrong)} wrong"]))
    return 1 if wrong or num_links == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
