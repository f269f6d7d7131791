package org.robotui.uic.plot.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.Input;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DataRecord;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.uic.plot.internal.Robots;

class FieldTreeTest {
  private static final List<Input.Candidate> CANDIDATES = List.of(
      new Input.Candidate(Robots.ODOM, "Odometry"), new Input.Candidate(Robots.JOINTS, "JointState"));

  private final FieldTree tree = new FieldTree();
  private Optional<FieldTree.Learned> learned = Optional.empty();

  @Test
  void sourcesAreClosedAndAskNothingOfTheRobot() {
    assertEquals(List.of("base./odom", "arm./joint_states"), names(""));
    assertEquals(Set.of(), tree.openSources());
  }

  @Test
  void anOpenSourceIsAskedForAndWaitsForItsFirstValue() {
    open("base./odom");
    assertEquals(Set.of(Robots.ODOM), tree.openSources());
    assertTrue(names("").get(1).startsWith("waiting"));
  }

  @Test
  void fieldsAppearWithTheFirstValueAndOpenOneByOne() {
    open("base./odom");
    learned = Optional.of(new FieldTree.Learned(DataRecord.of(Robots.odometry(1, 2)), Optional.empty()));
    assertTrue(names("").containsAll(List.of("pose", "linear", "angular")));
    open("linear");
    assertEquals(List.of("base./odom:linear.x"), row("x").signals());
    assertEquals("1.000", row("x").detail());
  }

  @Test
  void aShortListIsPlottedAtOnceALongOneIsNot() {
    open("base./odom");
    learned = Optional.of(new FieldTree.Learned(new Record(4, 1000), Optional.empty()));
    assertEquals(4, row("few").signals().size());
    assertEquals("base./odom:few[3]", row("few").signals().get(3));
    assertEquals(List.of(), row("many").signals());
    open("many");
    assertTrue(rows("").size() < 400, "what is shown of a long list is bounded");
  }

  @Test
  void elementsThatNameThemselvesAreCalledSo() {
    open("base./odom");
    learned = Optional.of(new FieldTree.Learned(DataRecord.of(Robots.joints(1)), Optional.empty()));
    open("joints");
    assertTrue(names("").contains("[1] elbow"));
  }

  @Test
  void theRobotsOwnNamesStandApart() {
    open("base./odom");
    learned = Optional.of(new FieldTree.Learned(DataRecord.of(Robots.odometry(1, 2)), Optional.of(new Record(2, 2))));
    open("names of the robot");
    assertEquals(List.of("base./odom:few[0]", "base./odom:few[1]"), row("few").signals());
  }

  @Test
  void theFilterFindsSourcesTypesAndLearnedFields() {
    assertEquals(List.of("arm./joint_states"), names("JOINT"));
    assertEquals(List.of("base./odom"), names("odometry"));
    open("base./odom");
    learned = Optional.of(new FieldTree.Learned(DataRecord.of(Robots.odometry(1, 2)), Optional.empty()));
    assertTrue(names("angular.z").contains("z"));
    assertTrue(!names("angular.z").contains("linear"));
  }

  private void open(String name) {
    tree.toggle(row(name));
    rows("");
  }

  private FieldTree.Row row(String name) {
    return rows("").stream().filter(r -> r.name().equals(name)).findFirst().orElseThrow();
  }

  private List<String> names(String filter) {
    return rows(filter).stream().map(FieldTree.Row::name).toList();
  }

  private List<FieldTree.Row> rows(String filter) {
    return tree.rows(CANDIDATES, source -> source.equals(Robots.ODOM) ? learned : Optional.empty(), filter);
  }

  private record Record(int few, int many) implements DynamicRecord {
    @Override
    public String schema() {
      return "test/Lists";
    }

    @Override
    public List<String> fields() {
      return List.of("few", "many");
    }

    @Override
    public Optional<FieldValue> field(String name) {
      int size = name.equals("few") ? few : many;
      return Optional.of(new FieldValue.Numbers(Doubles.wrap(IntStream.range(0, size).asDoubleStream().toArray())));
    }
  }
}
