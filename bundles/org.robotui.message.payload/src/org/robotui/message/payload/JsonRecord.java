package org.robotui.message.payload;

import java.math.BigInteger;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.LongStream;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.FieldValue;
import org.robotui.message.data.ByteFields;
import org.robotui.web.tree.JsonNull;

/**
 * An object of JSON as a record. What is null has no value.
 *
 * @param schema the name of its type
 * @param members the members of the object
 */
public record JsonRecord(String schema, Map<String, Object> members) implements ByteFields {
  @Override
  public List<String> fields() {
    return List.copyOf(members.keySet());
  }

  @Override
  public Optional<FieldValue> field(String name) {
    return Optional.ofNullable(members.get(name)).filter(value -> value != JsonNull.NULL).map(this::value);
  }

  /** Bytes are texts in Base64. */
  @Override
  public Optional<Bytes> bytes(String name) {
    if (!(members.get(name) instanceof String text)) {
      return Optional.empty();
    }
    byte[] bytes = Base64.getDecoder().decode(text);
    return Optional.of(Bytes.wrap(bytes, 0, bytes.length));
  }

  private FieldValue value(Object value) {
    return switch (value) {
      case Boolean flag -> new FieldValue.Flag(flag);
      case Long number -> new FieldValue.Num(number, number.toString());
      case BigInteger number -> new FieldValue.Num(number.doubleValue(), number.toString());
      case Number number -> new FieldValue.Num(number.doubleValue(), number.toString());
      case long[] numbers -> new FieldValue.Numbers(Doubles.wrap(LongStream.of(numbers).asDoubleStream().toArray()));
      case double[] numbers -> new FieldValue.Numbers(Doubles.of(numbers));
      case List<?> items -> new FieldValue.Items(items.stream().map(this::value).toList());
      case Map<?, ?> inner -> new FieldValue.Nested(nested(inner));
      case JsonNull none -> new FieldValue.Text("null");
      default -> new FieldValue.Text(value.toString());
    };
  }

  @SuppressWarnings("unchecked") // names are texts in all that is read
  private JsonRecord nested(Map<?, ?> inner) {
    return new JsonRecord("", (Map<String, Object>) inner);
  }
}
