#!/usr/bin/env python3
"""Looks at pages of the built site in Chromium, at the widths of a desk and of a telephone, and takes pictures of them.
    tests/prose/pages.py SITE [PICTURES]
A page must be no wider than its window, its pictures must load, its formulas must be set, and wide tables must scroll in
frames of their own; code fits the page of a desk. Status 1: findings, which are printed; 77: there is no Chromium (Debian: chromium)."""
import base64
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

WIDTHS = (1280, 390)
PAGES = ("index", "tutorial/command-line", "tutorial/editor", "guide/put", "guide/simulators", "reference/command-line",
         "reference/layouts", "reference/refusals", "python/api", "design/first-contact", "design/architecture",
         "measurements/index", "measurements/settling", "measurements/field")
MOST_HIGH = 6000  # of a picture, pixels; the rest of a long page looks like its beginning

# Gives what is wrong on a page, as a list of sentences. MathJax has finished when its queue is through.
FINDINGS = r"""
(async () => {
  if (window.MathJax) await new Promise((done) => MathJax.Hub.Queue(done));
  for (const image of document.images) { image.loading = "eager"; await image.decode().catch(() => 0); }
  const found = [], wide = innerWidth;
  const total = document.scrollingElement.scrollWidth;
  if (total > wide) found.push(`the page is ${total} pixels wide`);
  for (const image of document.images)
    if (!image.naturalWidth) found.push(`no picture: ${image.getAttribute("src")}`);
  for (const formula of document.querySelectorAll("span.math.notranslate, div.math.notranslate"))
    if (!formula.querySelector(".MathJax")) found.push("formula is not set: " + formula.textContent);
  for (const bad of document.querySelectorAll(".MathJax_Error, .merror")) found.push("formula: " + bad.textContent);
  const frames = (e) => { for (; e; e = e.parentElement) if (/auto|scroll/.test(getComputedStyle(e).overflowX)) return true; };
  for (const e of document.querySelectorAll("article p, article table, article pre, article img, article .math, article h1, article h2")) {
    const box = e.getBoundingClientRect();
    if (box.width && box.right > wide + 1 && !frames(e.parentElement))
      found.push(`${e.tagName.toLowerCase()} ends at ${Math.round(box.right)}: ${e.textContent.trim().slice(0, 60)}`);
  }
  if (wide > 1000)
    for (const e of document.querySelectorAll("article pre"))
      if (e.scrollWidth > e.clientWidth) found.push(`code is cut off: ${e.textContent.trim().split("\n")[0].slice(0, 60)}`);
  return {found, high: document.scrollingElement.scrollHeight};
})()"""


class Browser:
    """Chromium without a window, spoken to in its protocol for developers over two pipes."""

    def __init__(self, program, folder):
        to_child, self.to = os.pipe()
        self.back, from_child = os.pipe()
        self.number, self.rest = 0, b""

        def pipes():  # The protocol's descriptors are 3 and 4.
            one, two = os.dup(to_child), os.dup(from_child)
            os.dup2(one, 3)
            os.dup2(two, 4)

        self.process = subprocess.Popen(
            [program, "--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", "--hide-scrollbars",
             "--allow-file-access-from-files", "--user-data-dir=" + folder],
            preexec_fn=pipes, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            env={**os.environ, "HOME": folder})
        os.close(to_child)
        os.close(from_child)
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.ask("Page.enable")

    def receive(self):
        while b"\0" not in self.rest:
            part = os.read(self.back, 1 << 16)
            if not part:
                raise RuntimeError("Chromium has ended")
            self.rest += part
        message, self.rest = self.rest.split(b"\0", 1)
        return json.loads(message)

    def ask(self, method, **params):
        self.number += 1
        message = {"id": self.number, "method": method, "params": params}
        if hasattr(self, "session"):
            message["sessionId"] = self.session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]

    def open(self, url, width):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=width < 600)
        self.ask("Page.navigate", url=url)
        while self.receive().get("method") != "Page.loadEventFired":
            pass

    def value(self, script):
        answer = self.ask("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"]["exception"].get("description", "a script failed"))
        return answer["result"]["value"]

    def picture(self, width, height):
        clip = {"x": 0, "y": 0, "width": width, "height": height, "scale": 1}
        return base64.b64decode(self.ask("Page.captureScreenshot", clip=clip, captureBeyondViewport=True)["data"])

    def end(self):
        self.process.terminate()
        self.process.wait()


def look(browser, site, pictures):
    """Findings of all pages."""
    for page in PAGES:
        for width in WIDTHS:
            browser.open((site / (page + ".html")).as_uri(), width)
            seen = browser.value(FINDINGS)
            yield from (f"{page}.html at {width}: {one}" for one in seen["found"])
            if pictures:
                name = f"{page.replace('/', '-')}-{width}.png"
                (pictures / name).write_bytes(browser.picture(width, min(seen["high"], MOST_HIGH)))


def main():
    site = Path(sys.argv[1]).resolve()
    pictures = Path(sys.argv[2]) if len(sys.argv) > 2 else None
    program = shutil.which("chromium") or shutil.which("google-chrome")
    if not program:
        print("skipped: no chromium (Debian: chromium)")
        return 77
    if pictures:
        pictures.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        browser = Browser(program, folder)
        try:
            found = list(look(browser, site, pictures))
        finally:
            browser.end()
    print("\n".join(found) if found else f"{len(PAGES)} pages at {len(WIDTHS)} widths: as they should be")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
