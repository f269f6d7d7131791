package org.robotui.ui.show;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;

class RecordJsonTest {
  @Test
  void fieldsNestAndWhatIsNotFiniteIsNull() {
    Map<String, FieldValue> fields = new LinkedHashMap<>();
    fields.put("stamp", new FieldValue.Time(-500_000_000L));
    fields.put("frame", new FieldValue.Text("a \"b\"\n\u0001"));
    fields.put("charge", new FieldValue.Num(Double.NaN, "NaN"));
    fields.put("id", new FieldValue.Num(9.007199254740993E15, "9007199254740993"));
    fields.put("ranges", new FieldValue.Numbers(Doubles.of(1, Double.POSITIVE_INFINITY, 2.5)));
    fields.put("joints", new FieldValue.Items(
        List.of(new FieldValue.Nested(new MapRecord("Joint", Map.of("ok", new FieldValue.Flag(true)))))));
    fields.put("nothing", new FieldValue.Nested(new MapRecord("Empty", Map.of())));
    assertEquals("""
        {
          "stamp": {"secs": -1, "nsecs": 500000000},
          "frame": "a \\"b\\"\\n\\u0001",
          "charge": null,
          "id": 9007199254740993,
          "ranges": [1, null, 2.5],
          "joints": [{
            "ok": true
          }],
          "nothing": {}
        }
        """, RecordJson.of(new MapRecord("test/All", fields)));
  }

  @Test
  void aVeryLongListSaysHowLongItIs() {
    MapRecord image = new MapRecord("Image", Map.of("data", new FieldValue.Numbers(Doubles.wrap(new double[921_600]))));
    assertEquals("{\n  \"data\": \"<921600 elements>\"\n}\n", RecordJson.of(image));
  }
}
