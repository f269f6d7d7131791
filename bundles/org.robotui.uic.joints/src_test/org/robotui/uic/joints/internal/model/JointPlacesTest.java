package org.robotui.uic.joints.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

class JointPlacesTest {
  @Test
  void findsTheNamesOfARosMessage() {
    JointPlaces places = JointPlaces.NONE.with(message("shoulder", "elbow"));
    assertEquals(JointRow.Fields.ARRAYS, places.fields());
    assertEquals(OptionalInt.of(1), places.of("elbow"));
    assertEquals(OptionalInt.empty(), places.of("knee"));
  }

  @Test
  void keepsWhatOnlyAnOlderMessageHad() {
    JointPlaces places = JointPlaces.NONE.with(message("shoulder", "elbow")).with(message("gripper"));
    assertEquals(OptionalInt.of(0), places.of("gripper"));
    assertEquals(OptionalInt.of(1), places.of("elbow"));
  }

  @Test
  void theFirstOfTwoJointsOfOneNameCounts() {
    assertEquals(OptionalInt.of(0), JointPlaces.NONE.with(message("a", "a")).of("a"));
  }

  @Test
  void aMessageOfAnotherFormTellsNothing() {
    assertEquals(JointPlaces.NONE, JointPlaces.NONE.with(new Message("name", new FieldValue.Text("shoulder"))));
    assertEquals(JointPlaces.NONE, JointPlaces.NONE.with(new Message("other", new FieldValue.Text("shoulder"))));
  }

  static DynamicRecord message(String... names) {
    return new Message("name",
        new FieldValue.Items(Stream.of(names).map(n -> (FieldValue) new FieldValue.Text(n)).toList()));
  }

  private record Message(String only, FieldValue value) implements DynamicRecord {
    @Override
    public String schema() {
      return "sensor_msgs/JointState";
    }

    @Override
    public List<String> fields() {
      return List.of(only);
    }

    @Override
    public Optional<FieldValue> field(String name) {
      return name.equals(only) ? Optional.of(value) : Optional.empty();
    }
  }
}
