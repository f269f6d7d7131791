package org.robotui.message.roblets;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.record.RecordShape;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyForm;

/** Elements as records: attributes and elements are fields, several of one name are a list. */
public final class ElementRecord {
  private static final String TEXT = "text";

  private ElementRecord() {}

  /**
   * An element as a record.
   *
   * @param schema the name of the record's type
   * @param element the element
   * @return its attributes, its text as {@code text}, and its elements; numbers and flags are such where they look so
   */
  public static DynamicRecord of(String schema, BodyElement element) {
    Map<String, FieldValue> fields = new LinkedHashMap<>();
    element.attributes().forEach((name, text) -> fields.put(name, value(element, name, text)));
    if (!element.text().isEmpty()) {
      fields.put(TEXT, plain(element.text()));
    }
    Map<String, List<BodyElement>> children = element.children().stream()
        .collect(Collectors.groupingBy(BodyElement::name, LinkedHashMap::new, Collectors.toList()));
    children.forEach((name, all) -> fields.putIfAbsent(name, all.size() == 1 ? value(all.getFirst())
        : new FieldValue.Items(all.stream().map(ElementRecord::value).toList())));
    return new MapRecord(schema, fields);
  }

  /**
   * The form of such records, without what lies within elements.
   *
   * @param schema the name of the record's type
   * @param form how the message is described
   * @return its form
   */
  public static RecordShape shape(String schema, BodyForm form) {
    return new RecordShape(schema, form.fields().stream().filter(field -> !field.name().contains("/"))
        .map(field -> new RecordShape.Field(field.name(), shape(field.kind()))).toList(), List.of());
  }

  private static FieldShape shape(String kind) {
    return switch (kind) {
      case "number" -> new FieldShape.Real(Double.SIZE);
      case "whole" -> new FieldShape.Whole(Long.SIZE, true);
      case "flag" -> new FieldShape.Flag();
      default -> new FieldShape.Text();
    };
  }

  /** An element of which there is nothing but its text is that text. */
  private static FieldValue value(BodyElement element) {
    return element.attributes().isEmpty() && element.children().isEmpty() ? plain(element.text())
        : new FieldValue.Nested(of(element.name(), element));
  }

  private static FieldValue value(BodyElement element, String name, String text) {
    OptionalDouble number = element.number(name);
    return number.isPresent() ? new FieldValue.Num(number.getAsDouble(), text) : word(text);
  }

  private static FieldValue plain(String text) {
    return value(BodyElement.of(TEXT).with(TEXT, text), TEXT, text);
  }

  private static FieldValue word(String text) {
    return text.equals("true") || text.equals("false") ? new FieldValue.Flag(text.equals("true"))
        : new FieldValue.Text(text);
  }
}
