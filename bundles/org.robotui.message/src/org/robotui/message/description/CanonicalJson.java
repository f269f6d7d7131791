package org.robotui.message.description;

import java.util.Comparator;
import java.util.List;
import java.util.function.BiConsumer;

/** The one text of a description that its sum is taken of: ASCII, a blank after each comma and colon, no defaults. */
final class CanonicalJson {

  private final StringBuilder out = new StringBuilder();

  private CanonicalJson() {}

  static String of(TypeDescription description) {
    CanonicalJson json = new CanonicalJson();
    json.out.append("{\"type_description\": ");
    json.struct(description.main());
    json.out.append(", \"referenced_type_descriptions\": ");
    json.list(description.referenced().stream().sorted(Comparator.comparing(StructDescription::typeName)).toList(),
        CanonicalJson::struct);
    return json.out.append('}').toString();
  }

  private void struct(StructDescription type) {
    out.append("{\"type_name\": ");
    text(type.typeName());
    out.append(", \"fields\": ");
    list(type.fields(), CanonicalJson::field);
    out.append('}');
  }

  private void field(FieldDescription field) {
    out.append("{\"name\": ");
    text(field.name());
    out.append(", \"type\": {\"type_id\": ").append(field.typeId());
    out.append(", \"capacity\": ").append(Long.toUnsignedString(field.capacity()));
    out.append(", \"string_capacity\": ").append(Long.toUnsignedString(field.stringCapacity()));
    out.append(", \"nested_type_name\": ");
    text(field.nestedTypeName());
    out.append("}}");
  }

  private <T> void list(List<T> values, BiConsumer<CanonicalJson, T> each) {
    out.append('[');
    for (int i = 0; i < values.size(); i++) {
      out.append(i == 0 ? "" : ", ");
      each.accept(this, values.get(i));
    }
    out.append(']');
  }

  private void text(String value) {
    out.append('"');
    for (int i = 0; i < value.length(); i++) {
      char c = value.charAt(i);
      if (c == '"' || c == '\\') {
        out.append('\\').append(c);
      } else if (c < ' ' || c > '~') {
        out.append(String.format("\\u%04x", (int) c));
      } else {
        out.append(c);
      }
    }
    out.append('"');
  }
}
