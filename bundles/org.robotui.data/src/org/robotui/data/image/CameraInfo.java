package org.robotui.data.image;

import org.robotui.data.Data;
import org.robotui.data.Delivery;
import org.robotui.data.FrameId;
import org.robotui.data.InFrame;
import org.robotui.data.array.Doubles;
import org.robotui.data.internal.Check;

/**
 * The calibration of a camera.
 *
 * @param frame optical frame
 * @param width pixels a row at full resolution
 * @param height rows
 * @param distortionModel for example {@code plumb_bob}, empty where unknown
 * @param distortion coefficients of that model
 * @param intrinsics 3 x 3 matrix, row by row, pixels; all zero where uncalibrated
 * @param rectification 3 x 3 rotation, row by row
 * @param projection 3 x 4 matrix, row by row, pixels
 */
@Delivery(expires = false)
public record CameraInfo(
    FrameId frame,
    int width,
    int height,
    String distortionModel,
    Doubles distortion,
    Doubles intrinsics,
    Doubles rectification,
    Doubles projection)
    implements Data, InFrame {
  private static final int SQUARE = 9;
  private static final int WIDE = 12;

  /**
   * Checks the sizes.
   *
   * @param frame optical frame
   * @param width pixels
   * @param height pixels
   * @param distortionModel name
   * @param distortion coefficients
   * @param intrinsics 9 numbers
   * @param rectification 9 numbers
   * @param projection 12 numbers
   */
  public CameraInfo {
    Check.notNegative(width, "width");
    Check.notNegative(height, "height");
    Check.sizeIs(intrinsics.size(), SQUARE, "intrinsics");
    Check.sizeIs(rectification.size(), SQUARE, "rectification");
    Check.sizeIs(projection.size(), WIDE, "projection");
  }
}
