#include "xml_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace robotui::rt::config {
namespace {

// Entities can make a small file huge when another parser reads it again: nothing that describes a robot needs them.
void mustHaveNoEntities(const std::filesystem::path& file, const std::string& text) {
  const auto at = std::min(text.find("<!DOCTYPE"), text.find("<!ENTITY"));
  if (at == std::string::npos) return;
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  throw ConfigError({file, static_cast<int>(line), 0},
                    "has a document type or entities of its own, which are not read; remove them");
}

}  // namespace

XmlFile::XmlFile(std::filesystem::path file, const std::string& text) : file_(std::move(file)) {
  mustHaveNoEntities(file_, text);
  if (document_.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    throw ConfigError({file_, document_.ErrorLineNum(), 0}, std::string("is not XML: ") + document_.ErrorName());
  }
  const Element* root = document_.RootElement();
  if (root == nullptr || std::string_view(root->Name()) != "robot") {
    throw ConfigError({file_, root == nullptr ? 0 : root->GetLineNum(), 0},
                      "does not describe a robot; expected <robot name=\"...\"> at the top");
  }
}

Place XmlFile::place(const Element& element) const { return {file_, element.GetLineNum(), 0}; }

void XmlFile::fail(const Element& element, const std::string& what) const {
  const char* name = element.Attribute("name");
  const std::string of = name == nullptr ? "" : " '" + std::string(name).substr(0, 100) + "'";
  throw ConfigError(place(element), "<" + std::string(element.Name()) + ">" + of + " " + what);
}

std::string XmlFile::attribute(const Element& element, const char* name) const {
  const char* value = element.Attribute(name);
  if (value == nullptr || *value == '\0') fail(element, "has no " + std::string(name) + "; write " + name + "=\"...\"");
  return value;
}

double XmlFile::number(const Element& element, const char* name) const {
  const std::string text = attribute(element, name);
  const auto first = text.find_first_not_of(" \t\n+");
  const auto last = text.find_last_not_of(" \t\n");
  double value = 0;
  if (first != std::string::npos) {
    const auto [end, error] = std::from_chars(text.data() + first, text.data() + last + 1, value);
    if (error == std::errc{} && end == text.data() + last + 1 && std::isfinite(value)) return value;
  }
  fail(element, "has " + std::string(name) + "=\"" + text.substr(0, 60) + "\"; expected a number");
}

double XmlFile::numberOr(const Element& element, const char* name, double otherwise) const {
  return element.Attribute(name) == nullptr ? otherwise : number(element, name);
}

std::vector<const Element*> XmlFile::children(const Element& element, const char* name) const {
  std::vector<const Element*> result;
  for (const auto* child = element.FirstChildElement(name); child != nullptr; child = child->NextSiblingElement(name)) {
    result.push_back(child);
  }
  return result;
}

std::optional<const Element*> XmlFile::child(const Element& element, const char* name) const {
  const auto found = children(element, name);
  if (found.size() > 1) fail(*found[1], "is there twice");
  if (found.empty()) return {};
  return found.front();
}

}  // namespace robotui::rt::config
