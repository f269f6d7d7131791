package org.robotui.message;

import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Follows paths such as {@code points[3].x} through a message. */
final class ValuePath {

  private static final Pattern STEP = Pattern.compile("(?:^|(?<!^)\\.)([A-Za-z]\\w*)|\\[(\\d{1,9})\\]");

  private ValuePath() {}

  static Optional<RosValue> follow(DynamicMessage message, String path) {
    if (!path.isEmpty() && path.indexOf('.') < 0 && path.indexOf('[') < 0) {
      return message.field(path);
    }
    Matcher step = STEP.matcher(path);
    Optional<RosValue> value = Optional.of(new RosValue.Nested(message));
    int end = 0;
    while (end < path.length() && value.isPresent()) {
      if (!step.find(end) || step.start() != end) {
        return Optional.empty();
      }
      value = step.group(1) != null
          ? named(value.get(), step.group(1))
          : element(value.get(), Integer.parseInt(step.group(2)));
      end = step.end();
    }
    return value;
  }

  private static Optional<RosValue> named(RosValue value, String name) {
    return switch (value) {
      case RosValue.Nested n -> n.value().field(name);
      case RosValue.Instant t -> part(t, name);
      default -> Optional.empty();
    };
  }

  private static Optional<RosValue> part(RosValue.Instant instant, String name) {
    boolean time = instant.type() == Primitive.TIME;
    int secs = Stamps.secs(instant.nanos());
    return switch (name) {
      case "secs", "sec" -> Optional.of(time
          ? new RosValue.Whole(Integer.toUnsignedLong(secs), Primitive.UINT32)
          : new RosValue.Whole(secs, Primitive.INT32));
      case "nsecs", "nanosec" -> Optional.of(new RosValue.Whole(
          Stamps.nsecs(instant.nanos()), time ? Primitive.UINT32 : Primitive.INT32));
      default -> Optional.empty();
    };
  }

  private static Optional<RosValue> element(RosValue value, int index) {
    return switch (value) {
      case RosValue.Numbers n when index < n.values().size() -> Optional.of(n.values().value(index));
      case RosValue.Texts t -> get(t.values(), index).map(RosValue.Text::new);
      case RosValue.Messages m -> get(m.values(), index).map(RosValue.Nested::new);
      default -> Optional.empty();
    };
  }

  private static <T> Optional<T> get(List<T> values, int index) {
    return index < values.size() ? Optional.of(values.get(index)) : Optional.empty();
  }
}
