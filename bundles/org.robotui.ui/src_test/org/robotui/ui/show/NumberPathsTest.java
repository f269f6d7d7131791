package org.robotui.ui.show;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.data.array.Doubles;
import org.robotui.data.joint.JointState;
import org.robotui.data.record.DataRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;

class NumberPathsTest {
  @Test
  void findsNumbersOfListsOfRecords() {
    JointState joints = new JointState(List.of(new JointState.Joint("a", 1, 2, 3)));
    assertEquals(List.of("joints[0].position", "joints[0].velocity", "joints[0].effort"),
        NumberPaths.of(DataRecord.of(joints)));
  }

  @Test
  void leavesOutHeadersTextsAndLongLists() {
    FieldValue number = new FieldValue.Num(1, "1");
    MapRecord record = new MapRecord("test/Record",
        Map.of("header", new FieldValue.Nested(new MapRecord("Header", Map.of("seq", number))),
            "name", new FieldValue.Text("x"), "ranges", new FieldValue.Numbers(Doubles.wrap(new double[13]))));
    assertEquals(List.of(), NumberPaths.of(record));
  }

  @Test
  void ofAFieldThatIsANumberThereIsItselfAlone() {
    assertEquals(List.of("data"), NumberPaths.at("data", new FieldValue.Flag(true)));
    assertEquals(List.of("axes[0]", "axes[1]"), NumberPaths.at("axes", new FieldValue.Numbers(Doubles.of(1, 2))));
  }

  @Test
  void endsWhereThereAreVeryMany() {
    FieldValue list = new FieldValue.Numbers(Doubles.wrap(new double[12]));
    FieldValue lists = new FieldValue.Items(List.of(list, list, list, list, list, list, list));
    assertEquals(60, NumberPaths.at("all", lists).size());
  }
}
