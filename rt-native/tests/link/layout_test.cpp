#include <gtest/gtest.h>

#include "robotui/rt/link/layout.h"
#include "schema.h"
#include "written_file.h"

namespace robotui::rt::link {
namespace {

TEST(Layout, is_what_the_schema_says) { expectWritten(LAYOUT_FILE, schemaText()); }

// A field left out of the schema would leave a hole as large as itself; what is called padding is at most that.
TEST(Layout, no_field_is_missing_from_the_schema) {
  for (const SchemaStruct& each : schema()) {
    std::size_t end = 0;
    for (const SchemaField& field : each.fields) {
      EXPECT_LE(field.offset - end, 4U) << each.name << '.' << field.name;
      end = field.offset + field.count * field.size;
    }
    EXPECT_LE(each.size - end, 5U) << each.name;
  }
}

// Both words of the sequence lock's copy and Java's views need it.
TEST(Layout, all_is_aligned_to_words) {
  for (const SchemaStruct& each : schema()) {
    EXPECT_EQ(each.size % 8, 0U) << each.name;
    for (const SchemaField& field : each.fields) {
      const std::size_t alignment =
          field.size < 8 ? field.size : (field.type == "Name" || field.type == "Text" ? 1 : 8);
      EXPECT_EQ(field.offset % alignment, 0U) << each.name << '.' << field.name;
    }
  }
}

}  // namespace
}  // namespace robotui::rt::link
