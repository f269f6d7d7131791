package org.robotui.entity.path.internal.display;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.navigation.Path;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Eye;
import org.robotui.gl.shape.Part;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;

/** How ways and many poses look. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class PathPicturesTest {
  @AutoClose
  private static final ScenePictures PICTURES = new ScenePictures();

  private static final Eye EYE = ScenePictures.eye(new Vector3(-0.4, 0.3, 1.6), new Vector3(0.75, 0.65, 0));

  private static void show(String name, List<Part> parts) {
    PICTURES.assertLike(PathPicturesTest.class, name, ScenePictures.request(ScenePictures.withAxes(parts, 0.5), EYE));
  }

  /** A quarter of a circle that starts along x and turns to the left. */
  private static List<RigidTransform> turn() {
    return IntStream.rangeClosed(0, 12).mapToObj(i -> i * Math.PI / 24)
        .map(a -> RigidTransform.planar(1.5 * Math.sin(a), 1.5 - 1.5 * Math.cos(a), a))
        .toList();
  }

  @Test
  void aWayIsALine() {
    try (DisplayProbe probe = new DisplayProbe(new PathType())) {
      show("path", probe.parts(new Path(FakePlaces.frame("map"), turn())));
    }
  }

  @Test
  void aWayShowsItsPoses() {
    try (DisplayProbe probe = new DisplayProbe(new PathType())) {
      show("path-axes", probe.set("poses", "axes").parts(new Path(FakePlaces.frame("map"), turn())));
    }
  }

  @Test
  void posesAreArrowsAlongX() {
    try (DisplayProbe probe = new DisplayProbe(new PoseArrayType())) {
      probe.places().put("odom", RigidTransform.planar(0, 0.3, 0));
      show("poses", probe.set("length", 0.14).parts(new PoseArray(FakePlaces.frame("odom"), turn())));
    }
  }
}
