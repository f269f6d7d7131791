package org.robotui.sim.internal.sensor;

import java.util.Arrays;
import java.util.random.RandomGenerator;
import org.robotui.sim.internal.world.FloorPlanReader;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.RaySpan;
import org.robotui.sim.internal.world.Solid;
import org.robotui.sim.internal.world.World;

/** Measures what a spinning scanner would: walls, things, floor and ceiling. For one thread. */
public final class Lidar {
  /** Numbers of a point: x, y, z and intensity. */
  public static final int NUMBERS = 4;
  private static final double FLOOR = 0.35;
  private static final double CEILING = 0.9;
  private static final double BRIGHTEST = 100;

  private final LidarSpec spec;
  private final RandomGenerator random;
  private final RaySpan span = new RaySpan();
  private final double[] slopes;
  private final double[] nearest;
  private final double[] echo;
  private final float[] points;

  public Lidar(LidarSpec spec, RandomGenerator random) {
    this.spec = spec;
    this.random = random;
    slopes = new double[spec.rings()];
    Arrays.setAll(slopes, ring -> Math.tan(spec.elevation(ring)));
    nearest = new double[spec.rings()];
    echo = new double[spec.rings()];
    points = new float[NUMBERS * spec.rings() * spec.columns()];
  }

  public LidarSpec spec() {
    return spec;
  }

  /**
   * Turns once.
   *
   * @param world with everybody in it
   * @param robot where it stands
   * @return x, y, z in metres from the scanner and the intensity, 0 to 100, of every echo in turn
   */
  public float[] scan(World world, Pose2 robot) {
    Pose2 eye = robot.times(new Pose2(spec.forward(), 0, 0));
    int used = 0;
    for (int column = 0; column < spec.columns(); column++) {
      double angle = 2 * Math.PI * column / spec.columns();
      look(world, eye, eye.yaw() + angle);
      used = store(angle, used);
    }
    return Arrays.copyOf(points, used);
  }

  private void look(World world, Pose2 eye, double angle) {
    double dx = Math.cos(angle);
    double dy = Math.sin(angle);
    for (int ring = 0; ring < slopes.length; ring++) {
      boolean down = slopes[ring] < 0;
      double rise = down ? -spec.height() : FloorPlanReader.ROOM_HEIGHT - spec.height();
      nearest[ring] = slopes[ring] == 0 ? Double.POSITIVE_INFINITY : rise / slopes[ring];
      echo[ring] = (down ? FLOOR : CEILING) * Math.abs(Math.sin(spec.elevation(ring)));
    }
    for (Solid solid : world.present()) {
      if (solid.clip(eye.x(), eye.y(), dx, dy, span) && span.enter() < spec.rangeMax()) {
        double facing =
            span.edge() < 0 ? 1 : Math.abs(solid.normalX(span.edge()) * dx + solid.normalY(span.edge()) * dy);
        hit(solid, brightness(solid.colour()), facing);
      }
    }
  }

  /** Where each ring meets a solid that stands in the way: its side, or its upper or lower face. */
  private void hit(Solid solid, double brightness, double facing) {
    for (int ring = 0; ring < slopes.length; ring++) {
      double slope = slopes[ring];
      double side = Math.max(0, span.enter());
      double z = spec.height() + slope * side;
      boolean above = z >= solid.top();
      boolean below = z < solid.bottom();
      double at =
          above ? (solid.top() - spec.height()) / slope : below ? (solid.bottom() - spec.height()) / slope : side;
      boolean met = at >= side && at <= span.exit() && at < nearest[ring];
      if (met) {
        nearest[ring] = at;
        echo[ring] = brightness
            * (above || below ? Math.abs(Math.sin(spec.elevation(ring))) : facing * Math.cos(spec.elevation(ring)));
      }
    }
  }

  private int store(double angle, int from) {
    int used = from;
    for (int ring = 0; ring < slopes.length; ring++) {
      double elevation = spec.elevation(ring);
      double range = nearest[ring] / Math.cos(elevation) + spec.noise() * random.nextGaussian();
      boolean heard = random.nextDouble() >= spec.lost();
      if (heard && range >= spec.rangeMin() && range <= spec.rangeMax()) {
        points[used++] = (float) (range * Math.cos(elevation) * Math.cos(angle));
        points[used++] = (float) (range * Math.cos(elevation) * Math.sin(angle));
        points[used++] = (float) (range * Math.sin(elevation));
        points[used++] = (float) Math.clamp(BRIGHTEST * echo[ring] + random.nextGaussian(), 0, BRIGHTEST);
      }
    }
    return used;
  }

  private static double brightness(int colour) {
    return (0.3 * (colour >> 16 & 0xff) + 0.59 * (colour >> 8 & 0xff) + 0.11 * (colour & 0xff)) / 255;
  }
}
