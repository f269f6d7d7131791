package org.robotui.bridge.internal.change;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robotui.data.Stamp;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/**
 * A message with other frames and stamps, by the names that fields of messages have for them. Nothing is changed before
 * it is asked for.
 *
 * @param inner the message
 * @param frames what frames are called
 * @param shiftNanos what is added to stamps
 * @param ofHeader the stamp of the header, where it is known better
 * @param own the stamp of this record, where it is known better
 */
record RewrittenRecord(DynamicRecord inner, FrameRenaming frames, long shiftNanos, Optional<Stamp> ofHeader,
    Optional<Stamp> own) implements DynamicRecord {
  private static final Set<String> FRAMES = Set.of("frame_id", "child_frame_id", "frame", "child_frame");
  private static final String STAMP = "stamp";
  private static final String HEADER = "header";

  @Override
  public String schema() {
    return inner.schema();
  }

  @Override
  public List<String> fields() {
    return inner.fields();
  }

  @Override
  public Optional<Bytes> bytes(String name) {
    return inner.bytes(name);
  }

  @Override
  public Optional<FieldValue> field(String name) {
    return inner.field(name).map(value -> rewritten(name, value));
  }

  private FieldValue rewritten(String name, FieldValue value) {
    return switch (value) {
      case FieldValue.Text text when FRAMES.contains(name) -> new FieldValue.Text(frames.of(text.value()));
      case FieldValue.Time time when name.equals(STAMP) -> new FieldValue.Time(moved(time.nanos()));
      case FieldValue.Nested nested -> new FieldValue.Nested(new RewrittenRecord(nested.value(), frames, shiftNanos,
          Optional.empty(), name.equals(HEADER) ? ofHeader : Optional.empty()));
      case FieldValue.Items items -> new FieldValue.Items(
          items.values().stream().map(item -> rewritten(name, item)).toList());
      default -> value;
    };
  }

  /** Where nobody has set a stamp, there is none on the other side either. */
  private long moved(long nanos) {
    return own.map(Stamp::nanos).orElse(nanos == 0 ? 0 : nanos + shiftNanos);
  }
}
