#include <fmt/format.h>

#include "protocol/openapi/openapi.h"
#include "server/http/reply.h"
#include "server/http/routes.h"

namespace pelage {

namespace {

using httplib::Request;
using httplib::Response;

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text) {
    if (c == '<')
      html += "&lt;";
    else if (c == '>')
      html += "&gt;";
    else if (c == '&')
      html += "&amp;";
    else if (c == '"')
      html += "&quot;";
    else
      html += c;
  }
  return html;
}

std::string page_of(const std::vector<SceneSummary>& scenes, const std::string& gl) {
  std::string rows;
  for (const SceneSummary& scene : scenes) {
    rows += fmt::format(
        "<tr><td><a href=\"/v1/scenes/{0}/frame.png\">{1}</a></td><td>{2}</td><td>{3}</td><td>{4}</td></tr>\n",
        scene.id, escaped(scene.name), escaped(scene.model), scene.report.triangles, scene.revision);
  }
  if (rows.empty()) rows = "<tr><td colspan=\"4\">none yet: <code>pelage new</code> makes one</td></tr>\n";
  return fmt::format(R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Pelage</title>
<style>body{{font:16px sans-serif;max-width:44em;margin:3em auto}}td,th{{padding:.2em 1em .2em 0;text-align:left}}</style>
</head><body>
<h1>Pelage</h1>
<p>A fur grooming render server: commands as JSON over HTTP, pictures back.
<a href="/openapi.json">openapi.json</a> says all that can be said to it; <a href="/metrics">metrics</a> how it fares.</p>
<h2>Scenes</h2>
<table><tr><th>picture</th><th>model</th><th>triangles</th><th>revision</th></tr>
{}</table>
<p>Drawing with {}.</p>
</body></html>
)",
                     rows, escaped(gl));
}

void ready(const Service& service, Response& response) {
  if (service.ready()) return response.set_content("ready\n", "text/plain");
  reply_problem(response,
                failure(Code::unavailable, service.draining ? "The server is stopping." : "Drawing does not work."));
}

}  // namespace

void add_status_routes(httplib::Server& server, Service& service) {
  server.Get("/livez", [](const Request&, Response& response) { response.set_content("alive\n", "text/plain"); });
  server.Get("/readyz", [&](const Request&, Response& response) { ready(service, response); });
  server.Get("/metrics", [&](const Request&, Response& response) {
    const Gauges gauges{.scenes = service.scenes.list().size(),
                        .ready = service.ready(),
                        .frames_drawn = service.frames.frames_drawn(),
                        .seconds_drawing = service.frames.seconds_drawing(),
                        .traces = service.traces.counts(),
                        .renderer = service.frames.description()};
    response.set_content(service.metrics.text(gauges), "text/plain; version=0.0.4");
  });
  server.Get("/openapi.json",
             [](const Request&, Response& response) { reply_json(response, 200, std::string(openapi_json())); });
  server.Get("/", [&](const Request&, Response& response) {
    response.set_header("Content-Security-Policy", "default-src 'none'; style-src 'unsafe-inline'");
    response.set_content(page_of(service.scenes.list(), service.frames.description()), "text/html; charset=utf-8");
  });
}

}  // namespace pelage
