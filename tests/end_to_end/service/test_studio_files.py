"""The files of the studio at / and /assets, or the page that says that it is not built in."""

import gzip
import re
import subprocess
import unittest

from support.server import Server, ServedTest

SECURITY = {"x-content-type-options": "nosniff", "referrer-policy": "no-referrer", "cross-origin-opener-policy": "same-origin",
            "vary": "Accept-Encoding"}
POLICY = {"default-src 'none'", "script-src 'self'", "style-src 'self'", "img-src 'self' blob: data:", "media-src blob:", "connect-src 'self'",
          "font-src 'self'", "worker-src 'self'", "base-uri 'none'", "form-action 'none'", "frame-ancestors 'none'"}
TYPES = {"js": "text/javascript; charset=utf-8", "css": "text/css; charset=utf-8", "svg": "image/svg+xml", "png": "image/png",
         "jpg": "image/jpeg", "json": "application/json"}


def assets_in(text):
    return set(re.findall(r'["\'(`](?:/assets/|\./)([A-Za-z0-9_.-]+\.(?:js|css|svg|png|jpg|json))["\')`]', text))


class StudioFiles(ServedTest):
    def all_paths(self):
        """The contract, the page, and every asset that it or another asset names."""
        found, waiting = {"/", "/openapi.json"}, ["/"]
        while waiting:
            body = self.server.get(waiting.pop()).body.decode("utf-8", errors="replace")
            new = {f"/assets/{name}" for name in assets_in(body)} - found
            found |= new
            waiting += new
        self.assertGreater(len(found), 2)
        return sorted(found)

    def accepted(self, path, encodings):
        answer = self.server.get(path, headers={"Accept-Encoding": encodings})
        self.assertEqual(answer.status, 200, (path, answer))
        return answer

    def decoded(self, path, encodings):
        """As curl, which knows brotli, decodes it."""
        run = subprocess.run(["curl", "--silent", "--fail", "--compressed", "-H", f"Accept-Encoding: {encodings}", self.server.address + path],
                             capture_output=True, timeout=60)
        self.assertEqual(run.returncode, 0, (path, run.stderr))
        return run.stdout

    def test_the_page(self):
        for path in ("/", "/?scene=fox"):
            page = self.server.get(path)
            self.assertEqual((page.status, page.headers["content-type"]), (200, "text/html; charset=utf-8"))
            self.assertEqual(page.headers["cache-control"], "no-cache")
            self.assertIn(b"<!doctype html>", page.body)

    def test_answers_that_are_made_when_asked_are_compressed_by_gzip_alone(self):
        """cpp-httplib's brotli takes forty times as long."""
        for encodings, used in (("gzip, deflate, br", "gzip"), ("br", None), ("gzip;q=0, br", None), ("identity", None)):
            self.assertEqual(self.accepted("/v1/scenes", encodings).headers.get("content-encoding"), used, encodings)

    def test_headers_keep_other_sites_out(self):
        for path in self.all_paths():
            answer = self.server.get(path)
            for name, value in SECURITY.items():
                self.assertEqual(answer.headers.get(name), value, (path, name))
            self.assertEqual(set(answer.headers["content-security-policy"].split("; ")), POLICY, path)
            self.assertIn("geolocation=()", answer.headers["permissions-policy"])

    def test_the_page_keeps_to_its_own_policy(self):
        text = self.server.get("/").body.decode()
        self.assertNotRegex(text, r"<script(?![^>]*\bsrc=)|<style|\bstyle=|\son\w+=")

    def test_assets_have_their_type_and_never_change_where_the_name_has_a_hash(self):
        for path in self.all_paths():
            if path == "/":
                continue
            answer = self.server.get(path)
            self.assertEqual(answer.headers["content-type"], TYPES[path.rsplit(".", 1)[1]], path)
            hashed = re.search(r"-[A-Za-z0-9]{8,}\.\w+$", path)
            self.assertEqual(answer.headers["cache-control"], "public, max-age=31536000, immutable" if hashed else "no-cache", path)

    def test_encodings_hold_the_same_bytes(self):
        for path in self.all_paths():
            plain = self.accepted(path, "identity")
            self.assertNotIn("content-encoding", plain.headers)
            self.assertEqual(self.server.get(path).body, plain.body)
            for wanted in ("gzip", "br"):
                answer = self.accepted(path, wanted)
                encoding = answer.headers.get("content-encoding")
                self.assertIn(encoding, (None, wanted))
                self.assertEqual(int(answer.headers["content-length"]), len(answer.body))
                if encoding is None:
                    self.assertEqual((answer.body, answer.headers["etag"]), (plain.body, plain.headers["etag"]))
                    continue
                self.assertLess(len(answer.body), len(plain.body))
                self.assertNotEqual(answer.headers["etag"], plain.headers["etag"])
                self.assertEqual(self.decoded(path, wanted), plain.body)
                if wanted == "gzip":
                    self.assertEqual(gzip.decompress(answer.body), plain.body)

    def test_the_best_encoding(self):
        for path in self.all_paths():
            has = {wanted: "content-encoding" in self.accepted(path, wanted).headers for wanted in ("gzip", "br")}
            for header, order in (("gzip, deflate, br", ("br", "gzip")), ("br;q=0.1, gzip;q=0.9", ("gzip", "br")),
                                  ("br;q=0, gzip", ("gzip",)), ("*;q=0, identity", ())):
                expected = next((one for one in order if has[one]), None)
                self.assertEqual(self.accepted(path, header).headers.get("content-encoding"), expected, (path, header))
            refused = self.server.get(path, headers={"Accept-Encoding": "identity;q=0, *;q=0"})
            self.assert_problem(refused, 406)

    def test_a_client_that_has_it_gets_304(self):
        for path in self.all_paths():
            for encoding in ("identity", "gzip", "br"):
                first = self.accepted(path, encoding)
                tag = first.headers["etag"]
                for known in (tag, f"W/{tag}", f'"other", {tag}', "*"):
                    same = self.server.get(path, headers={"Accept-Encoding": encoding, "If-None-Match": known})
                    self.assertEqual((same.status, same.body), (304, b""), (path, known))
                    for name in ("etag", "cache-control", "vary"):
                        self.assertEqual(same.headers[name], first.headers[name])
                new = self.server.get(path, headers={"Accept-Encoding": encoding, "If-None-Match": '"other"'})
                self.assertEqual((new.status, new.body), (200, first.body))

    def test_head(self):
        for path in self.all_paths():
            full, head = self.accepted(path, "gzip"), self.server.call("HEAD", path, headers={"Accept-Encoding": "gzip"})
            self.assertEqual((head.status, head.body), (200, b""))
            for name in ("content-length", "content-type", "etag", "cache-control"):
                self.assertEqual(head.headers[name], full.headers[name], (path, name))
            self.assertEqual(head.headers.get("content-encoding"), full.headers.get("content-encoding"))

    def test_what_is_not_there(self):
        for path in ("/assets/none.js", "/assets/none-ABCDEFGH.js", "/assets/index.html"):
            answer = self.server.get(path)
            self.assert_problem(answer, 404)
            self.assertEqual(answer.headers["cache-control"], "no-store")
        for path in ("/index.html", "/assets", "/assets/", "/assets/a/b.js", "/assets/..%2findex.html", "/assets/../index.html"):
            self.assert_problem(self.server.get(path), 404)
        self.assert_problem(self.server.post("/", {}), 405)
        self.assert_problem(self.server.call("DELETE", "/assets/none.js"), 405)

    def test_metrics_count_by_route(self):
        self.server.get("/assets/none.js")
        self.assertIn('route="/assets/{name}",status="404"', self.server.get("/metrics").body.decode())


class WithToken(unittest.TestCase):
    def test_the_studio_is_served_and_nothing_else(self):
        server = Server(token="secret")
        self.addCleanup(server.close)
        without = {"Authorization": ""}
        page = server.get("/", headers=without)
        self.assertEqual(page.status, 200)
        for name in assets_in(page.body.decode()):
            self.assertEqual(server.get(f"/assets/{name}", headers=without).status, 200, name)
        for path in ("/v1/scenes", "/openapi.json", "/metrics", "/assets", "/index.html", "//", "/assetsx/a"):
            self.assertEqual(server.get(path, headers=without).status, 401, path)


if __name__ == "__main__":
    unittest.main()
