"""Exported scenes that somebody else wrote: data, whatever they say."""

import gzip
import random
import sqlite3
import tempfile
import threading
import time
import unittest
from pathlib import Path

from support.server import Scene, ServedTest

GENERATED = """
    ALTER TABLE entries RENAME TO before;
    CREATE TABLE entries(
      scene TEXT NOT NULL, revision INTEGER NOT NULL, kind INTEGER NOT NULL, argument INTEGER NOT NULL,
      commands TEXT NOT NULL, settings TEXT, hash_low INTEGER NOT NULL, hash_high INTEGER NOT NULL,
      delta BLOB AS (zeroblob(100000000)), author TEXT NOT NULL DEFAULT '', request_key TEXT NOT NULL DEFAULT '');
    INSERT INTO entries(scene, revision, kind, argument, commands, hash_low, hash_high)
      SELECT scene, revision, kind, argument, commands, hash_low, hash_high FROM before;
    DROP TABLE before"""
OTHER_TABLES = {
    "one more column": "ALTER TABLE pictures ADD COLUMN more BLOB AS (zeroblob(100000000))",
    "a trigger": "CREATE TRIGGER more AFTER INSERT ON scenes BEGIN DELETE FROM entries; END",
    "a view": "DROP TABLE picture_uses; CREATE VIEW picture_uses AS SELECT id AS scene, id AS picture FROM scenes",
    "one more table": "CREATE TABLE more(number INTEGER)",
    "one more index": "CREATE INDEX more ON entries(kind)",
    "a table less": "DROP TABLE picture_uses",
    "no version": "PRAGMA user_version = 0",
    "an old version": "PRAGMA user_version = 7",
    "a version to come": "PRAGMA user_version = 1000",
}
OTHER_CELLS = {
    "a text for a number": "UPDATE entries SET kind = 'comb'",
    "a number for a text": "UPDATE entries SET commands = CAST('[]' AS BLOB)",
    "a fraction for a number": "UPDATE scenes SET first_revision = 0.5",
    "a text for bytes": "UPDATE scenes SET raw = 'raw'",
    "no scene": "DELETE FROM scenes",
    "a model of another kind": "UPDATE scenes SET model = 'no such model'",
    "an entry less": "DELETE FROM entries WHERE revision = 2",
    "a revision beyond all": "UPDATE entries SET revision = revision + 4611686018427387904",
    "commands that are none": "UPDATE entries SET commands = '[{\"op\": \"no such op\"}]'",
    "bytes that are no change": "UPDATE entries SET delta = zeroblob(1000)",
    "bytes that are no model": "UPDATE scenes SET raw = zeroblob(10000000)",
    "an axis that is none": "UPDATE scenes SET up = 77",
}

VERSION_8 = """
  CREATE TABLE scenes(
    number INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE, name TEXT NOT NULL,
    model TEXT NOT NULL, up INTEGER NOT NULL, front INTEGER NOT NULL, source_is_32_bit INTEGER NOT NULL,
    first_revision INTEGER NOT NULL, first_groom BLOB NOT NULL, raw BLOB NOT NULL, fur_patches INTEGER NOT NULL,
    subdivisions BLOB NOT NULL, settings TEXT, creases_and_flips TEXT NOT NULL DEFAULT '');
  CREATE TABLE entries(
    scene TEXT NOT NULL REFERENCES scenes(id) ON DELETE CASCADE, revision INTEGER NOT NULL,
    kind INTEGER NOT NULL, argument INTEGER NOT NULL, commands TEXT NOT NULL, settings TEXT,
    hash_low INTEGER NOT NULL, hash_high INTEGER NOT NULL, delta BLOB NOT NULL, author TEXT NOT NULL DEFAULT '',
    request_key TEXT NOT NULL DEFAULT '', PRIMARY KEY(scene, revision));
  CREATE INDEX entries_by_request ON entries(scene, request_key) WHERE request_key <> '';
  CREATE TABLE pictures(name TEXT PRIMARY KEY, bytes BLOB NOT NULL);
  CREATE TABLE picture_uses(
    scene TEXT NOT NULL REFERENCES scenes(id) ON DELETE CASCADE, picture TEXT NOT NULL REFERENCES pictures(name),
    PRIMARY KEY(scene, picture));
  PRAGMA user_version = 8;
  INSERT INTO scenes SELECT number, id, name, model, up, front, source_is_32_bit, first_revision, first_groom, raw, fur_patches,
    subdivisions, settings, creases_and_flips FROM now.scenes;
  INSERT INTO entries SELECT scene, revision, kind, argument, commands, settings, hash_low, hash_high, delta, author, 'key'
    FROM now.entries;
"""


