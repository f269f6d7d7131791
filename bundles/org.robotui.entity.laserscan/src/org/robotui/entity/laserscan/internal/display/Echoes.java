package org.robotui.entity.laserscan.internal.display;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.data.sensor.LaserScan;
import org.robotui.gl.shape.ColorRamp;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.Properties;

/**
 * What is drawn of a scan, in its own frame.
 *
 * @param scan the scan
 * @param beams the beam of each echo
 * @param points the echoes, where they are asked for
 * @param lines between neighbours, where they are asked for
 */
record Echoes(LaserScan scan, int[] beams, Optional<PointSet> points, Optional<LineSet> lines) {
  private static final int STEPS = 256;
  private static final float WIDTH = 1.5f;

  static Echoes of(LaserScan scan, Settings settings) {
    int[] beams = new int[scan.ranges().size()];
    float[] xyz = new float[3 * beams.length];
    int count = 0;
    for (int beam = 0; beam < scan.ranges().size(); beam++) {
      if (scan.isEcho(beam)) {
        xyz[3 * count] = (float) (scan.ranges().get(beam) * Math.cos(scan.angle(beam)));
        xyz[3 * count + 1] = (float) (scan.ranges().get(beam) * Math.sin(scan.angle(beam)));
        beams[count++] = beam;
      }
    }
    int[] echoes = Arrays.copyOf(beams, count);
    float[] places = Arrays.copyOf(xyz, 3 * count);
    String style = settings.text("style");
    return new Echoes(scan, echoes,
        style.equals("lines") ? Optional.empty() : Optional.of(points(scan, echoes, places, settings)),
        style.equals("points") ? Optional.empty() : Optional.of(lines(echoes, places, settings.number("gap"))));
  }

  Properties describe(int echo) {
    if (echo < 0 || echo >= beams.length) {
      return Properties.of("laser scan");
    }
    int beam = beams[echo];
    String strength =
        scan.intensities().size() == 0 ? "not sent" : String.format(Locale.ROOT, "%.6g", scan.intensities().get(beam));
    return Properties.of("echo of beam " + beam,
        new Properties.Entry("frame", scan.frame().name()),
        new Properties.Entry("range", String.format(Locale.ROOT, "%.3f m", scan.ranges().get(beam))),
        new Properties.Entry("angle", String.format(Locale.ROOT, "%.1f\u00b0", Math.toDegrees(scan.angle(beam)))),
        new Properties.Entry("intensity", strength));
  }

  private static PointSet points(LaserScan scan, int[] beams, float[] xyz, Settings s) {
    PointSet.Unit unit = s.text("unit").equals("metres") ? PointSet.Unit.METRES : PointSet.Unit.PIXELS;
    return PointSet.of(FloatBuffer.wrap(xyz), colors(scan, beams, s), (float) s.number("size"), unit);
  }

  private static Optional<ByteBuffer> colors(LaserScan scan, int[] beams, Settings s) {
    boolean intensity = s.text("color_by").equals("intensity");
    if (s.text("color_by").equals("flat") || intensity && scan.intensities().size() == 0) {
      return Optional.empty();
    }
    float[] values = new float[beams.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = intensity ? scan.intensities().get(beams[i]) : scan.ranges().get(beams[i]);
    }
    double[] limits = limits(values, s);
    int[] table = ColorRamp.named(s.text("colors")).table(STEPS, false);
    ByteBuffer rgba = ByteBuffer.allocate(Integer.BYTES * values.length);
    for (float value : values) {
      double share = limits[1] > limits[0] ? (value - limits[0]) / (limits[1] - limits[0]) : 0;
      rgba.putInt(table[(int) (Math.clamp(share, 0.0, 1.0) * (STEPS - 1))] << Byte.SIZE | 0xff);
    }
    return Optional.of(rgba.flip());
  }

  private static double[] limits(float[] values, Settings s) {
    double least = Double.POSITIVE_INFINITY;
    double greatest = Double.NEGATIVE_INFINITY;
    for (float value : values) {
      least = Float.isFinite(value) ? Math.min(least, value) : least;
      greatest = Float.isFinite(value) ? Math.max(greatest, value) : greatest;
    }
    return new double[]{s.has("min") ? s.number("min") : least, s.has("max") ? s.number("max") : greatest};
  }

  private static LineSet lines(int[] beams, float[] xyz, double gap) {
    float[] ends = new float[Math.max(0, 6 * (beams.length - 1))];
    int used = 0;
    for (int i = 1; i < beams.length; i++) {
      double apart = Math.hypot(xyz[3 * i] - xyz[3 * i - 3], xyz[3 * i + 1] - xyz[3 * i - 2]);
      if (beams[i] == beams[i - 1] + 1 && apart <= gap) {
        System.arraycopy(xyz, 3 * i - 3, ends, used, 6);
        used += 6;
      }
    }
    return LineSet.of(LineSet.Kind.SEGMENTS, WIDTH, Arrays.copyOf(ends, used));
  }

  /** What was asked for and is not there. */
  List<String> missing(Settings s) {
    return s.text("color_by").equals("intensity") && scan.intensities().size() == 0
        ? List.of("the scan has no intensities; color_by range shows its distances")
        : List.of();
  }
}
