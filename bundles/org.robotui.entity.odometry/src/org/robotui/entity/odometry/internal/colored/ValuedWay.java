package org.robotui.entity.odometry.internal.colored;

import java.util.Arrays;
import org.robotui.data.FrameId;
import org.robotui.geometry.Vector3;
import org.robotui.ui.scene.PositionHistory;

/** Collects places with a value at each; a long way stays whole with fewer of them. Not safe for several threads. */
final class ValuedWay {
  private static final int CAPACITY = 4000;
  private static final double FINEST = 0.02;

  private final double[] heights = new double[CAPACITY];
  private final double[] values = new double[CAPACITY];
  private final PositionHistory places = new PositionHistory(CAPACITY, FINEST, this::moved);

  /** Adds one where it is not near to the newest; true where it was added. */
  boolean add(Vector3 place, double value) {
    if (!place.isFinite() || places.near(place.x(), place.y())) {
      return false;
    }
    int index = places.add(place.x(), place.y());
    heights[index] = place.z();
    values[index] = value;
    return true;
  }

  /** Forgets what lies further back than so many metres. */
  void cut(double length) {
    places.cut(length);
  }

  void clear() {
    places.clear();
  }

  WayPoints points(FrameId frame) {
    double[] xy = places.points();
    double[] xyz = new double[3 * places.count()];
    for (int i = 0; i < places.count(); i++) {
      xyz[3 * i] = xy[2 * i];
      xyz[3 * i + 1] = xy[2 * i + 1];
      xyz[3 * i + 2] = heights[i];
    }
    return new WayPoints(frame, xyz, Arrays.copyOf(values, places.count()));
  }

  private void moved(int from, int to, int count) {
    System.arraycopy(heights, from, heights, to, count);
    System.arraycopy(values, from, values, to, count);
  }
}