class SavedFiles(ServedTest):
    def setUp(self):
        scene = self.server.new_scene("sphere", 500, fur={"length": 0.05})
        for op in ("noise", "smooth", "noise"):
            self.assertEqual(scene.run({"op": op, "flood": True, **({"amount": 0.3} if op == "noise" else {})}).status, 200)
        self.content = self.server.get(f"{scene.path}/export/pelage").body
        self.hash = scene.info()["fields_hash"]
        self.assertEqual(self.server.call("DELETE", scene.path).status, 204)

    def open(self, content):
        return self.server.call("POST", "/v1/open", content, headers={"Content-Type": "application/octet-stream"})

    def version_8(self):
        """The file as the first version that exported any wrote it: its rows have no checksums, so that others find what is wrong."""
        with tempfile.TemporaryDirectory() as folder:
            now, old = Path(folder, "now"), Path(folder, "old")
            now.write_bytes(gzip.decompress(self.content))
            database = sqlite3.connect(old)
            database.execute("ATTACH ? AS now", (str(now),))
            database.executescript(VERSION_8)
            database.close()
            return old.read_bytes()

    def changed(self, plain, statements):
        """The file after SQL statements."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "scene")
            path.write_bytes(plain)
            database = sqlite3.connect(path)
            database.executescript(statements)
            database.close()
            return gzip.compress(path.read_bytes(), 1)

    def assert_refused(self, content):
        stored, scenes = self.stored_bytes(), self.server.get("/v1/scenes").json["scenes"]
        answer = self.open(content)
        self.assertEqual(answer.status, 422, answer)
        self.assertIn("exported as pelage", answer.json["limit"])
        self.assertEqual(self.server.get("/v1/scenes").json["scenes"], scenes)
        self.assertLess(self.stored_bytes() - stored, 1 << 20, "nothing of a refused file is stored")
        return answer

    def stored_bytes(self):
        return sum(file.stat().st_size for file in self.server.data.iterdir())

    def test_tables_are_those_of_a_scene_word_for_word(self):
        for version in (gzip.decompress(self.content), self.version_8()):
            for name, statements in OTHER_TABLES.items():
                with self.subTest(name):
                    self.assert_refused(self.changed(version, statements))
        self.assert_refused(self.changed(self.version_8(), GENERATED))

    def test_rows_are_checked_before_they_are_stored(self):
        plain = self.version_8()
        for name, statements in OTHER_CELLS.items():
            with self.subTest(name):
                self.assert_refused(self.changed(plain, statements))

    def test_files_of_the_first_version_open(self):
        answer = self.open(gzip.compress(self.version_8(), 1))
        self.assertEqual(answer.status, 201, answer)
        scene = Scene(self.server, answer.json["id"])
        self.assertEqual((scene.info()["fields_hash"], scene.info()["undo_steps"]), (self.hash, 3))
        self.assertEqual(self.server.call("DELETE", scene.path).status, 204)

    def test_rows_that_share_their_pages_are_refused(self):
        """Two tables that begin at one page read it twice: much of little."""
        self.assert_refused(self.changed(gzip.decompress(self.content), """
            PRAGMA writable_schema = 1;
            UPDATE sqlite_master SET rootpage = (SELECT rootpage FROM sqlite_master WHERE name = 'scenes') WHERE name = 'pictures'"""))

    def test_flipped_bits_make_a_whole_scene_or_none(self):
        rng = random.Random(7)
        versions = gzip.decompress(self.content), self.version_8()
        for _ in range(30):
            bytes_now = bytearray(rng.choice(versions))
            for _ in range(rng.choice((1, 1, 4, 64))):
                bytes_now[rng.randrange(len(bytes_now))] ^= 1 << rng.randrange(8)
            answer = self.open(gzip.compress(bytes(bytes_now), 1))
            self.assertIn(answer.status, (201, 422), answer)
            if answer.status == 201:
                scene = Scene(self.server, answer.json["id"])
                self.assertEqual(scene.info()["fields_hash"], self.hash)
                self.assertEqual(self.server.call("DELETE", scene.path).status, 204)
        self.assertEqual(self.server.terminate(), 0)
        self.server.start()
        self.assertEqual(self.server.get("/v1/scenes").json["scenes"], [])
        self.assertEqual(self.open(self.content).status, 201)
        for scene in self.server.get("/v1/scenes").json["scenes"]:
            self.server.call("DELETE", f"/v1/scenes/{scene['id']}")

    def test_killed_meanwhile_it_starts_again(self):
        """At any moment of the opening; what is there afterwards is the whole scene or nothing of it."""
        server = self.server
        large = server.new_scene("sphere", 2000, fur={"length": 0.05})
        for _ in range(300):
            self.assertEqual(large.run({"op": "noise", "flood": True, "amount": 0.3}).status, 200)
        content, wanted = server.get(f"{large.path}/export/pelage").body, large.info()
        began = time.monotonic()
        self.assertEqual(self.open(content).status, 201)
        lasts = time.monotonic() - began
        for share in (0.4, 0.7, 1.0):
            def post():
                try:
                    self.open(content)
                except OSError:
                    pass  # the server is gone
            opening = threading.Thread(target=post)
            opening.start()
            time.sleep(lasts * share)
            server.kill()
            opening.join()
            server.start()
            for scene in server.get("/v1/scenes").json["scenes"]:
                self.assertEqual((scene["revision"], scene["fields_hash"]), (wanted["revision"], wanted["fields_hash"]))
        server.remove_scenes()


if __name__ == "__main__":
    unittest.main()
