"""Sends valid and invalid requests of every operation of the contract, and checks that each gets a described answer in time.

usage: PELAGE_BIN=build/tests/bin python3 tests/soak/request_fuzzer.py [SECONDS] [PER_OPERATION] [SEED]

Runs until SECONDS have passed and each operation has had PER_OPERATION requests, but for at most four times the seconds. Exits with 1 if a request was
answered with 5xx other than 503 and 507 (busy, no room), with a status or a problem that the contract does not describe, or after more than ten seconds plus
one for each 20 MB.
"""
import collections
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import threading
import time
import urllib.parse

import bodies
import mutate
from support.server import BIN, Server

CLIENTS = 3
MAX_SECONDS = 10  # plus the time for the bytes of a large answer: all strands of a coat are some hundred megabytes
BYTES_A_SECOND = 2e7
ROUND = 150  # requests that a client makes before it takes a new scene
CAPS = {"width": 64, "height": 64, "triangles": 800, "passes": 2, "size": 64, "wait": 0.2, "levels": 1, "shells": 16, "count": 2000, "keys": 50,
        "strands": 2000, "seconds": 1, "budget_ms": 200, "scale": 2, "steps": 3, "duration": 5, "dilate": 16}
CONTRACT = json.loads((BIN / "openapi.json").read_text())
BUSY = (429, 503, 507)


def operations():
    return [(method, path, {**item[method], "parameters": item[method].get("parameters", []) + item.get("parameters", [])})
            for path, item in CONTRACT["paths"].items() for method in ("get", "post", "put", "delete") if method in item]


def resolved(node):
    while "$ref" in node:
        target = CONTRACT
        for step in node["$ref"].removeprefix("#/").split("/"):
            target = target[int(step)] if isinstance(target, list) else target[step]
        node = target
    return node


