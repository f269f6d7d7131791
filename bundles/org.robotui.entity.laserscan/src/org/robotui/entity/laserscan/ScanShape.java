package org.robotui.entity.laserscan;

import java.util.Arrays;
import java.util.Optional;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.scene.Bounds;

/**
 * A scan in the fixed frame. The arrays are not changed after construction.
 *
 * @param scan the scan
 * @param echoes x and y of each echo in turn, metres
 * @param echoCount how many
 * @param beams the beam of each echo
 * @param fan corners of the space that the beams crossed: the scanner, then the ends of the beams
 * @param bounds of echoes and scanner
 */
record ScanShape(
    LaserScan scan, double[] echoes, int echoCount, int[] beams, double[] fan, Optional<Bounds> bounds) {
  /** More corners than this are not seen in a faint area, but cost. */
  private static final int FAN_CORNERS = 720;

  static ScanShape of(LaserScan scan, RigidTransform fixedFromScanner) {
    int count = scan.ranges().size();
    double[] echoes = new double[2 * count];
    int[] beams = new int[count];
    Vector3 origin = fixedFromScanner.translation();
    Bounds bounds = Bounds.around(origin.x(), origin.y(), 0);
    int found = 0;
    Beams axes = new Beams(fixedFromScanner);
    for (int beam = 0; beam < count; beam++) {
      if (scan.isEcho(beam)) {
        axes.end(scan.angle(beam), scan.ranges().get(beam), echoes, found);
        if (Double.isFinite(echoes[2 * found] + echoes[2 * found + 1])) { // else an angle beyond all numbers
          bounds = bounds.union(Bounds.around(echoes[2 * found], echoes[2 * found + 1], 0));
          beams[found++] = beam;
        }
      }
    }
    return new ScanShape(scan, echoes, found, Arrays.copyOf(beams, found), fan(scan, axes), Optional.of(bounds));
  }

  private static double[] fan(LaserScan scan, Beams axes) {
    int count = scan.ranges().size();
    int stride = Math.max(1, (count + FAN_CORNERS - 1) / FAN_CORNERS);
    int corners = (count + stride - 1) / stride;
    double[] fan = new double[2 * (corners + 1)];
    axes.end(0, 0, fan, 0);
    for (int corner = 0; corner < corners; corner++) {
      int first = corner * stride;
      int end = Math.min(count, first + stride);
      axes.end(scan.angle(first), shortest(scan, first, end), fan, corner + 1);
    }
    return fan;
  }

  /** The shortest of some neighbours, so that what is painted free was measured free. */
  private static double shortest(LaserScan scan, int from, int to) {
    double shortest = scan.rangeMax();
    for (int beam = from; beam < to; beam++) {
      shortest = Math.min(shortest, crossed(scan, beam));
    }
    return shortest;
  }

  /** How far a beam got: to its echo, to the limit where there was none, nowhere where nothing is known. */
  private static double crossed(LaserScan scan, int beam) {
    double range = scan.ranges().get(beam);
    if (scan.isEcho(beam)) {
      return range;
    }
    return range > scan.rangeMax() ? scan.rangeMax() : 0;
  }

  /** The ends of beams: the scanner's plane in the fixed frame, seen from above. */
  private static final class Beams {
    private final Vector3 origin;
    private final Vector3 ahead;
    private final Vector3 aside;

    Beams(RigidTransform fixedFromScanner) {
      origin = fixedFromScanner.translation();
      ahead = fixedFromScanner.rotation().rotate(new Vector3(1, 0, 0));
      aside = fixedFromScanner.rotation().rotate(new Vector3(0, 1, 0));
    }

    void end(double angle, double range, double[] xy, int index) {
      double along = range * Math.cos(angle);
      double across = range * Math.sin(angle);
      xy[2 * index] = origin.x() + along * ahead.x() + across * aside.x();
      xy[2 * index + 1] = origin.y() + along * ahead.y() + across * aside.y();
    }
  }
}
