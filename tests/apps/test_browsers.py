"""A page in a real browser that tries to reach `trivet serve` in every way that it can: nothing is computed for it."""
import http.server
import json
import os
import shutil
import subprocess
import threading

from program import SLAB
from serving import Served, main_if_built

CHROMIUM = shutil.which("chromium")
PAGE = """<!doctype html><title>evil</title><body><script>
const at = "http://127.0.0.1:PORT", renamed = "http://rebound.test:PORT";
const put = JSON.stringify({op: "put", object: "b", position: [0, 0, 1]});
const told = [];
const tell = (what, result) => told.push(what + ": " + result);
const tag = (what, name, fill) => new Promise(done => {
  const made = document.createElement(name);
  made.onload = () => { tell(what, "loaded"); done(); };
  made.onerror = () => { tell(what, "failed"); done(); };
  fill(made);
  document.body.append(made);
});
const ask = (what, url, options) => fetch(url, options).then(
  async answer => tell(what, answer.type === "opaque" ? "opaque" : answer.status), () => tell(what, "failed"));
const form = (what, action) => new Promise(done => {
  const frame = document.createElement("iframe"), made = document.createElement("form");
  frame.name = what;
  document.body.append(frame, made);
  Object.assign(made, {method: "POST", action, target: what, enctype: "text/plain"});
  made.innerHTML = "<input name='{\\"start\\": \\"layout.json\\", \\"x' value='\\": 1}'>";
  frame.onload = () => { tell(what, "answered"); done(); };
  setTimeout(done, 1500);
  made.submit();
});
const socket = (what, url) => new Promise(done => {
  const made = new WebSocket(url);
  made.onopen = () => { tell(what, "open"); done(); };
  made.onerror = () => { tell(what, "failed"); done(); };
});
(async () => {
  for (const [name, base] of [["", at], ["renamed ", renamed]]) {
    await tag(name + "img", "img", i => i.src = base + "/scenes/1");
    await tag(name + "script", "script", i => i.src = base + "/scenes/2");
    await tag(name + "frame", "iframe", i => i.src = base + "/scenes/3");
    await ask(name + "get", base + "/scenes/4");
    await ask(name + "get no-cors", base + "/scenes/5/scene.glb", {mode: "no-cors"});
    await ask(name + "head", base + "/scenes/5", {mode: "no-cors", method: "HEAD"});
    await ask(name + "post", base + "/sessions", {method: "POST", body: ""});
    await ask(name + "post no-cors", base + "/sessions", {method: "POST", mode: "no-cors", body: ""});
    await ask(name + "put in SESSION", base + "SESSION", {method: "POST", mode: "no-cors", body: put});
    await ask(name + "delete SESSION", base + "SESSION", {method: "DELETE"});
    await ask(name + "metrics", base + "/metrics");
    await form(name + "form", base + "/sessions");
    await socket(name + "socket", base.replace("http", "ws") + "/scenes/6");
    navigator.sendBeacon(base + "/sessions", "");
  }
  await fetch("/told", {method: "POST", body: JSON.stringify(told)});
})();
</script>"""


class Attacker:
    """Serves the page, and keeps what it tells."""

    def __init__(self, page):
        self.told = None
        self.asked = threading.Event()
        attacker = self

        class Handler(http.server.BaseHTTPRequestHandler):
            def answer(self, body):
                self.send_response(200)
                self.send_header("Content-Type", "text/html")
                self.send_header("Content-Length", str(len(body)))
                self.end_headers()
                self.wfile.write(body)

            def do_GET(self):
                self.answer(page.encode() if self.path == "/" else b"")

            def do_POST(self):
                attacker.told = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
                self.answer(b"")
                attacker.asked.set()

            def log_message(self, *_):
                pass

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.port = self.server.server_address[1]
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def end(self):
        self.server.shutdown()
        self.server.server_close()


class Browsers(Served):
    def setUp(self):
        super().setUp()
        if not CHROMIUM:
            self.skipTest("there is no chromium (Debian: chromium)")
        self.write("recipe.json", json.dumps({
            "trivet_recipe": 1, "objects": [SLAB],
            "groups": [{"name": "box", "models": [{"model": "cube.obj"}], "count": [1, 4],
                        "rotation": "any", "in": "slab", "above": 0.02}]}))

    def browse(self, url):
        """The browser at this page, whose names all lead to this machine. Ended by the caller."""
        return subprocess.Popen(
            [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
             "--host-resolver-rules=MAP evil.test 127.0.0.1, MAP rebound.test 127.0.0.1", "--no-proxy-server",
             "--user-data-dir=" + self.path("profile"), "--remote-debugging-port=0", url],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={**os.environ, "HOME": self.folder})

    def metrics(self, server):
        text = server.ask("GET", "/metrics")[1].decode()
        return {k: float(v) for k, v in (line.rsplit(" ", 1) for line in text.splitlines() if line[:1] != "#")}

    def computed(self, metrics):
        """Requests that were answered by more than a refusal, but those for the metrics."""
        return {k: v for k, v in metrics.items() if k.startswith("trivet_requests_total{") and "/metrics" not in k}

    def attack(self, server, host):
        """A page of this host. Returns what it tells."""
        session = server.open()
        state = server.ask("POST", session, {"query": "b"})[1]["state"]
        before = self.metrics(server)
        port = server.address.rsplit(":", 1)[1]
        attacker = Attacker(PAGE.replace("PORT", port).replace("SESSION", session))
        browser = self.browse("http://%s:%d/" % (host, attacker.port))
        try:
            self.assertTrue(attacker.asked.wait(60), "the page told nothing")
        finally:
            browser.kill()
            browser.wait()
            attacker.end()
        after = self.metrics(server)
        self.assertEqual(self.computed(after), self.computed(before), attacker.told)
        self.assertEqual(after["trivet_sessions"], before["trivet_sessions"])
        self.assertGreaterEqual(after["trivet_requests_refused_total"] - before.get("trivet_requests_refused_total", 0), 20)
        self.assertEqual(server.ask("POST", session, {"query": "b"})[1]["state"], state)
        return attacker.told

    def test_a_page_computes_nothing(self):
        with self.server("--recipe", "recipe.json") as server:
            # Another site, and another port of the same machine, which browsers call the same site.
            for host in ("evil.test", "127.0.0.1", "localhost"):
                told = self.attack(server, host)
                print("%s: %s" % (host, "; ".join(told)))
                self.assertGreaterEqual(len(told), 22)
                for one in told:
                    what, _, result = one.rpartition(": ")
                    self.assertNotIn(result, ("200", "201", "open"), one)
                    if "img" in what or "script" in what:
                        self.assertEqual(result, "failed", one)

    def test_a_name_that_was_bound_to_this_machine(self):
        """The page's own name leads here now: for the browser, requests are of its own site."""
        with self.server("--recipe", "recipe.json") as server:
            before = self.metrics(server)
            port = server.address.rsplit(":", 1)[1]
            out = subprocess.run(
                [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--dump-dom", "--no-proxy-server",
                 "--host-resolver-rules=MAP rebound.test 127.0.0.1", "--user-data-dir=" + self.path("profile"),
                 "http://rebound.test:%s/scenes/3" % port], capture_output=True, text=True, timeout=60,
                env={**os.environ, "HOME": self.folder}, check=False).stdout
            after = self.metrics(server)
            self.assertIn("another name", out)
            self.assertEqual(self.computed(after), self.computed(before))


if __name__ == "__main__":
    main_if_built()