def documents():
    """Returns valid documents by the name of their schema: those that the property tests make, and the contract's examples."""
    found = collections.defaultdict(list)
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "documents"
        subprocess.run([BIN / "property_json", "--gtest_filter=Described*"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                       env={**os.environ, "PELAGE_DOCUMENTS": str(file)})
        for line in file.read_text(encoding="utf-8").splitlines():
            name, text = line.split(" ", 1)
            found[name].append(json.loads(text))
    for name, schema in CONTRACT["components"]["schemas"].items():
        found[name] += schema.get("examples", []) + ([schema["example"]] if "example" in schema else [])
    return found


def names_of(schema):
    """Names of the schemas that a body may have."""
    if "$ref" in schema:
        name = schema["$ref"].rsplit("/", 1)[1]
        inner = resolved(schema)
        return [name] + [one for choice in inner.get("oneOf", []) for one in names_of(choice)]
    return [one for choice in schema.get("oneOf", []) for one in names_of(choice)]


class Fuzzer:
    def __init__(self, server, seed):
        self.server, self.seed = server, seed
        self.documents = documents()
        guides, saved = bodies.exported(server)
        self.files = {"model": list(bodies.MODELS.values()), "guides": list(guides.values()), "open": [saved]}
        self.counts, self.statuses = collections.Counter(), collections.Counter()
        self.faults, self.slowest, self.lock = [], (0, ""), threading.Lock()

    def parameter(self, rng, parameter):
        """Returns name and value of a query or header parameter; None to leave it out."""
        parameter = resolved(parameter)
        if rng.random() < 0.5 and not parameter.get("required"):
            return None
        schema = resolved(parameter.get("schema", {}))
        right = schema.get("enum") or [schema.get("default", 1), schema.get("minimum", 0), min(schema.get("maximum", 1), CAPS.get(parameter["name"], 10))]
        value = rng.choice(right) if rng.random() < 0.7 else mutate.odd_value(rng, 1)
        return parameter["name"], str(mutate.capped({parameter["name"]: value}, CAPS)[parameter["name"]])

    def body(self, rng, path, operation):
        content = resolved(operation.get("requestBody", {})).get("content", {})
        if "application/octet-stream" in content:
            seeds = self.files.get(path.rsplit("/", 1)[1], bodies.PICTURES)
            seed = rng.choice(seeds)
            return (seed if rng.random() < 0.3 else mutate.damaged(rng, seed)), "application/octet-stream"
        if "application/json" not in content:
            return None, None
        known = [one for name in names_of(content["application/json"]["schema"]) for one in self.documents[name]]
        document = mutate.capped(rng.choice(known) if known else {}, CAPS)
        if rng.random() < 0.75:
            document = mutate.capped(mutate.mutated(rng, document), CAPS)
        text = mutate.as_text(document)
        return (text if rng.random() < 0.9 else mutate.damaged(rng, text)), "application/json"

    def address(self, rng, path, operation, scene):
        values = {"id": scene if rng.random() < 0.97 else rng.choice(["", "nobody", "%00", "../x", "a" * 5000])}
        query, headers = [], {}
        for parameter in operation["parameters"]:
            parameter = resolved(parameter)
            made = self.parameter(rng, parameter)
            if parameter["in"] == "path" and parameter["name"] != "id":
                values[parameter["name"]] = (made and made[1]) or "x"  # an empty one would be another URL
            elif made and parameter["in"] == "query":
                query.append(made)
            elif made and parameter["in"] == "header":
                headers[parameter["name"]] = made[1].encode("ascii", "replace").decode().replace("\r", " ").replace("\n", " ")[:2000]
        for name, value in values.items():
            path = path.replace("{" + name + "}", urllib.parse.quote(value.encode("utf-8", "surrogatepass"), safe="%./"))
        return path + ("?" + urllib.parse.urlencode([(name, value.encode("utf-8", "surrogatepass")) for name, value in query]) if query else ""), headers

    def send(self, rng, method, path, operation, scene):
        body, kind = self.body(rng, path, operation)
        address, headers = self.address(rng, path, operation, scene)
        if kind:
            headers["Content-Type"] = kind
        if path.endswith("/events"):
            headers.pop("Last-Event-ID", None)
            return self.hear(address, headers)
        began = time.monotonic()
        answer = self.server.call(method.upper(), address.replace("\\", ""), body, headers=headers, timeout=60)
        self.judge(method, path, address, body, operation, answer, time.monotonic() - began)

    def hear(self, address, headers):
        """Reads the beginning of the stream, then hangs up."""
        lines = "".join(f"{name}: {value}\r\n" for name, value in headers.items())
        self.server.raw(f"GET {address} HTTP/1.1\r\nHost: localhost\r\n{lines}Connection: close\r\n\r\n".encode("utf-8", "surrogatepass"), timeout=0.2)

    def judge(self, method, path, address, body, operation, answer, seconds):
        said, seconds = None, seconds - len(answer.body) / BYTES_A_SECOND
        if answer.status >= 500 and answer.status not in BUSY:
            said = f"{answer!r}"
        elif seconds > MAX_SECONDS:
            said = f"{answer.status} after {seconds:.1f} s"
        elif answer.status >= 400 and answer.headers.get("content-type") != "application/problem+json":
            said = f"{answer.status} without a problem document: {answer!r}"
        elif answer.status < 400 and str(answer.status) not in operation["responses"]:
            said = f"{answer.status} is not described"
        with self.lock:
            self.statuses[answer.status] += 1
            self.slowest = max(self.slowest, (seconds, f"{method} {path}"))
            if said:
                self.faults.append(f"{method} {address[:300]}\n    {body[:600] if body else body!r}\n    {said}")
                print(self.faults[-1], flush=True)

    def work(self, number, ends):
        rng, all_operations = random.Random(f"{self.seed} {number}"), operations()
        while not ends():
            scene = self.server.new_scene(rng.choice(["sphere", "plane", "torus"]), 300).id
            for _ in range(ROUND):
                method, path, operation = min(rng.sample(all_operations, 3), key=lambda one: self.counts[one[0], one[1]])
                with self.lock:
                    self.counts[method, path] += 1
                try:
                    self.send(rng, method, path, operation, scene)
                except (OSError, ValueError) as error:
                    if self.server.process.poll() is not None:
                        raise
                    with self.lock:
                        self.statuses[type(error).__name__] += 1
                if method == "delete" and self.server.get(f"/v1/scenes/{scene}").status == 404:
                    break
            self.remove_all_but_others(number, scene)

    def remove_all_but_others(self, number, scene):
        """Removes what this client made by opening, branching and creating when the server fills up."""
        self.server.call("DELETE", f"/v1/scenes/{scene}")
        if number == 0:
            listed = self.server.get("/v1/scenes").json["scenes"]
            for one in listed[:-CLIENTS] if len(listed) > 40 else []:
                self.server.call("DELETE", f"/v1/scenes/{one['id']}")


def main():
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 3600
    wanted = int(sys.argv[2]) if len(sys.argv) > 2 else 5000
    server = Server()
    began = time.monotonic()
    try:
        fuzzer = Fuzzer(server, int(sys.argv[3]) if len(sys.argv) > 3 else 1)
        named = [(method, path) for method, path, _ in operations()]

        def ends():
            gone = time.monotonic() - began
            return server.process.poll() is not None or gone > 4 * seconds or (gone > seconds and min(fuzzer.counts[one] for one in named) >= wanted)

        threads = [threading.Thread(target=fuzzer.work, args=(number, ends)) for number in range(CLIENTS)]
        for thread in threads:
            thread.start()
        while any(thread.is_alive() for thread in threads):
            time.sleep(30)
            print(f"{time.monotonic() - began:.0f} s: {sum(fuzzer.counts.values())} requests, at least {min(fuzzer.counts[one] for one in named)} of each "
                  f"operation, {len(fuzzer.faults)} faults, slowest {fuzzer.slowest[0]:.1f} s ({fuzzer.slowest[1]})", flush=True)
        print(dict(sorted(fuzzer.statuses.items(), key=str)))
        if server.process.poll() is not None:
            fuzzer.faults.append("the server is gone")
            print(f"the server is gone: {server.printed()[-2000:]}")
        return 1 if fuzzer.faults else 0
    finally:
        server.close()


if __name__ == "__main__":
    sys.exit(main())
