// The layout as this compiler sees it, for the comparison with link/layout.txt that other languages read.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace robotui::rt::link {

struct SchemaField {
  std::string name;
  std::string type;  // u8 ... f64, char, or the name of a struct
  std::size_t offset;
  std::size_t count;
  std::size_t size;  // of one
};

struct SchemaStruct {
  std::string name;
  std::size_t size;
  std::vector<SchemaField> fields;
};

const std::vector<SchemaStruct>& schema();

// The content of layout.txt.
std::string schemaText();

// One line a number that is not zero and a text that is not empty, as `joints[0].effort 2.5`, of the bytes of a struct.
std::string describeBytes(std::string_view type, const void* bytes);

}  // namespace robotui::rt::link
