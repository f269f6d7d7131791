package org.robotui.rfic.player.internal.convert;

import java.util.ArrayList;
import java.util.List;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.player.interfaces.Ranger;

/** Distances of rings of sensors. */
public final class Sonars {
  private Sonars() {}

  /**
   * What one sensor sees.
   *
   * @param cone its opening, radians
   * @param range how far it sees, metres
   */
  public record Beam(double cone, double range) {
    /** What a ranger tells of itself; what it leaves out is taken from here. */
    public Beam told(Ranger.Config config) {
      double opening = Math.abs(config.maxAngle() - config.minAngle());
      return new Beam(opening > 0 && opening <= Math.PI ? opening : cone,
          config.maxRange() > 0 && Double.isFinite(config.maxRange()) ? config.maxRange() : range);
    }
  }

  public static RangeReadings of(double[] distances, Beam beam, RangeReading.Kind kind, FrameNames frames,
      String device) {
    List<RangeReading> readings = new ArrayList<>(distances.length);
    for (int i = 0; i < distances.length; i++) {
      double range = distances[i] >= beam.range() ? Double.POSITIVE_INFINITY : distances[i];
      readings.add(new RangeReading(frames.element(device, i), kind, beam.cone(), 0, beam.range(), range));
    }
    return new RangeReadings(readings);
  }

  public static double[] doubles(float[] values) {
    double[] wide = new double[values.length];
    for (int i = 0; i < values.length; i++) {
      wide[i] = values[i];
    }
    return wide;
  }
}
