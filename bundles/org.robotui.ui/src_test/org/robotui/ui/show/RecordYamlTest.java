package org.robotui.ui.show;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

class RecordYamlTest {
  @Test
  void fieldsNestAndListsFlow() {
    Map<String, FieldValue> fields = new LinkedHashMap<>();
    fields.put("stamp", new FieldValue.Time(1_500_000_000L));
    fields.put("frame_id", new FieldValue.Text("a \"b\"\n"));
    fields.put("ok", new FieldValue.Flag(true));
    fields.put("ranges", new FieldValue.Numbers(Doubles.of(1, 2.5)));
    fields.put("names", new FieldValue.Items(List.of(new FieldValue.Text("x"))));
    fields.put("pose", new FieldValue.Nested(new Values(Map.of("x", new FieldValue.Num(1, "1.0")))));
    assertEquals("""
        stamp:
          secs: 1
          nsecs: 500000000
        frame_id: "a \\"b\\"\\n"
        ok: true
        ranges: [1, 2.5]
        names:
          - "x"
        pose:
          x: 1.0
        """, RecordYaml.of(new Values(fields)));
  }

  @Test
  void longListsAreCutAndSaySo() {
    String text =
        RecordYaml.of(new Values(Map.of("data", new FieldValue.Numbers(Doubles.wrap(new double[1_000_000])))));
    assertTrue(text.endsWith("] # and 990000 more\n"), text);
  }

  @Test
  void whatIsNoNumberIsWrittenAsYamlWritesIt() {
    Map<String, FieldValue> fields = new LinkedHashMap<>();
    fields.put("charge", new FieldValue.Num(Double.NaN, "NaN"));
    fields.put("ranges", new FieldValue.Numbers(Doubles.of(Double.POSITIVE_INFINITY, -1, Double.NEGATIVE_INFINITY)));
    fields.put("text", new FieldValue.Text("bell\u0007"));
    assertEquals("""
        charge: .nan
        ranges: [.inf, -1, -.inf]
        text: "bell\\u0007"
        """, RecordYaml.of(new Values(fields)));
  }

  private record Values(Map<String, FieldValue> all) implements DynamicRecord {
    @Override
    public String schema() {
      return "test/Values";
    }

    @Override
    public List<String> fields() {
      return List.copyOf(all.keySet());
    }

    @Override
    public Optional<FieldValue> field(String name) {
      return Optional.ofNullable(all.get(name));
    }
  }
}
