package org.robotui.uic.joints.internal.model;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/**
 * Where joints stand in the robot's own message, so that their values can be named.
 *
 * @param fields how values are called
 * @param names of the joints, in the order of the newest message
 * @param indexes by joint; of a joint that only an older message had, the place there
 */
record JointPlaces(JointRow.Fields fields, List<String> names, Map<String, Integer> indexes) {
  static final JointPlaces NONE = new JointPlaces(JointRow.Fields.ARRAYS, List.of(), Map.of());

  OptionalInt of(String joint) {
    return Optional.ofNullable(indexes.get(joint)).map(OptionalInt::of).orElseGet(OptionalInt::empty);
  }

  /** The places after one message more. */
  JointPlaces with(DynamicRecord message) {
    return message.field("name").map(field -> with(JointRow.Fields.ARRAYS, texts(field, Optional::of)))
        .or(() -> message.field("joints")
            .map(field -> with(JointRow.Fields.RECORDS, texts(field, JointPlaces::nameOf))))
        .orElse(this);
  }

  private JointPlaces with(JointRow.Fields kind, List<String> newest) {
    if (kind == fields && newest.equals(names)) {
      return this;
    }
    boolean kept = kind == fields && indexes.size() < SourceTracks.MOST_JOINTS;
    Map<String, Integer> all = new HashMap<>(kept ? indexes : Map.of());
    for (int i = newest.size() - 1; i >= 0; i--) {
      all.put(newest.get(i), i);
    }
    return new JointPlaces(kind, newest, all);
  }

  private static List<String> texts(FieldValue field, Function<FieldValue, Optional<FieldValue>> text) {
    return field instanceof FieldValue.Items items
        ? items.values().stream()
            .map(item -> text.apply(item).filter(FieldValue.Text.class::isInstance)
                .map(t -> ((FieldValue.Text) t).value()).orElse(""))
            .toList()
        : List.of();
  }

  private static Optional<FieldValue> nameOf(FieldValue item) {
    return item instanceof FieldValue.Nested nested ? nested.value().field("name") : Optional.empty();
  }
}
