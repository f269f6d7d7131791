package org.robotui.rfic.smartsoft.internal.convert;

import java.util.List;
import org.robotui.message.DynamicMessage;
import org.robotui.message.RosValue;

/** Reads fields of objects by their paths. What is not there, or no number, is an {@link IllegalArgumentException}. */
final class ObjectFields {
  private ObjectFields() {}

  static double of(DynamicMessage object, String path) {
    double value = object.number(path).orElseThrow(() -> new IllegalArgumentException("there is no " + path));
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(path + " is " + value);
    }
    return value;
  }

  static DynamicMessage within(DynamicMessage object, String path) {
    return object.at(path).filter(RosValue.Nested.class::isInstance).map(v -> ((RosValue.Nested) v).value())
        .orElseThrow(() -> new IllegalArgumentException("there is no " + path));
  }

  static List<DynamicMessage> list(DynamicMessage object, String field) {
    return object.field(field).filter(RosValue.Messages.class::isInstance).map(v -> ((RosValue.Messages) v).values())
        .orElseThrow(() -> new IllegalArgumentException("there is no list " + field));
  }

  static double[] numbers(DynamicMessage object, String field) {
    return object.field(field).filter(RosValue.Numbers.class::isInstance)
        .map(v -> ((RosValue.Numbers) v).values().toDoubles())
        .orElseThrow(() -> new IllegalArgumentException("there are no numbers " + field));
  }
}
