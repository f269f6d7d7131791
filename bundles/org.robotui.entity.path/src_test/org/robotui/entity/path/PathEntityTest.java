package org.robotui.entity.path;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.navigation.Path;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.scene.Bounds;

class PathEntityTest {
  private static final FrameId MAP = new FrameId("Keira", "map");
  private final Path corner = new Path(MAP, List.of(at(0, 0), at(3, 0), at(3, 4)));

  @Test
  void whatIsLeftIsCountedFromTheRobot() {
    Line line = Line.of(corner, RigidTransform.IDENTITY).orElseThrow();
    assertEquals(7, line.length(), 1e-9);
    assertEquals(5, line.lengthFrom(3, -1), 1e-9);
  }

  @Test
  void theGoalSaysHowFarAndHowLong() {
    PathEntity entity = new PathEntity();
    entity.prepare(corner, RigidTransform.IDENTITY, Optional.of(new Vector3(3, 0, 0)), 0.5);
    assertTrue(entity.describeAt(3, 4, 0.1).orElseThrow().text().endsWith("goal  4.0\u00a0m  \u00b7  8\u00a0s"));
    entity.prepare(corner, RigidTransform.IDENTITY, Optional.empty(), 0);
    assertTrue(entity.describeAt(3, 4, 0.1).orElseThrow().text().endsWith("goal  7.0\u00a0m"));
  }

  @Test
  void aWayLiesInTheFixedFrame() {
    PathEntity entity = new PathEntity();
    entity.prepare(corner, RigidTransform.planar(10, 0, Math.PI / 2), Optional.empty(), 0);
    Bounds b = entity.bounds().orElseThrow();
    assertEquals(6, b.minX(), 1e-9);
    assertEquals(3, b.maxY(), 1e-9);
  }

  @Test
  void aWayWithoutPosesClears() {
    PathEntity entity = new PathEntity();
    entity.prepare(corner, RigidTransform.IDENTITY, Optional.empty(), 0);
    entity.prepare(new Path(MAP, List.of()), RigidTransform.IDENTITY, Optional.empty(), 0);
    assertTrue(entity.bounds().isEmpty());
  }

  private static RigidTransform at(double x, double y) {
    return RigidTransform.planar(x, y, 0);
  }
}
