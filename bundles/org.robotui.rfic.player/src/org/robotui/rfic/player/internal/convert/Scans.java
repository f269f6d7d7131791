package org.robotui.rfic.player.internal.convert;

import org.robotui.data.FrameId;
import org.robotui.data.array.Floats;
import org.robotui.data.sensor.LaserScan;
import org.robotui.player.interfaces.Laser;
import org.robotui.player.interfaces.Ranger;

/** Sweeps of scanners. Player's scanners say the farthest distance where a beam hit nothing. */
public final class Scans {
  private Scans() {}

  public static LaserScan of(Laser.Scan m, FrameId frame) {
    float[] ranges = m.ranges().clone();
    double max = farthest(m.maxRange());
    for (int i = 0; i < ranges.length; i++) {
      ranges[i] = open(ranges[i], max);
    }
    return new LaserScan(frame, m.minAngle(), step(m.minAngle(), m.maxAngle(), m.resolution(), ranges.length), 0, max,
        0,
        Floats.wrap(ranges), intensities(m.intensities(), ranges.length));
  }

  public static LaserScan of(double[] distances, Ranger.Config config, FrameId frame) {
    double max = farthest(config.maxRange());
    float[] ranges = new float[distances.length];
    for (int i = 0; i < ranges.length; i++) {
      ranges[i] = open((float) distances[i], max);
    }
    double min = Math.clamp(Poses.sane(config.minRange()), 0, max);
    double period = config.frequency() > 0 ? 1 / config.frequency() : 0;
    return new LaserScan(frame, config.minAngle(),
        step(config.minAngle(), config.maxAngle(), config.resolution(), ranges.length), min, max,
        period, Floats.wrap(ranges), Floats.EMPTY);
  }

  /** A device that does not say how far it sees is believed in all that it says. */
  private static double farthest(double max) {
    return max > 0 && Double.isFinite(max) ? max : Float.MAX_VALUE;
  }

  private static float open(float range, double max) {
    return range >= max * (1 - 1e-6) ? Float.POSITIVE_INFINITY : range;
  }

  /** The rays lie evenly between both ends, both of which have one; drivers round the resolution, or leave it out. */
  private static double step(double first, double last, double resolution, int rays) {
    Poses.finite(first, "first angle");
    if (rays < 2) {
      return 0;
    }
    double step = (Poses.finite(last, "last angle") - first) / (rays - 1);
    return step != 0 ? step : Poses.finite(resolution, "resolution");
  }

  private static Floats intensities(byte[] bytes, int rays) {
    if (bytes.length != rays) {
      return Floats.EMPTY;
    }
    float[] values = new float[rays];
    for (int i = 0; i < rays; i++) {
      values[i] = bytes[i] & 0xff;
    }
    return Floats.wrap(values);
  }
}
