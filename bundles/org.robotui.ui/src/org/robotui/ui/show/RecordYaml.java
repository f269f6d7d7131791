package org.robotui.ui.show;

import java.util.List;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/** A message as text that people of the field read: as YAML, as far as its size is sensible. Any thread. */
public final class RecordYaml {
  private static final int MOST_ELEMENTS = 10_000;
  private static final int MOST_CHARACTERS = 2_000_000;
  private static final int MOST_TEXT = 100_000;
  private static final long NANOS = 1_000_000_000L;

  private final StringBuilder text = new StringBuilder();

  private RecordYaml() {}

  /**
   * The text of a message.
   *
   * @param record the message
   * @return its fields, in their order; very long lists are cut, and say so
   */
  public static String of(DynamicRecord record) {
    RecordYaml writer = new RecordYaml();
    writer.record(record, 0);
    return writer.text.toString();
  }

  private void record(DynamicRecord record, int depth) {
    for (String name : record.fields()) {
      if (text.length() > MOST_CHARACTERS) {
        indent(depth).append("# and more\n");
        return;
      }
      indent(depth).append(name).append(':');
      record.field(name).ifPresentOrElse(value -> value(value, depth), () -> text.append(" null\n"));
    }
  }

  private void value(FieldValue value, int depth) {
    switch (value) {
      case FieldValue.Num n -> text.append(' ').append(Scalars.yaml(n)).append('\n');
      case FieldValue.Flag f -> text.append(' ').append(f.value()).append('\n');
      case FieldValue.Text t -> text.append(' ').append(quoted(t.value())).append('\n');
      case FieldValue.Time t -> time(t.nanos(), depth);
      case FieldValue.Numbers n -> numbers(n.values());
      case FieldValue.Items i -> items(i.values(), depth);
      case FieldValue.Nested n -> nested(n.value(), depth);
    }
  }

  private void nested(DynamicRecord record, int depth) {
    if (record.fields().isEmpty()) {
      text.append(" {}\n");
    } else {
      text.append('\n');
      record(record, depth + 1);
    }
  }

  private void time(long nanos, int depth) {
    text.append('\n');
    indent(depth + 1).append("secs: ").append(Math.floorDiv(nanos, NANOS)).append('\n');
    indent(depth + 1).append("nsecs: ").append(Math.floorMod(nanos, NANOS)).append('\n');
  }

  private void numbers(Doubles values) {
    text.append(" [");
    int shown = Math.min(values.size(), MOST_ELEMENTS);
    for (int i = 0; i < shown; i++) {
      text.append(i == 0 ? "" : ", ").append(Scalars.yaml(values.get(i)));
    }
    text.append(']');
    cut(values.size(), shown);
    text.append('\n');
  }

  private void items(List<FieldValue> values, int depth) {
    if (values.isEmpty()) {
      text.append(" []\n");
      return;
    }
    text.append('\n');
    int shown = Math.min(values.size(), MOST_ELEMENTS);
    for (FieldValue value : values.subList(0, shown)) {
      indent(depth + 1).append('-');
      value(value, depth + 1);
    }
    if (values.size() > shown) {
      indent(depth + 1).append('#');
      text.append(" and ").append(values.size() - shown).append(" more\n");
    }
  }

  private void cut(int size, int shown) {
    if (size > shown) {
      text.append(" # and ").append(size - shown).append(" more");
    }
  }

  private static String quoted(String value) {
    String shown = value.length() > MOST_TEXT ? value.substring(0, MOST_TEXT) + "\u2026" : value;
    return Scalars.quoted(shown);
  }

  private StringBuilder indent(int depth) {
    return text.append("  ".repeat(depth));
  }
}
