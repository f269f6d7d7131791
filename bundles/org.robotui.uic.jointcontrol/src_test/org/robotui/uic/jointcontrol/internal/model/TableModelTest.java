package org.robotui.uic.jointcontrol.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.api.input.Unreadable;
import org.robotui.api.port.InputState;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointModel;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeOutput;
import org.robotui.ui.Health;
import org.robotui.uic.jointcontrol.internal.Robots;

class TableModelTest {
  private final FakeInput<JointControl> control = new FakeInput<>();
  private final FakeInput<JointModel> described = new FakeInput<>();
  private final JointDriver driver =
      new JointDriver(new FakeOutput<JointCommand>(new FakeAuthority("Arm")), FakeAuthority.YOU, () -> 0.2);
  private final ControlModel model = new ControlModel(control, described, driver, () -> true);

  @Test
  void jointsStandInTheirChainsAndThenTheRest() {
    put(Robots.arm());
    assertEquals(
        List.of("chain arm", "arm/arm_1", "arm/arm_2", "arm/arm_3", "arm/arm_4", "arm/arm_5", "arm/arm_6", "arm/arm_7",
            "chain gripper", "gripper/finger", "chain ", "/turntable"),
        keys("", Set.of(), Sorting.CHAIN));
  }

  @Test
  void withoutAModelThereAreNoHeadings() {
    control.put(Robots.arm());
    model.tick(0);
    assertEquals(9, keys("", Set.of(), Sorting.CHAIN).size());
    assertTrue(model.look().note().contains("limits not known"));
  }

  @Test
  void closedChainsKeepTheirHeading() {
    put(Robots.arm());
    assertEquals(List.of("chain arm", "chain gripper", "gripper/finger", "chain ", "/turntable"),
        keys("", Set.of("arm"), Sorting.CHAIN));
  }

  @Test
  void sortingStaysInsideTheChain() {
    put(Robots.arm());
    Sorting down = Sorting.CHAIN.clicked(JointColumn.POSITION).clicked(JointColumn.POSITION);
    List<String> keys = keys("", Set.of(), down);
    assertEquals("arm/arm_6", keys.get(1));
    assertEquals("arm/arm_4", keys.get(7));
    assertEquals("chain gripper", keys.get(8));
    assertEquals(Sorting.CHAIN, down.clicked(JointColumn.POSITION));
  }

  @Test
  void theFilterFindsOwnersSourcesAndFaults() {
    put(Robots.troubled());
    assertEquals(List.of("chain arm", "arm/arm_2", "arm/arm_3", "arm/arm_4"), keys("homing", Set.of(), Sorting.CHAIN));
    assertEquals(List.of("chain arm", "arm/arm_4"), keys("fault safe", Set.of(), Sorting.CHAIN));
    assertTrue(keys("nothing like it", Set.of(), Sorting.CHAIN).isEmpty());
  }

  @Test
  void aHeadingTellsTheWorst() {
    put(Robots.troubled());
    ChainHead head = (ChainHead) Lines.of(model.look(), "", Set.of(), Sorting.CHAIN).getFirst();
    assertEquals(Health.BAD, head.health());
    assertEquals("7 joints, 2 in safe state, 1 holding, 3 commanded, 1 free, 1 fault", head.words());
  }

  @Test
  void aFaultIsToldInBits() {
    put(Robots.troubled());
    JointRow row = row("arm/arm_4");
    assertEquals("0x24", row.faults());
    assertEquals("The hardware reports fault 0x24, bits 2, 5", row.faultSentence());
    assertEquals(Health.BAD, row.health());
  }

  @Test
  void figuresAreInDegreesButForSlidingJoints() {
    put(Robots.arm());
    assertEquals("17.8\u00b0", JointColumn.POSITION.text(row("arm/arm_1")));
    assertEquals("0.0213\u00a0m", JointColumn.POSITION.text(row("gripper/finger")));
    assertEquals("\u2014",
        JointColumn.POSITION.text(new JointRow("", Robots.armModel().joints().get(5), Robots.troubled().joints().get(5),
            Optional.empty(), new Measure(JointModel.Type.REVOLUTE, true))));
  }

  @Test
  void typedNumbersAreReadInTheShownUnit() throws Unreadable {
    Measure turning = new Measure(JointModel.Type.REVOLUTE, true);
    assertEquals(Math.PI / 2, turning.read(" 90\u00b0"), 1e-12);
    assertEquals(-0.5, new Measure(JointModel.Type.REVOLUTE, false).read("\u22120,5"));
    assertEquals(0.02, new Measure(JointModel.Type.PRISMATIC, true).read("0.02"));
    assertEquals("is no finite number", fault(turning, "NaN"));
    assertEquals("is too large", fault(turning, "1e999"));
    assertEquals("is no number", fault(turning, "left"));
    assertEquals("is no number", fault(new Measure(JointModel.Type.PRISMATIC, true), "90\u00b0"));
  }

  private static String fault(Measure measure, String typed) {
    return assertThrows(Unreadable.class, () -> measure.read(typed)).getMessage();
  }

  @Test
  void aJointWithoutLimitsHasAnOpenBar() {
    Span span = Span.of(Robots.armModel().joints().getLast());
    assertFalse(span.limited());
    assertEquals(7.5, span.within(7.5));
    assertEquals(0.5, span.share(0));
    assertFalse(span.isAtLimit(Math.PI));
  }

  @Test
  void whatMattersLeastGoesFirst() {
    assertEquals(JointColumn.values().length, Grid.of(1600, true, 0).places().size());
    Grid narrow = Grid.of(340, false, 0);
    assertEquals(List.of(JointColumn.NAME, JointColumn.RANGE, JointColumn.POSITION),
        List.copyOf(narrow.places().keySet()));
    Grid.Place last = narrow.places().get(JointColumn.POSITION);
    assertTrue(last.left() + last.width() <= 340);
  }

  @Test
  void longNamesAreWholeAndOtherColumnsGoFirst() {
    Grid usual = Grid.of(760, false, 0);
    Grid named = Grid.of(760, false, 230);

    assertTrue(usual.places().get(JointColumn.NAME).width() < 230);
    assertTrue(named.places().get(JointColumn.NAME).width() >= 230);
    assertTrue(usual.find(JointColumn.VELOCITY).isPresent());
    assertEquals(Optional.empty(), named.find(JointColumn.VELOCITY));
    assertTrue(Grid.of(1600, true, 4000).places().get(JointColumn.NAME).width() < 700);
    Grid narrow = Grid.of(380, false, 230);
    assertTrue(narrow.find(JointColumn.POSITION).isPresent());
    assertEquals(380, narrow.places().values().stream().mapToInt(Grid.Place::width).sum(), 2);
  }

  @Test
  void whatIsNotConnectedAnyMoreIsNotShown() {
    put(Robots.arm());
    control.state(new InputState.Unconnected("gone"));
    model.tick(0);
    assertTrue(model.look().joints().byName().isEmpty());
  }

  private void put(JointControl state) {
    described.put(Robots.armModel());
    control.put(state);
    model.tick(0);
  }

  private JointRow row(String key) {
    return Lines.of(model.look(), "", Set.of(), Sorting.CHAIN).stream().filter(line -> line.key().equals(key))
        .map(JointRow.class::cast)
        .findFirst().orElseThrow();
  }

  private List<String> keys(String words, Set<String> closed, Sorting sorting) {
    return Lines.of(model.look(), words, closed, sorting).stream().map(JointLine::key).toList();
  }
}
