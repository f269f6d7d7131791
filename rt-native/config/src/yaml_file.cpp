#include "robotui/rt/config/reader.h"

#include "text_file.h"

namespace robotui::rt::config {
namespace {

// The parser of YAML recurses with every bracket: refuse what no person writes before it is parsed.
void mustBeShallow(const std::string& text, const std::filesystem::path& file) {
  constexpr int kDeepest = 100;
  int depth = 0;
  int line = 1;
  for (const char c : text) {
    if (c == '\n') ++line;
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (depth > kDeepest) throw ConfigError({file, line, 0}, "brackets are nested more than 100 deep");
  }
}

}  // namespace

Reader readYamlFile(const std::filesystem::path& file, const Place& wanted, const std::string& what) {
  const std::string text = readTextFile(file, wanted, what, kLargestYaml);
  mustBeShallow(text, file);
  try {
    Reader top(YAML::Load(text), file, {}, {file, 0, 0});
    if (!top.node().IsMap()) top.fail("is not YAML of the form `key: value`; expected a map at the top");
    return top;
  } catch (const YAML::Exception& error) {
    throw ConfigError({file, error.mark.line + 1, error.mark.column + 1}, "is not YAML: " + error.msg);
  }
}

}  // namespace robotui::rt::config
