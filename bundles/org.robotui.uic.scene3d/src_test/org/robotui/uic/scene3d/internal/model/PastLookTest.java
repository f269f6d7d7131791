package org.robotui.uic.scene3d.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.robotui.testkit.KeptHistory.BEGIN;
import static org.robotui.testkit.KeptHistory.SECOND;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.api.time.PointedTime;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.Places;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Rgba;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.KeptHistory;
import org.robotui.testkit.KeptTimeline;
import org.robotui.uic.scene3d.internal.SceneOptions;
import org.robotui.uic.scene3d.internal.ScenePorts;

class PastLookTest {
  private static final SourceId ODOM = new SourceId("base", "odom");
  private static final FrameId FRAME = new FrameId("Keira", "odom");
  private static final Rgba BLUE = new Rgba(0, 0, 1, 1);
  /** The frame of odometry lies ten metres to the left of the fixed frame. */
  private static final RigidTransform MAP_FROM_ODOM = RigidTransform.planar(0, 10, 0);

  private final FakeUicContext context = new FakeUicContext("scene", SceneOptions.schema());
  private final FakeInput<Data> input = context.input(ScenePorts.DATA);
  private final KeptHistory history = new KeptHistory(new KeptTimeline());
  private final PointedTime pointed = context.pointed();
  private final PastLook look = new PastLook(context);
  private boolean placed = true;

  private List<Part> at(double seconds) {
    pointed.point(this, BEGIN + Math.round(seconds * SECOND));
    parts(); // has the recording read
    return parts();
  }

  private List<Part> parts() {
    return look.parts(new OnePlace(), robot -> BLUE);
  }

  private void drive() {
    for (int second = 0; second <= 10; second++) {
      history.add("odom", second, new Odometry(FRAME, new FrameId("Keira", "base_link"),
          RigidTransform.planar(second, 2, Math.PI / 2), Doubles.EMPTY, Vector3.ZERO, Vector3.ZERO, Doubles.EMPTY));
    }
    input.history(ODOM, history);
    input.candidates(List.of(new Input.Candidate(ODOM, "Odometry"), new Input.Candidate(new SourceId("base", "scan"),
        "LaserScan")));
  }

  @Test
  void theArrowStandsInItsRingWhereTheRobotWas() {
    drive();

    List<Part> parts = at(4);

    assertEquals(List.of("way Keira", "then Keira", "around Keira"), parts.stream().map(Part::key).toList());
    Vector3 arrow = parts.get(1).fixedFromShape().translation();
    assertEquals(4, arrow.x(), 1e-6);
    assertEquals(12, arrow.y(), 1e-6);
    assertEquals(Math.PI / 2, parts.get(1).fixedFromShape().rotation().yaw(), 1e-6);
    assertEquals(parts.get(1).fixedFromShape(), parts.get(2).fixedFromShape());
  }

  @Test
  void theWayIsMadeOnceAndTheArrowMovesOnIt() {
    drive();

    Part before = at(2).getFirst();
    Part after = at(8).getFirst();

    assertSame(before.shape(), after.shape());
    assertEquals(before.fixedFromShape(), after.fixedFromShape());
    assertEquals(8, at(8).get(1).fixedFromShape().translation().x(), 1e-6);
  }

  @Test
  void nothingIsShownWhileNobodyPointsOrItsFrameIsNowhere() {
    drive();
    assertEquals(List.of(), parts());
    at(3);
    placed = false;
    assertEquals(List.of(), parts());
    placed = true;
    pointed.leave(this);
    assertEquals(List.of(), parts());
  }

  private final class OnePlace implements Places {
    @Override
    public FrameId fixed() {
      return new FrameId("Keira", "map");
    }

    @Override
    public Place at(FrameId frame, Optional<Stamp> stamp) {
      return placed ? new Place.At(MAP_FROM_ODOM) : new Place.Missing("nothing links it to the map");
    }

    @Override
    public List<FrameId> all() {
      return List.of(fixed(), FRAME);
    }

    @Override
    public Optional<FrameId> parent(FrameId frame) {
      return Optional.empty();
    }
  }
}
