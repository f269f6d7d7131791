package org.robotui.ros2.internal.type;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.RosValue;
import org.robotui.message.description.DescribedType;
import org.robotui.message.description.FieldDescription;
import org.robotui.message.description.StructDescription;
import org.robotui.message.description.TypeDescription;

/** Reads the answer of {@code get_type_description}. */
final class DescribedTypes {

  private static final int MOST_TYPES = 500;
  private static final int MOST_FIELDS = 2000;

  private DescribedTypes() {}

  static DescribedType read(DynamicMessage answer) throws MessageException {
    DynamicMessage description = nested(answer, "type_description");
    List<DynamicMessage> others = messages(description, "referenced_type_descriptions", MOST_TYPES);
    StructDescription main = struct(nested(description, "type_description"));
    List<StructDescription> referenced = new ArrayList<>();
    for (DynamicMessage each : others) {
      referenced.add(struct(each));
    }
    Map<String, String> sources = new HashMap<>();
    for (DynamicMessage each : messages(answer, "type_sources", MOST_TYPES)) {
      if (text(each, "encoding").equals("msg")) {
        sources.put(text(each, "type_name"), text(each, "raw_file_contents"));
      }
    }
    return new DescribedType(new TypeDescription(main, referenced), sources);
  }

  private static StructDescription struct(DynamicMessage type) throws MessageException {
    List<FieldDescription> fields = messages(type, "fields", MOST_FIELDS).stream().map(DescribedTypes::field)
        .toList();
    return new StructDescription(text(type, "type_name"), fields);
  }

  private static FieldDescription field(DynamicMessage field) {
    return new FieldDescription(text(field, "name"), (int) whole(field, "type.type_id"),
        whole(field, "type.capacity"), whole(field, "type.string_capacity"), text(field, "type.nested_type_name"),
        text(field, "default_value"));
  }

  private static long whole(DynamicMessage message, String path) {
    return message.at(path).orElse(null) instanceof RosValue.Whole number ? number.value() : 0;
  }

  private static String text(DynamicMessage message, String path) {
    return message.text(path).orElse("");
  }

  private static DynamicMessage nested(DynamicMessage message, String field) throws MessageException {
    if (message.field(field).orElse(null) instanceof RosValue.Nested inner) {
      return inner.value();
    }
    throw new MessageException("the description lacks " + field, field, 0);
  }

  private static List<DynamicMessage> messages(DynamicMessage message, String field, int most)
      throws MessageException {
    if (message.field(field).orElse(null) instanceof RosValue.Messages list) {
      if (list.values().size() > most) {
        throw new MessageException("more than " + most + " elements", field, 0);
      }
      return list.values();
    }
    throw new MessageException("the description lacks " + field, field, 0);
  }
}
