package org.robotui.entity.path.internal.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.navigation.Path;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Part;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;

class PathDisplayTest {
  private static final RigidTransform AHEAD = RigidTransform.planar(2, 0, 0);

  private final DisplayProbe path = new DisplayProbe(new PathType());
  private final DisplayProbe poses = new DisplayProbe(new PoseArrayType());

  @Test
  void aWayIsALineAndSaysItsLength() {
    DisplayResult result =
        path.tick(way(RigidTransform.IDENTITY, RigidTransform.planar(3, 4, 0), RigidTransform.planar(3, 5, 0)));
    assertEquals(2, result.parts().getFirst().shape().elements());
    assertEquals(new DisplayStatus.Shown("6.00 m, 3 poses"), result.status());
    assertSame(result.parts().getFirst().shape(), path.parts().getFirst().shape());
    assertTrue(result.parts().getFirst().describer().describe(1, Vector3.ZERO).toString().contains("4.000 m"));
    assertEquals("path", result.parts().getFirst().describer().describe(9, Vector3.ZERO).title());
  }

  @Test
  void posesAreArrowsOrAxes() {
    Path way = way(RigidTransform.IDENTITY, AHEAD);
    Instances arrows = (Instances) path.set("poses", "arrows").parts(way).get(1).shape();
    assertSame(Meshes.arrow(), arrows.mesh());
    assertEquals(1, arrows.placings().get(16), "not turned");
    assertSame(Meshes.axes(), ((Instances) path.set("poses", "axes").parts().get(1).shape()).mesh());
  }

  @Test
  void anEmptyPathIsTaken() {
    assertEquals(new DisplayStatus.Shown("no path"), path.tick(way()).status());
  }

  @Test
  void aWayMovesWithItsFrame() {
    path.tick(way(RigidTransform.IDENTITY, RigidTransform.IDENTITY));
    path.places().put("odom", RigidTransform.planar(7, 0, 0));
    path.tick(new Path(FakePlaces.frame("odom"), List.of(RigidTransform.IDENTITY)));
    path.places().put("odom", RigidTransform.planar(8, 0, 0));
    assertEquals(8, path.parts().getFirst().fixedFromShape().translation().x());
    path.close();
  }

  @Test
  void manyPosesAreInstancesOfOneArrow() {
    Part part =
        poses.parts(new PoseArray(FakePlaces.frame("map"), Collections.nCopies(5000, RigidTransform.planar(1, 2, 0))))
            .getFirst();
    assertEquals(5000, part.shape().elements());
    assertSame(part.shape(), poses.parts().getFirst().shape());
    assertTrue(part.describer().describe(4999, Vector3.ZERO).title().contains("4999"));
  }

  @Test
  void posesAreBounded() {
    DisplayResult many = poses.tick(
        new PoseArray(FakePlaces.frame("map"), Collections.nCopies(PoseShapes.MOST + 1, RigidTransform.IDENTITY)));
    assertInstanceOf(DisplayStatus.Partly.class, many.status());
    assertEquals(PoseShapes.MOST, many.parts().getFirst().shape().elements());
    Part part = poses.parts(new PoseArray(FakePlaces.frame("map"), List.of(AHEAD))).getFirst();
    assertEquals(1, part.shape().elements());
    assertTrue(part.describer().describe(0, Vector3.ZERO).toString().contains("2.000 m"));
    assertEquals("0 poses", poses.tick(new PoseArray(FakePlaces.frame("map"), List.of())).status().words());
    poses.close();
  }

  private static Path way(RigidTransform... poses) {
    return new Path(FakePlaces.frame("map"), List.of(poses));
  }
}
