package org.robotui.ui.show;

import java.util.Iterator;
import java.util.List;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/** A message as JSON, as far as its size is sensible. What is not finite is {@code null}. Any thread. */
public final class RecordJson {
  private static final int MOST_ELEMENTS = 10_000;
  private static final int DEEPEST = 64;
  private static final long NANOS = 1_000_000_000L;

  private final StringBuilder text = new StringBuilder();

  private RecordJson() {}

  /**
   * The text of a message.
   *
   * @param record the message
   * @return an object with its fields, in their order; in place of a very long list a text that says how long it is
   */
  public static String of(DynamicRecord record) {
    RecordJson writer = new RecordJson();
    writer.record(record, 0);
    return writer.text.append('\n').toString();
  }

  private void record(DynamicRecord record, int depth) {
    Iterator<String> names = record.fields().iterator();
    if (!names.hasNext()) {
      text.append("{}");
      return;
    }
    text.append("{\n");
    while (names.hasNext()) {
      String name = names.next();
      indent(depth + 1).append(Scalars.quoted(name)).append(": ");
      record.field(name).ifPresentOrElse(value -> value(value, depth + 1), () -> text.append("null"));
      text.append(names.hasNext() ? ",\n" : "\n");
    }
    indent(depth).append('}');
  }

  private void value(FieldValue value, int depth) {
    switch (value) {
      case FieldValue.Num n -> text.append(Scalars.json(n));
      case FieldValue.Flag f -> text.append(f.value());
      case FieldValue.Text t -> text.append(Scalars.quoted(t.value()));
      case FieldValue.Time t -> text.append("{\"secs\": ").append(Math.floorDiv(t.nanos(), NANOS))
          .append(", \"nsecs\": ")
          .append(Math.floorMod(t.nanos(), NANOS)).append('}');
      case FieldValue.Numbers n -> numbers(n.values());
      case FieldValue.Items i -> items(i.values(), depth);
      case FieldValue.Nested n when depth < DEEPEST -> record(n.value(), depth);
      case FieldValue.Nested n -> text.append("null");
    }
  }

  private void numbers(Doubles values) {
    if (values.size() > MOST_ELEMENTS) {
      tooLong(values.size());
      return;
    }
    text.append('[');
    for (int i = 0; i < values.size(); i++) {
      text.append(i == 0 ? "" : ", ").append(Scalars.json(values.get(i)));
    }
    text.append(']');
  }

  private void items(List<FieldValue> values, int depth) {
    if (values.size() > MOST_ELEMENTS) {
      tooLong(values.size());
      return;
    }
    text.append('[');
    for (int i = 0; i < values.size(); i++) {
      text.append(i == 0 ? "" : ", ");
      value(values.get(i), depth);
    }
    text.append(']');
  }

  private void tooLong(int size) {
    text.append(Scalars.quoted("<" + size + " elements>"));
  }

  private StringBuilder indent(int depth) {
    return text.append("  ".repeat(depth));
  }
}
