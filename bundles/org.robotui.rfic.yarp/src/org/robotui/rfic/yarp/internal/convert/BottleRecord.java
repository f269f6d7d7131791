package org.robotui.rfic.yarp.internal.convert;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.YarpValue;

/**
 * A bottle as a record. Its values have no names: they are {@code field1} and so on.
 *
 * @param schema the name of the port
 * @param bottle what it said
 */
public record BottleRecord(String schema, Bottle bottle) implements DynamicRecord {
  private static final String FIELD = "field";

  @Override
  public List<String> fields() {
    return IntStream.rangeClosed(1, bottle.size()).mapToObj(i -> FIELD + i).toList();
  }

  @Override
  public Optional<FieldValue> field(String name) {
    if (!name.matches(FIELD + "[1-9][0-9]{0,8}")) {
      return Optional.empty();
    }
    int index = Integer.parseInt(name.substring(FIELD.length())) - 1;
    return index < bottle.size() ? Optional.of(value(name, bottle.get(index))) : Optional.empty();
  }

  private static FieldValue value(String name, YarpValue value) {
    return switch (value) {
      case YarpValue.Whole whole -> new FieldValue.Num(whole.value(), Long.toString(whole.value()));
      case YarpValue.Real real -> new FieldValue.Num(real.value(), Double.toString(real.value()));
      case YarpValue.Text text -> new FieldValue.Text(text.value());
      case YarpValue.Vocab vocab -> new FieldValue.Text(vocab.word());
      case YarpValue.Blob blob -> numbers(blob.bytes());
      case Bottle list -> list(name, list);
    };
  }

  private static FieldValue list(String name, Bottle list) {
    double[] numbers = list.numbers();
    boolean plain = list.values().stream().allMatch(v -> v instanceof YarpValue.Real || v instanceof YarpValue.Whole);
    if (plain) {
      return new FieldValue.Numbers(Doubles.wrap(numbers));
    }
    List<FieldValue> items = new ArrayList<>();
    list.values().forEach(value -> items.add(value(name, value)));
    return new FieldValue.Items(items);
  }

  private static FieldValue numbers(byte[] bytes) {
    double[] values = new double[bytes.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = bytes[i] & 0xff;
    }
    return new FieldValue.Numbers(Doubles.wrap(values));
  }
}
