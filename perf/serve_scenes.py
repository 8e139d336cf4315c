#!/usr/bin/env python3
"""Latency of GET /scenes/K of `trivet serve`, each K asked for once. Markdown.

    perf/serve_scenes.py TRIVET RECIPE.json [--count 300] [--clients 1 2 4]
"""
import argparse
import http.client
import json
import statistics
import subprocess
import threading
import time


def ask(address, ks, seconds):
    connection = http.client.HTTPConnection(address, timeout=600)
    for k in ks:
        begin = time.monotonic()
        connection.request("GET", "/scenes/%d" % k)
        response = connection.getresponse()
        scene = json.loads(response.read())
        seconds.append(time.monotonic() - begin)
        assert response.status == 200 and scene["k"] == k, scene
    connection.close()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("trivet")
    parser.add_argument("recipe")
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--clients", type=int, nargs="+", default=[1, 2, 4])
    arguments = parser.parse_args()
    server = subprocess.Popen([arguments.trivet, "serve", "--recipe", arguments.recipe], stdout=subprocess.PIPE, text=True)
    address = json.loads(server.stdout.readline())["serving"][len("http://"):]
    print("| clients at once | scenes | median | 99 % | scenes per second |\n|--:|--:|--:|--:|--:|")
    first = 0
    for clients in arguments.clients:
        seconds, begin = [], time.monotonic()
        threads = [threading.Thread(target=ask, args=(address, range(first + i, first + arguments.count, clients), seconds))
                   for i in range(clients)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        wall = time.monotonic() - begin
        assert len(seconds) == arguments.count
        slow = sorted(seconds)[int(0.99 * (len(seconds) - 1))]
        print("| %d | %d | %.1f ms | %.1f ms | %.1f |" % (
            clients, len(seconds), 1e3 * statistics.median(seconds), 1e3 * slow, len(seconds) / wall), flush=True)
        first += arguments.count
    server.terminate()
    server.wait()


if __name__ == "__main__":
    main()
