package org.robotui.entity.grid.internal.display;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Part;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;
import org.robotui.testkit.display.DisplayProbe;

/** How grids and coordinate systems look. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class GridPicturesTest {
  @AutoClose
  private static final ScenePictures PICTURES = new ScenePictures();

  @Test
  void aGridLiesUnderTheFixedFrame() {
    try (DisplayProbe probe = new DisplayProbe(new GridType())) {
      PICTURES.assertLike(GridPicturesTest.class, "grid", ScenePictures.request(
          ScenePictures.withAxes(probe.set("cells", 6L).parts(), 1),
          ScenePictures.eye(new Vector3(-4.4, -4.4, 3.6), new Vector3(-0.4, -0.4, 0))));
    }
  }

  @Test
  void aGridStandsWhereItIsSaidTo() {
    try (DisplayProbe probe = new DisplayProbe(new GridType())) {
      probe.set("cells", 4L).set("cell", 0.5).set("plane", "xz").set("y", 2.0).set("z", 1.0).set("color", "#e5484dff")
          .set("width", 2.0);
      PICTURES.assertLike(GridPicturesTest.class, "grid-upright", ScenePictures.request(
          ScenePictures.withAxes(probe.parts(), 1),
          ScenePictures.eye(new Vector3(-1.8, -1.6, 1.7), new Vector3(0.1, 1, 0.7)), ScenePictures.LIGHT));
    }
  }

  @Test
  void axesAreWhereTheirFrameIsAndSayItsName() {
    try (DisplayProbe fixed = new DisplayProbe(new AxesType()); DisplayProbe moved = new DisplayProbe(new AxesType())) {
      moved.places().put("base_link",
          new RigidTransform(new Vector3(1, 0.5, 0.3), Quaternion.fromRollPitchYaw(0, 0, Math.PI / 2)));
      List<Part> parts = new ArrayList<>(fixed.set("length", 1.0).parts());
      List<Part> other = moved.set("frame", "base_link").set("label_color", "#f5b83d").parts();
      other.forEach(
          p -> parts.add(new Part("moved " + p.key(), p.shape(), p.fixedFromShape(), p.material(), p.describer())));
      PICTURES.assertLike(GridPicturesTest.class, "axes",
          ScenePictures.request(parts, ScenePictures.eye(new Vector3(-0.7, -1.5, 1.4), new Vector3(0.5, 0.3, 0.45))));
    }
  }
}
