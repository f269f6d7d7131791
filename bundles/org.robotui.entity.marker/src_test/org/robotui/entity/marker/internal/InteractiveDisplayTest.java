package org.robotui.entity.marker.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.junit.jupiter.api.Test;
import org.robotui.api.command.CommandOutcome;
import org.robotui.data.Data;
import org.robotui.data.marker.InteractiveMarker;
import org.robotui.data.marker.InteractiveMarker.Control;
import org.robotui.data.marker.InteractiveMarker.MenuEntry;
import org.robotui.data.marker.InteractiveMarker.Mode;
import org.robotui.data.marker.InteractiveMarker.Orientation;
import org.robotui.data.marker.InteractiveMarkerSet;
import org.robotui.data.marker.Marker;
import org.robotui.data.marker.MarkerFeedback;
import org.robotui.data.marker.MarkerFeedback.Event;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.Handle;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Ray;

class InteractiveDisplayTest {
  private static final Vector3 HIT = new Vector3(1.5, 0, 0);
  private final Ticks scene = new Ticks(InteractiveType.SCHEMA);
  private final List<MarkerFeedback> sent = new ArrayList<>();
  private Optional<String> refusal = Optional.empty();
  private final InteractiveDisplay display = new InteractiveDisplay(new DisplayContext() {
    @Override
    public Executor background() {
      return Runnable::run;
    }

    @Override
    public void wake() {
      // the test ticks by itself
    }

    @Override
    public CommandOutcome send(Data command) {
      sent.add((MarkerFeedback) command);
      return refusal.<CommandOutcome>map(r -> new CommandOutcome.Refused(CommandOutcome.Why.NO_LEASE, r))
          .orElse(new CommandOutcome.Accepted());
    }
  });

  private static Control control(Mode mode, List<Marker> look) {
    return new Control(mode.name(), "", mode, Orientation.INHERIT, Quaternion.IDENTITY, true, look, false);
  }

  private static InteractiveMarker marker(double x, Control... controls) {
    return new InteractiveMarker("goal", "the goal", "/goals/feedback", Ticks.frame("map"), Optional.empty(),
        RigidTransform.planar(x, 0, 0), 1,
        List.of(new MenuEntry(1, 0, "Drive"), new MenuEntry(2, 1, "[x] Slowly"), new MenuEntry(3, 1, "[ ] Fast")),
        List.of(controls));
  }

  private DisplayResult says(InteractiveMarker marker) {
    return display.update(scene
        .of(new InteractiveMarkerSet(false, List.of(new InteractiveMarkerSet.Entry("goal", Optional.of(marker))))));
  }

  private static Handle handle(DisplayResult result) {
    return result.parts().stream().flatMap(p -> p.handle().stream()).findFirst().orElseThrow();
  }

  private static Ray down(double x) {
    return new Ray(new Vector3(x, 0, 10), new Vector3(0, 0, -1));
  }

  private double shownAt() {
    return display.update(scene.of()).parts().getFirst().fixedFromShape().translation().x();
  }

  private List<Event> events() {
    return sent.stream().map(MarkerFeedback::event).toList();
  }

  @Test
  void aDragMovesItAtOnceAndTheServerHearsOfEachTick() {
    Handle handle = handle(says(marker(1, control(Mode.MOVE_AXIS, List.of()))));
    handle.press(down(1.5), HIT);
    handle.drag(down(2));
    handle.drag(down(2.5));
    assertEquals(2, shownAt());
    assertEquals(List.of(Event.MOUSE_DOWN, Event.POSE_UPDATE), events());
    assertEquals(2, sent.getLast().pose().translation().x());
    assertEquals("/goals/feedback", sent.getLast().topic());
    assertEquals(Optional.of(HIT), sent.getFirst().point());
    scene.now += 300_000_000L;
    display.update(scene.of());
    assertEquals(Event.KEEP_ALIVE, sent.getLast().event(), "still held");
    handle.release(false);
    assertEquals(Event.MOUSE_UP, sent.getLast().event());
    assertEquals(2, shownAt(), "where it was put, until the server says else");
  }

