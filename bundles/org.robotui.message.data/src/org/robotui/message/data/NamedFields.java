package org.robotui.message.data;

import java.util.List;
import java.util.Map;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;

/**
 * Reads fields of a record whose form is known. A field that is missing is zero or empty, as encodings leave out what
 * is zero or empty.
 *
 * @param record has the fields
 */
record NamedFields(DynamicRecord record) {
  private static final long SECOND = 1_000_000_000L;

  double number(String name) {
    return number(name, 0);
  }

  double number(String name, double otherwise) {
    return record.field(name).filter(FieldValue.Num.class::isInstance).map(v -> ((FieldValue.Num) v).value())
        .orElse(otherwise);
  }

  int size(String name) {
    return Sizes.of(name, (long) number(name));
  }

  String text(String name) {
    return record.field(name).filter(FieldValue.Text.class::isInstance).map(v -> ((FieldValue.Text) v).value())
        .orElse("");
  }

  List<String> texts(String name) {
    return record.field(name).filter(FieldValue.Items.class::isInstance).map(v -> ((FieldValue.Items) v).values())
        .orElse(List.of()).stream().filter(FieldValue.Text.class::isInstance).map(v -> ((FieldValue.Text) v).value())
        .toList();
  }

  boolean flag(String name) {
    return record.field(name).filter(FieldValue.Flag.class::isInstance).map(v -> ((FieldValue.Flag) v).value())
        .orElse(false);
  }

  /** Which of some words a field says, by the word or by its number; the first one where it says none of them. */
  int choice(String name, List<String> words) {
    int named = words.indexOf(text(name));
    double number = named >= 0 ? named : number(name);
    return number >= 0 && number < words.size() ? (int) number : 0;
  }

  /** A time in nanoseconds; encodings that have no times say seconds and the rest. */
  long nanos(String name) {
    return switch (record.field(name).orElse(new FieldValue.Time(0))) {
      case FieldValue.Time time -> time.nanos();
      case FieldValue.Nested parts -> {
        NamedFields both = new NamedFields(parts.value());
        yield (long) both.number("sec") * SECOND + (long) both.number("nsec");
      }
      default -> 0;
    };
  }

  Doubles numbers(String name) {
    return record.field(name).filter(FieldValue.Numbers.class::isInstance).map(v -> ((FieldValue.Numbers) v).values())
        .orElse(Doubles.EMPTY);
  }

  Floats floats(String name) {
    Doubles numbers = numbers(name);
    float[] floats = new float[numbers.size()];
    for (int i = 0; i < floats.length; i++) {
      floats[i] = (float) numbers.get(i);
    }
    return Floats.wrap(floats);
  }

  Bytes bytes(String name) {
    return record instanceof ByteFields fast ? fast.bytes(name).orElse(Bytes.EMPTY) : Bytes.EMPTY;
  }

  /** A record within; one without fields where it is missing. */
  NamedFields inner(String name) {
    return record.field(name).filter(FieldValue.Nested.class::isInstance)
        .map(v -> new NamedFields(((FieldValue.Nested) v).value())).orElseGet(() -> nothing(name));
  }

  private NamedFields nothing(String name) {
    return new NamedFields(new MapRecord(record.schema() + "." + name, Map.of()));
  }

  List<NamedFields> each(String name) {
    return record.field(name).filter(FieldValue.Items.class::isInstance).map(v -> ((FieldValue.Items) v).values())
        .orElse(List.of()).stream().filter(FieldValue.Nested.class::isInstance)
        .map(v -> new NamedFields(((FieldValue.Nested) v).value())).toList();
  }
}
