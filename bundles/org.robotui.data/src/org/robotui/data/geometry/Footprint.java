package org.robotui.data.geometry;

import java.util.List;
import org.robotui.data.Data;
import org.robotui.data.Delivery;
import org.robotui.data.FrameId;
import org.robotui.data.InFrame;
import org.robotui.data.internal.Check;
import org.robotui.geometry.Vector3;

/**
 * The outline of a robot on the floor.
 *
 * @param frame frame of the corners
 * @param corners at least three, metres, counter-clockwise
 */
@Delivery(expires = false)
public record Footprint(FrameId frame, List<Vector3> corners) implements Data, InFrame {
  private static final int TRIANGLE = 3;

  /**
   * Checks the corners.
   *
   * @param frame the frame
   * @param corners at least three
   */
  public Footprint {
    corners = List.copyOf(corners);
    Check.that(corners.size() >= TRIANGLE, "corners", "an outline has at least three, not " + corners.size());
    for (Vector3 corner : corners) {
      Check.place(corner, "corners");
    }
  }
}
