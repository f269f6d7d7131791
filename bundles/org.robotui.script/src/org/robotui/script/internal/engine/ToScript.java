package org.robotui.script.internal.engine;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.robotui.data.Data;
import org.robotui.data.record.DataRecord;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/**
 * Brings plain values and data of robots into a script. Records are taken apart when the script looks into them.
 *
 * @param context of the thread
 * @param scope whose objects are made
 */
record ToScript(Context context, Scriptable scope) {
  Object of(Object value) {
    return switch (value) {
      case null -> null;
      case Optional<?> optional -> of(optional.orElse(null));
      case Boolean flag -> flag;
      case Number number -> number.doubleValue();
      case CharSequence text -> text.toString();
      case List<?> items -> array(items);
      case Map<?, ?> members -> object(members);
      case FieldValue field -> of(field);
      case DynamicRecord record -> new RecordView(record, scope);
      case Data data -> new RecordView(DataRecord.of(data), scope);
      case Record record -> new RecordView(DataRecord.ofRecord(record), scope);
      default -> value.toString();
    };
  }

  /** Times are seconds, as everything that a script reads is in SI units. */
  Object of(FieldValue field) {
    return switch (field) {
      case FieldValue.Num number -> number.value();
      case FieldValue.Flag flag -> flag.value();
      case FieldValue.Text text -> text.value();
      case FieldValue.Time time -> time.nanos() * 1e-9;
      case FieldValue.Numbers numbers -> numbers(numbers);
      case FieldValue.Items items -> array(items.values());
      case FieldValue.Nested nested -> new RecordView(nested.value(), scope);
    };
  }

  private Object numbers(FieldValue.Numbers numbers) {
    Object[] values = new Object[numbers.values().size()];
    for (int i = 0; i < values.length; i++) {
      values[i] = numbers.values().get(i);
    }
    return context.newArray(scope, values);
  }

  private Object array(List<?> items) {
    return context.newArray(scope, items.stream().map(this::of).toArray());
  }

  private Object object(Map<?, ?> members) {
    Scriptable made = context.newObject(scope);
    members.forEach((name, value) -> ScriptableObject.putProperty(made, String.valueOf(name), of(value)));
    return made;
  }
}
