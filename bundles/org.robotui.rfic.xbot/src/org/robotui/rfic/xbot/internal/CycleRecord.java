package org.robotui.rfic.xbot.internal;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;

/**
 * A message that is read when somebody asks for a field: who records it needs its bytes alone, a thousand times a
 * second.
 */
final class CycleRecord implements DynamicRecord {
  private final String schema;
  private final Supplier<Optional<DynamicRecord>> reading;
  private volatile Optional<DynamicRecord> read = Optional.empty();

  CycleRecord(String schema, Supplier<Optional<DynamicRecord>> reading) {
    this.schema = schema;
    this.reading = reading;
  }

  @Override
  public String schema() {
    return schema;
  }

  @Override
  public List<String> fields() {
    return record().fields();
  }

  @Override
  public Optional<FieldValue> field(String name) {
    return record().field(name);
  }

  /** Several threads may read it at once; they read the same. */
  private DynamicRecord record() {
    if (read.isEmpty()) {
      read = reading.get().or(() -> Optional.of(new MapRecord(schema, Map.of())));
    }
    return read.orElseThrow();
  }
}
