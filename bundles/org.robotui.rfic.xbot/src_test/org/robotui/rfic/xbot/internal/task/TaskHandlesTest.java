package org.robotui.rfic.xbot.internal.task;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.joint.DisplayedTrajectory;
import org.robotui.data.joint.Trajectory;
import org.robotui.data.marker.InteractiveMarker;
import org.robotui.data.marker.InteractiveMarker.Mode;
import org.robotui.data.marker.InteractiveMarkerSet;
import org.robotui.data.marker.MarkerFeedback;
import org.robotui.data.marker.MarkerFeedback.Event;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.xbot.Board;

class TaskHandlesTest implements HandleSite {
  private static final FrameId BASE = new FrameId("Six", "base");
  private static final long TURN = 250_000_000;

  private final ScriptedTasks control = new ScriptedTasks();
  private final List<Trajectory> plans = new ArrayList<>();
  private InteractiveMarkerSet shown = new InteractiveMarkerSet(true, List.of());
  private long now;
  private final TaskHandles handles =
      new TaskHandles("Six", SixJoints.MODEL, control, this, work -> new Thread(() -> {}), () -> now);

  @Override
  public boolean wanted() {
    return true;
  }

  @Override
  public void handles(InteractiveMarkerSet all) {
    shown = all;
  }

  @Override
  public void plan(Trajectory plan) {
    plans.add(plan);
  }

  private void turn(MarkerFeedback... said) {
    now += TURN;
    handles.turn(List.of(said));
  }

  private InteractiveMarker handle() {
    assertEquals(1, shown.entries().size());
    return shown.entries().getFirst().marker().orElseThrow();
  }

  private static MarkerFeedback said(Event event, String control, RigidTransform pose, int entry) {
    return new MarkerFeedback(HandledTask.TOPIC, "me", "Arm/hand", control, event, BASE, Optional.empty(), pose, entry,
        Optional.empty());
  }

  private RigidTransform beside(double x, double y) {
    RigidTransform pose = handle().pose();
    return new RigidTransform(pose.translation().plus(new Vector3(x, y, 0)), pose.rotation());
  }

  private int points() {
    return ((DisplayedTrajectory) plans.getLast()).parts().stream().mapToInt(part -> part.points().size()).sum();
  }

  private boolean isButton(InteractiveMarker marker) {
    return marker.controls().stream().anyMatch(c -> c.mode() == Mode.BUTTON);
  }

  @Test
  void aDraggedHandleIsPlannedAndNothingMovesUntilTheUserSaysSo() {
    turn();
    assertEquals(BASE, handle().frame());
    RigidTransform target = beside(0.05, 0.1);

    turn(said(Event.MOUSE_DOWN, "move_x", handle().pose(), 0), said(Event.POSE_UPDATE, "move_x", target, 0),
        said(Event.MOUSE_UP, "move_x", target, 0));

    assertEquals(target, handle().pose());
    assertTrue(points() > 10 && isButton(handle()), () -> handle().description());
    assertTrue(control.orders().isEmpty());

    turn(said(Event.BUTTON_CLICK, "go", target, 0));
    assertTrue(control.orders().remove().startsWith("command Arm pose hand "));
    control.phase("moving");
    turn();
    assertTrue(!isButton(handle()) && handle().pose().equals(target));
    assertEquals("hand is moving", handle().description());
    control.phase("there");
    turn();
    turn();
    assertEquals(0, points());
    assertTrue(handle().menu().isEmpty());
  }

  @Test
  void whatIsTakenBackIsNotSent() {
    turn();
    RigidTransform before = handle().pose();
    turn(said(Event.POSE_UPDATE, "move_x", beside(0.1, 0), 0));
    assertEquals(List.of("Move (Enter)", "Take back (Esc)"),
        handle().menu().stream().map(InteractiveMarker.MenuEntry::title).toList());

    turn(said(Event.MENU_SELECT, "move_x", handle().pose(), HandledTask.BACK));

    assertEquals(before, handle().pose());
    assertEquals(0, points());
    assertTrue(control.orders().isEmpty());
  }

  @Test
  void outOfReachIsSaidAndMarked() {
    turn();
    turn(said(Event.POSE_UPDATE, "move_x", beside(3, 0), 0));

    assertTrue(handle().description().contains("out of reach by "), () -> handle().description());
    assertTrue(handle().controls().stream().anyMatch(c -> c.name().equals("missing")));
  }

  @Test
  void aTaskThatIsDisabledOrWhosePluginIsStoppedCannotBeGripped() {
    turn();
    turn(said(Event.POSE_UPDATE, "move_x", beside(0.1, 0), 0));
    control.state(Board.PluginState.STOPPED);
    turn();
    assertEquals("Arm is stopped", handle().description());
    assertTrue(handle().controls().stream().allMatch(c -> c.mode() == Mode.NONE) && handle().menu().isEmpty());
    assertEquals(0, points());

    turn(said(Event.MENU_SELECT, "move_x", handle().pose(), HandledTask.MOVE));
    assertTrue(control.orders().isEmpty());

    control.state(Board.PluginState.RUNNING);
    control.phase("disabled");
    turn();
    assertEquals("hand is disabled", handle().description());
  }

  @Test
  void whatIsNoAnswerHasNoTasks() {
    for (String text : List.of("", "x", "0 1\na", "0\na\tb\tc\t1\tthere\t11111\t1\t1",
        "0\na\tb\tc\t1\tgone\t111111\t1\t1", "0\na\tb\tc\t1\tthere\t111111\tNaN\t1")) {
      assertTrue(TaskAnswer.read("Arm", text).map(TaskAnswer::tasks).filter(t -> !t.isEmpty()).isEmpty(), text);
    }
  }
}
