package org.robotui.message.payload.protobuf;

import com.google.protobuf.ByteString;
import com.google.protobuf.UnknownFieldSet;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/**
 * A message whose type is not known. A number is shown as it would be without a sign or a point; bytes are text where
 * they are that, else only how many they are.
 *
 * @param schema the name of its type
 * @param all its fields
 */
record NumberedRecord(String schema, UnknownFieldSet all) implements DynamicRecord {

  @Override
  public List<String> fields() {
    return all.asMap().keySet().stream().sorted().map(String::valueOf).toList();
  }

  @Override
  public Optional<FieldValue> field(String name) {
    if (!fields().contains(name)) {
      return Optional.empty();
    }
    List<FieldValue> values = values(all.getField(Integer.parseInt(name)));
    return Optional.of(values.size() == 1 ? values.getFirst() : new FieldValue.Items(values));
  }

  private List<FieldValue> values(UnknownFieldSet.Field field) {
    List<FieldValue> values = new ArrayList<>();
    field.getVarintList().forEach(each -> values.add(number(each)));
    field.getFixed32List().forEach(each -> values.add(number(Float.intBitsToFloat(each))));
    field.getFixed64List().forEach(each -> values.add(number(Double.longBitsToDouble(each))));
    field.getLengthDelimitedList().forEach(each -> values.add(bytes(each)));
    return values;
  }

  private static FieldValue number(Number value) {
    return new FieldValue.Num(value.doubleValue(), value.toString());
  }

  private static FieldValue bytes(ByteString each) {
    boolean text = each.isValidUtf8() && each.toStringUtf8().chars().noneMatch(c -> c < ' ' && c != '\n' && c != '\t');
    return new FieldValue.Text(text ? each.toStringUtf8() : each.size() + " bytes");
  }
}