  @Test
  void whatTheServerSaysDuringADragCountsAtItsEnd() {
    Handle handle = handle(says(marker(1, control(Mode.MOVE_AXIS, List.of()))));
    handle.press(down(1.5), HIT);
    handle.drag(down(3.5));
    display.update(scene.of());
    says(marker(2.5, control(Mode.MOVE_AXIS, List.of())));
    assertEquals(3, shownAt());
    handle.release(false);
    assertEquals(2.5, shownAt());
    says(marker(7, control(Mode.MOVE_AXIS, List.of())));
    assertEquals(7, shownAt());
  }

  @Test
  void whereTheRobotIsNotAskedItGoesBackAndSaysWhy() {
    Handle handle = handle(says(marker(1, control(Mode.MOVE_AXIS, List.of()))));
    refusal = Optional.of("somebody else has the lease");
    handle.press(down(1.5), HIT);
    handle.drag(down(3.5));
    display.update(scene.of());
    handle.release(false);
    assertEquals(1, shownAt());
    DisplayStatus.Partly status = assertInstanceOf(DisplayStatus.Partly.class, display.update(scene.of()).status());
    assertEquals("not told to the robot: somebody else has the lease", status.words());
  }

  @Test
  void aClickOnAButtonIsAClick() {
    Handle handle = handle(says(marker(1, control(Mode.BUTTON, List.of()))));
    handle.press(down(1), HIT);
    handle.release(true);
    assertEquals(List.of(Event.MOUSE_DOWN, Event.MOUSE_UP, Event.BUTTON_CLICK), events());
    handle.release(true);
    assertEquals(3, sent.size(), "let go once");
  }

  @Test
  void itsMenuIsATreeWithTicksAndAChoiceIsTold() {
    Handle handle = handle(says(marker(1, control(Mode.MENU, List.of()))));
    List<Handle.Choice> menu = handle.menu();
    assertEquals("Drive", menu.getFirst().label());
    assertEquals(List.of(true, false), menu.getFirst().children().stream().map(Handle.Choice::checked).toList());
    assertEquals("Slowly", menu.getFirst().children().getFirst().label());
    handle.choose(3);
    assertEquals(Event.MENU_SELECT, sent.getFirst().event());
    assertEquals(3, sent.getFirst().menuEntry());
  }

  @Test
  void aMovedMarkerKeepsItsShapesAndItsHandle() {
    InteractiveMarker marker =
        marker(1, control(Mode.MOVE_PLANE, List.of(Sample.of(0, Marker.Type.CUBE).frame("", false).made(0))));
    Part before = says(marker).parts().getFirst();
    Part after = says(marker.at(marker.frame(), Optional.empty(), RigidTransform.planar(5, 0, 0))).parts().getFirst();
    assertSame(before.shape(), after.shape());
    assertSame(before.handle().orElseThrow(), after.handle().orElseThrow());
    assertEquals(before.key(), after.key());
    assertEquals(5, after.fixedFromShape().translation().x());
  }

  @Test
  void everyModeCanBeGrippedAndLooksLikeSomething() {
    for (Mode mode : Mode.values()) {
      DisplayResult result = says(marker(1, control(mode, List.of())));
      assertEquals(mode != Mode.NONE, result.parts().stream().anyMatch(p -> p.handle().isPresent()), mode.name());
    }
  }

  @Test
  void itSaysWhatIsMissing() {
    assertEquals(new DisplayStatus.Shown("there are no interactive markers now"), display.update(scene.of()).status());
    scene.frames.clear();
    assertEquals(new DisplayStatus.NoFrame("no transform from map to map"),
        says(marker(1, control(Mode.BUTTON, List.of()))).status());
    scene.frames.put("map", RigidTransform.IDENTITY);
    assertEquals(new DisplayStatus.Shown("1 interactive marker"), display.update(scene.of()).status());
    says(marker(Double.NaN, control(Mode.BUTTON, List.of())));
    assertTrue(display.update(scene.of()).status().words().contains("not finite"));
    display.update(scene.of(new InteractiveMarkerSet(true, List.of())));
    assertEquals(0, display.update(scene.of()).parts().size());
  }
}
