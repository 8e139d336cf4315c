#!/usr/bin/env python3
"""Mending of perturbed scenes: which share of "rests on" comes back, how far objects move. Markdown.

    perf/mend_noise.py TRIVET [--demos breakfast office1 ...] [--noise 1 5 20] [--runs 1]

Every free object of a demo is moved by a normal deviate on each axis (mm) and turned about a random axis (1, 3 and 10 degrees at 1, 5
and 20 mm). Then the scene is mended, judged, and its supports are compared with those that it had. The scenes are driven by
`trivet mcp`."""
import argparse
import json
import os
import random
import statistics
import subprocess
import tempfile

DEGREES = {1: 1, 5: 3, 20: 10}


class Agent:
    def __init__(self, program, folder):
        self.server = subprocess.Popen([program, "mcp", folder], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def call(self, tool, **arguments):
        request = {"jsonrpc": "2.0", "id": 1, "method": "tools/call", "params": {"name": tool, "arguments": arguments}}
        print(json.dumps(request), file=self.server.stdin, flush=True)
        result = json.loads(self.server.stdout.readline())["result"]
        if result["isError"]:
            raise SystemExit(tool + ": " + result["content"][0]["text"])
        return result.get("structuredContent")

    def processor_seconds(self):
        with open("/proc/%d/stat" % self.server.pid) as file:
            user, system = file.read().rsplit(")", 1)[1].split()[11:13]
        return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")

    def objects(self):
        out, count = [], 1
        while len(out) < count:
            data = self.call("list", first=len(out))
            out, count = out + data["objects"], data["count"]
        return {one["object"]: one for one in out}


def perturb(agent, free, noise, generator):
    for name, one in free.items():
        agent.call("translate", object=name, by=[generator.gauss(0, noise / 1000) for _ in range(3)], free=True, settle_left=False)
        axis = [generator.gauss(0, 1) for _ in range(3)]
        agent.call("rotate", object=name, axis=axis, angle_deg=generator.gauss(0, DEGREES.get(noise, noise / 2)),
                   centre=[(a + b) / 2 for a, b in zip(one["lower"], one["upper"])], free=True, settle_left=False)


def edges(objects):
    return {(name, below) for name, one in objects.items() if one["state"] != "fixed" for below in one.get("on", [])}


def run(program, folder, demo, noise, seed):
    agent = Agent(program, folder)
    agent.call("open", file=demo + ".glb")
    before = agent.objects()
    free = {name: one for name, one in before.items() if one["state"] not in ("fixed", "unplaced")}
    perturb(agent, free, noise, random.Random(seed))
    begin = agent.processor_seconds()
    mended = agent.call("mend")
    seconds = agent.processor_seconds() - begin
    verdict = agent.call("check")
    kept = edges(before) & edges(agent.objects())
    agent.server.stdin.close()
    agent.server.wait()
    ways = [1000 * one["metres"] for one in mended["moved"]]
    return {"kept": len(kept), "edges": len(edges(before)), "free": len(free), "unable": len(mended["unable"]),
            "tipped": sum(one["degrees"] > 45 for one in mended["moved"]), "true": verdict["ok"], "ways": ways, "seconds": seconds}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--demos", nargs="+", default=["breakfast", "office1", "office2"])
    parser.add_argument("--noise", nargs="+", type=int, default=[1, 5, 20])
    parser.add_argument("--runs", type=int, default=1)
    arguments = parser.parse_args()
    print("| scene | noise, mm | free | kept | share | no place | tipped | true | moved median, largest, mm | CPU s an object |")
    print("|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|")
    with tempfile.TemporaryDirectory() as folder:
        for demo in arguments.demos:
            subprocess.run([arguments.program, "demo", demo, "-o", f"{folder}/{demo}.glb", "--quiet"], check=True)
            for noise in arguments.noise:
                runs = [run(arguments.program, folder, demo, noise, seed) for seed in range(1, arguments.runs + 1)]
                total = {key: sum(one[key] for one in runs) for key in runs[0] if key != "ways"}
                ways = [way for one in runs for way in one["ways"]]
                print("| %s | %d | %d | %d of %d | %.3f | %d | %d | %d of %d | %.1f, %.0f | %.2f |" % (
                    demo, noise, total["free"], total["kept"], total["edges"], total["kept"] / total["edges"], total["unable"],
                    total["tipped"], total["true"], len(runs), statistics.median(ways), max(ways),
                    total["seconds"] / total["free"]), flush=True)


if __name__ == "__main__":
    main()
