package org.robotui.uic.camera.internal;

import java.util.Optional;
import org.robotui.data.array.Doubles;
import org.robotui.data.image.CameraInfo;
import org.robotui.ui.Figures;

/**
 * In which direction of a calibrated camera a pixel lies, lens distortion left aside.
 *
 * @param right radians to the right of the optical axis
 * @param down radians below it
 */
record Bearing(double right, double down) {
  private static final int FX = 0;
  private static final int CX = 2;
  private static final int FY = 4;
  private static final int CY = 5;

  /** The direction of a pixel's middle, for pictures of another size than the calibration too. */
  static Optional<Bearing> of(CameraInfo info, int x, int y, int width, int height) {
    Doubles k = info.intrinsics();
    if (!(k.get(FX) > 0) || !(k.get(FY) > 0) || info.width() <= 0 || info.height() <= 0) {
      return Optional.empty();
    }
    double column = (x + 0.5) * info.width() / width;
    double row = (y + 0.5) * info.height() / height;
    return Optional
        .of(new Bearing(Math.atan((column - k.get(CX)) / k.get(FX)), Math.atan((row - k.get(CY)) / k.get(FY))));
  }

  String text() {
    return Figures.degrees(Math.abs(right), 1) + (right < 0 ? " left, " : " right, ")
        + Figures.degrees(Math.abs(down), 1) + (down < 0 ? " up" : " down");
  }
}
