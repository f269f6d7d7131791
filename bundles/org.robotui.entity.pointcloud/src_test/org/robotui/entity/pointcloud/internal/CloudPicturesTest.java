package org.robotui.entity.pointcloud.internal;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.sensor.PointCloud;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Eye;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;
import org.robotui.testkit.display.DisplayProbe;

/** How clouds look. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class CloudPicturesTest {
  @AutoClose
  private static final ScenePictures PICTURES = new ScenePictures();

  private static final int EDGE = 40;
  private static final Eye EYE = ScenePictures.eye(new Vector3(-2, -1.6, 1.8), new Vector3(0.3, 0.1, 0.3));

  private final DisplayProbe probe = new DisplayProbe(new PointCloudType());

  CloudPicturesTest() {
    probe.places().put("lidar", new RigidTransform(new Vector3(0, 0, 0.5), Quaternion.fromYaw(Math.PI / 2)));
  }

  /**
   * A square of 2 m that rises along its own x from 0 to 1 m, which is y of the fixed frame: the fourth field counts
   * its rows along its own y, or is a colour that gets red along x and green along y.
   */
  private static PointCloud slope(String fourth) {
    ByteBuffer bytes = ByteBuffer.allocate(16 * EDGE * EDGE).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < EDGE; i++) {
      for (int j = 0; j < EDGE; j++) {
        bytes.putFloat(2f * i / EDGE - 1).putFloat(2f * j / EDGE - 1).putFloat((float) i / EDGE);
        if (fourth.equals("rgb")) {
          bytes.putInt(255 * i / EDGE << 16 | 255 * j / EDGE << 8 | 64);
        } else {
          bytes.putFloat(j);
        }
      }
    }
    return Clouds.plain(EDGE * EDGE, bytes, fourth);
  }

  private void show(String name, PointCloud cloud) {
    PICTURES.assertLike(CloudPicturesTest.class, name,
        ScenePictures.request(ScenePictures.withAxes(probe.parts(cloud), 1), EYE));
    probe.close();
  }

  @Test
  void heightColours() {
    probe.set("color_by", "axis").set("axis", "z").set("size", 3.0);
    show("axis", slope("intensity"));
  }

  @Test
  void aFieldColours() {
    probe.set("color_by", "field").set("field", "ring").set("size", 3.0).set("min", 10.0).set("max", 30.0);
    show("field", slope("ring"));
  }

  @Test
  void pointsHaveColoursOfTheirOwn() {
    probe.set("size", 3.0);
    show("rgb", slope("rgb"));
  }

  @Test
  void pointsOfMetresAreSmallerFarAway() {
    probe.set("color_by", "flat").set("unit", "metres").set("style", "disc").set("size", 0.04);
    show("metres", slope("intensity"));
  }
}
