// XML with places: what URDF and SRDF have in common.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tinyxml2.h>

#include "robotui/rt/config/config.h"

namespace robotui::rt::config {

using Element = tinyxml2::XMLElement;

class XmlFile {
 public:
  // Parses the text of the file. Throws ConfigError where it is no XML, has entities of its own, or another root than
  // <robot>.
  XmlFile(std::filesystem::path file, const std::string& text);

  const Element& root() const noexcept { return *document_.RootElement(); }
  Place place(const Element& element) const;
  [[noreturn]] void fail(const Element& element, const std::string& what) const;

  std::string attribute(const Element& element, const char* name) const;
  double number(const Element& element, const char* name) const;
  double numberOr(const Element& element, const char* name, double otherwise) const;
  std::vector<const Element*> children(const Element& element, const char* name) const;
  // The only child of that name, or nothing.
  std::optional<const Element*> child(const Element& element, const char* name) const;

 private:
  std::filesystem::path file_;
  tinyxml2::XMLDocument document_;
};

}  // namespace robotui::rt::config
