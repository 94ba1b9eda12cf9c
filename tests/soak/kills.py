"""Kills the server again and again while clients groom, undo, upload, branch, export, open and remove. Checks after each start that
everything acknowledged is there, that nothing removed is, and that there is no scene that nobody made.

usage: PELAGE_BIN=build/tests/bin python3 tests/soak/kills.py [KILLS] [SEED]

Exits with 1 if anything was lost.
"""
import http.client
import random
import sys
import threading
import time

import bodies
from support.server import Server, comb

CLIENTS = 4
MAX_SCENES = 6   # per client
UP_SECONDS = (0.3, 2.0)  # range of the time from a start to the kill


class Groomer:
    """A client with the last acknowledged state of each scene. It does not know the answer of the request that was in flight at the
    kill."""

    def __init__(self, server, number, seed, saved):
        self.server, self.random, self.saved = server, random.Random(f"{seed} {number}"), saved
        self.scenes, self.removed = {}, set()  # id -> (revision, fields_hash)
        self.in_doubt = None                   # id of the scene with a change that was not answered
        self.making = False                    # True if a request that makes a scene was not answered
        self.answers, self.failures = 0, []

    def request(self, method, path, body=None, **more):
        answer = self.server.call(method, path, body, timeout=60, **more)
        if answer.status >= 500 and answer.status != 503:
            raise AssertionError(f"{method} {path}: {answer}")
        self.answers += answer.status < 400
        return answer

    def make(self, answer):
        if answer.status == 201:
            description = self.request("GET", f"/v1/scenes/{answer.json['id']}").json
            self.scenes[description["id"]] = (description["revision"], description["fields_hash"])

    def new(self):
        self.making = True
        self.make(self.request("POST", "/v1/scenes", {"name": "killed", "model": {"builtin": "sphere", "triangles": 400}}))
        self.making = False

    def open_saved(self):
        self.making = True
        self.make(self.request("POST", "/v1/open", self.saved, headers={"Content-Type": "application/octet-stream"}))
        self.making = False

    def branch(self, scene):
        self.making = True
        self.make(self.request("POST", f"/v1/scenes/{scene}/branch", {"name": "branch"}))
        self.making = False

    def change(self, scene, method, path, body, **more):
        self.in_doubt = scene
        answer = self.request(method, f"/v1/scenes/{scene}/{path}", body, **more)
        if answer.status == 200:
            state = answer.json
            self.scenes[scene] = (state["revision"], state["fields_hash"])
        self.in_doubt = None

    def groom(self, scene):
        end = [self.random.uniform(-1, 1) for _ in range(3)]
        self.change(scene, "POST", "commands", comb([0, 0, 1], end, radius=0.3))

    def undo(self, scene):
        self.change(scene, "POST", self.random.choice(["undo", "redo"]), {"steps": 1})

    def upload(self, scene):
        name = self.random.choice(list(bodies.MODELS))
        self.change(scene, "PUT", f"model?format={name}", bodies.MODELS[name], headers={"Content-Type": "application/octet-stream"})

    def skin(self, scene):
        self.change(scene, "PUT", "skin_texture", bodies.PICTURES[0], headers={"Content-Type": "application/octet-stream"})

    def export(self, scene):
        self.request("GET", f"/v1/scenes/{scene}/export/{self.random.choice(['pelage', 'usda', 'shells'])}")

    def remove(self, scene):
        self.in_doubt = scene
        if self.request("DELETE", f"/v1/scenes/{scene}").status == 204:
            del self.scenes[scene]
            self.removed.add(scene)
        self.in_doubt = None

    def step(self):
        work = self.random.choices(["new", "open_saved", "branch", "groom", "undo", "upload", "skin", "export", "remove"],
                                   [2, 3, 2, 12, 4, 4, 2, 4, 2])[0]
        if len(self.scenes) >= MAX_SCENES and work in ("new", "open_saved", "branch"):
            work = "remove"
        if work in ("new", "open_saved") or not self.scenes:
            return self.open_saved() if work == "open_saved" else self.new()
        getattr(self, work)(self.random.choice(list(self.scenes)))

    def run(self):
        try:
            while True:
                self.step()
        except (OSError, http.client.HTTPException):
            pass  # killed
        except AssertionError as failure:
            self.failures.append(str(failure))

    def check(self, listed):
        """Returns the faults found after a start. Takes over the server's state for what was in doubt."""
        faults, self.failures = self.failures, []
        for scene, (revision, fields_hash) in list(self.scenes.items()):
            now = listed.get(scene)
            if scene == self.in_doubt:
                self.scenes.pop(scene)
                if now:
                    self.scenes[scene] = (now["revision"], now["fields_hash"])
            elif not now:
                faults.append(f"{scene} is gone at revision {revision}")
            elif (now["revision"], now["fields_hash"]) != (revision, fields_hash):
                faults.append(f"{scene} was at {revision}, is at {now['revision']}")
        faults += [f"{scene} was removed and is there" for scene in self.removed & set(listed)]
        return faults


def check_all(server, groomers):
    answer = server.get("/v1/scenes")
    listed = {scene["id"]: scene for scene in answer.json["scenes"]}
    faults = [fault for groomer in groomers for fault in groomer.check(listed)]
    known = {scene for groomer in groomers for scene in groomer.scenes}
    strangers = set(listed) - known
    if len(strangers) > sum(groomer.making for groomer in groomers):
        faults.append(f"nobody made {strangers}")
    for scene in listed:  # each scene must be usable
        for path in (f"/v1/scenes/{scene}", f"/v1/scenes/{scene}/log", f"/v1/scenes/{scene}/frame.png?width=16&height=16"):
            if (status := server.get(path).status) != 200:
                faults.append(f"{path}: {status}")
    for scene in strangers:  # their answers were cut off by the kill
        server.call("DELETE", f"/v1/scenes/{scene}")
    for groomer in groomers:
        groomer.in_doubt, groomer.making = None, False
    return faults


def main():
    kills = int(sys.argv[1]) if len(sys.argv) > 1 else 300
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    server = Server()
    rng, faults, began = random.Random(seed), [], time.monotonic()
    try:
        saved = bodies.exported(server)[1]
        groomers = [Groomer(server, number, seed, saved) for number in range(CLIENTS)]
        for kill in range(1, kills + 1):
            threads = [threading.Thread(target=groomer.run) for groomer in groomers]
            for thread in threads:
                thread.start()
            time.sleep(rng.uniform(*UP_SECONDS))
            server.kill()
            for thread in threads:
                thread.join()
            server.start()
            found = check_all(server, groomers)
            faults += [f"kill {kill}: {fault}" for fault in found]
            if found or kill % 10 == 0 or kill == kills:
                answers = sum(groomer.answers for groomer in groomers)
                print(f"{kill} kills, {answers} answers, {time.monotonic() - began:.0f} s, {len(faults)} faults", flush=True)
            for fault in found:
                print(f"  {fault}", flush=True)
    finally:
        server.close()
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
