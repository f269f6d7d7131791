package org.robotui.lcm.type;

import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Follows paths of names and indices into records. */
final class ValuePath {

  private static final Pattern STEP = Pattern.compile("\\.?([A-Za-z_]\\w*)|((?:\\[\\d{1,9}\\])+)");
  private static final Pattern INDEX = Pattern.compile("\\d+");

  private ValuePath() {}

  static Optional<LcmValue> follow(LcmRecord record, String path) {
    Matcher step = STEP.matcher(path);
    Optional<LcmValue> at = Optional.of(new LcmValue.Nested(record));
    int end = 0;
    while (end < path.length() && at.isPresent()) {
      if (!step.find(end) || step.start() != end) {
        return Optional.empty();
      }
      at = step.group(1) != null ? member(at.get(), step.group(1)) : element(at.get(), step.group(2));
      end = step.end();
    }
    return at;
  }

  private static Optional<LcmValue> member(LcmValue value, String name) {
    return value instanceof LcmValue.Nested nested ? nested.value().member(name) : Optional.empty();
  }

  private static Optional<LcmValue> element(LcmValue value, String indices) {
    List<Integer> index = INDEX.matcher(indices).results().map(found -> Integer.valueOf(found.group())).toList();
    return switch (value) {
      case LcmValue.Numbers numbers -> flat(index, numbers.value().shape()).map(i -> number(numbers.value(), i));
      case LcmValue.Texts texts -> flat(index, texts.shape()).map(i -> new LcmValue.Text(texts.values().get(i)));
      case LcmValue.Records records -> flat(index, records.shape())
          .map(i -> new LcmValue.Nested(records.values().get(i)));
      default -> Optional.empty();
    };
  }

  private static LcmValue number(NumberArray array, int index) {
    return switch (array.type()) {
      case FLOAT, DOUBLE -> new LcmValue.Real(array.number(index));
      case BOOLEAN -> new LcmValue.Flag(array.whole(index) != 0);
      default -> new LcmValue.Whole(array.whole(index));
    };
  }

  /** Row by row. */
  private static Optional<Integer> flat(List<Integer> index, List<Integer> shape) {
    if (index.size() != shape.size()) {
      return Optional.empty();
    }
    int flat = 0;
    for (int i = 0; i < shape.size(); i++) {
      if (index.get(i) >= shape.get(i)) {
        return Optional.empty();
      }
      flat = flat * shape.get(i) + index.get(i);
    }
    return Optional.of(flat);
  }
}
