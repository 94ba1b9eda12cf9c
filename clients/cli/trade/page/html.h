// Tables and the frame of a page, as well-formed XML that browsers read as HTML.
#pragma once

#include <string>
#include <vector>

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
