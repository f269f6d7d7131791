package org.robotui.uic.camera.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.image.CameraInfo;

class BearingTest {
  @Test
  void theOpticalAxisIsStraightAhead() {
    Bearing middle = Bearing.of(info(320), 319, 239, 640, 480).orElseThrow();
    assertEquals(0, middle.right(), 0.002);
    assertEquals(0, middle.down(), 0.002);
  }

  @Test
  void aPictureOfHalfTheSizeHasTheSameDirections() {
    Bearing edge = Bearing.of(info(320), 319, 119, 320, 240).orElseThrow();
    assertEquals(Math.PI / 4, edge.right(), 0.002);
    assertEquals("44.9\u00b0 right, 0.2\u00b0 up", edge.text());
  }

  @Test
  void anUncalibratedCameraHasNone() {
    assertEquals(Optional.empty(), Bearing.of(info(0), 10, 10, 640, 480));
  }

  private static CameraInfo info(double focal) {
    return new CameraInfo(new FrameId("Keira", "camera"), 640, 480, "plumb_bob", Doubles.EMPTY,
        Doubles.of(focal, 0, 320, 0, focal, 240, 0, 0, 1), Doubles.of(new double[9]), Doubles.of(new double[12]));
  }
}
