// Tables and the frame of a page, as well-formed XML that browsers read as HTML.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/base/status.h"

namespace pelage::trade {

struct Table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;  // plain text
};

std::string table_html(const Table& table);

/// A heading with what follows it.
std::string section(const std::string& title, const std::string& content);

/// The whole page with its style; nothing in it comes from elsewhere.
std::string document(const std::string& title, const std::string& content);

}  // namespace pelage::trade

// What the report is made of: one measured frame, and the table of them as CSV.

namespace pelage::trade {

/// A setting of the knobs on a scene, measured against a reference. FLIP is in [0, 1], over the fur.
struct Row {
  std::string scene;      // "creature, white coat, lit from the front, near"
  int size = 0;           // pixels of a side
  std::string series;     // what is swept: "tier", "grid" or a knob; around `base`
  std::string base;       // the tier that the other knobs are of; "" in a grid
  std::string value;      // of what is swept: "16", "full", "draft"
  std::string reference;  // "R1", with its shadows where they are not the estimate, or "R2"
  int truth = 0;          // shells of R1, or passes of R2
  int shells = 0, steps = 0;
  double scale = 1;
  double flip = 0, flip_95 = 0;              // mean and 95th percentile
  double silhouette = 0, silhouette_95 = 0;  // the same in the band around the fur's edge; 0 where there is no edge
  double luminance = 0,
         coverage = 0;         // mean linear luminance of the fur, and pixels that it covers, over the reference's
  double floor = 0;            // FLIP that the reference itself may be off
  std::size_t non_finite = 0;  // pixels with NaN or infinity
  double draw_ms = 0;          // least of the repeats
  double cpu_ms = 0;           // all threads, least of the repeats; 0 where the server does not say
  std::string knobs;           // JSON, as a request's `quality`

  bool operator==(const Row&) const = default;
};

/// CSV (RFC 4180) with a line of names; reads back to the same rows.
std::string to_csv(const std::vector<Row>& rows);

/// Refused (malformed) when the first line has other names or a line has a bad field; the message names the line.
Result<std::vector<Row>> from_csv(std::string_view text);

}  // namespace pelage::trade
