package org.robotui.bridge.internal.change;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.bridge.FieldFormula;
import org.robotui.api.config.Settings;
import org.robotui.data.Stamp;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;

/**
 * Makes a message of expressions over the fields of another one.
 *
 * @param type the name of the type of what is made
 * @param fields the expressions, by the paths of the fields
 */
public record FieldMapping(String type, Map<String, FieldFormula> fields) {
  private static final String STAMP = "stamp";

  /** As configured; none where no fields are mapped. */
  public static Optional<FieldMapping> of(Settings settings) {
    return of(settings, "fields", settings.has("type") ? settings.text("type") : "fields");
  }

  /** As configured by a word of its own; none where it is not written. */
  static Optional<FieldMapping> of(Settings settings, String word, String type) {
    if (!settings.has(word)) {
      return Optional.empty();
    }
    Map<String, FieldFormula> fields = new LinkedHashMap<>();
    settings.map(word).forEach((path, text) -> fields.put(path.toString(), FieldFormula.parse(text.toString())));
    return Optional.of(new FieldMapping(type, fields));
  }

  /**
   * The message for a record. Its stamp is there by the name {@code stamp}, unless it has such a field itself.
   *
   * @throws IllegalArgumentException where a field is not there; names it
   */
  public DynamicRecord of(DynamicRecord record, Optional<Stamp> stamp) {
    DynamicRecord source = stamp.filter(s -> record.field(STAMP).isEmpty())
        .<DynamicRecord>map(s -> new Stamped(record, s)).orElse(record);
    Map<String, Object> tree = new LinkedHashMap<>();
    fields.forEach((path, expression) -> put(tree, path, expression.of(source).orElseThrow(
        () -> new IllegalArgumentException(
            record.schema() + " has no '" + expression.missing(source).orElse("") + "' for the field '" + path
                + "'; it has " + String.join(", ", record.fields())))));
    return record(tree, type);
  }

  @SuppressWarnings("unchecked") // what is no value is a map of the same kind
  private static void put(Map<String, Object> tree, String path, FieldValue value) {
    int dot = path.indexOf('.');
    if (dot < 0) {
      tree.put(path, value);
      return;
    }
    Object inner = tree.computeIfAbsent(path.substring(0, dot), name -> new LinkedHashMap<String, Object>());
    if (!(inner instanceof Map<?, ?> map)) {
      throw new IllegalArgumentException("'" + path.substring(0, dot) + "' is a value already; it has no parts");
    }
    put((Map<String, Object>) map, path.substring(dot + 1), value);
  }

  private static DynamicRecord record(Map<?, ?> tree, String type) {
    Map<String, FieldValue> values = new LinkedHashMap<>();
    tree.forEach((name, value) -> values.put(name.toString(),
        value instanceof Map<?, ?> map ? new FieldValue.Nested(record(map, "")) : (FieldValue) value));
    return new MapRecord(type, values);
  }

  /** A record with the stamp that it travelled with. */
  private record Stamped(DynamicRecord inner, Stamp stamp) implements DynamicRecord {
    @Override
    public String schema() {
      return inner.schema();
    }

    @Override
    public List<String> fields() {
      return inner.fields();
    }

    @Override
    public Optional<FieldValue> field(String name) {
      return name.equals(STAMP) ? Optional.of(new FieldValue.Time(stamp.nanos())) : inner.field(name);
    }
  }
}
