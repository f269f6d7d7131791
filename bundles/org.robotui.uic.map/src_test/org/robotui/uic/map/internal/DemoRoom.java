package org.robotui.uic.map.internal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.robotui.api.port.SourceId;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.sensor.Bumper;
import org.robotui.data.sensor.Bumpers;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.FakeFrames;
import org.robotui.testkit.FakeUicContext;

/** A building of two rooms with a robot in it, as in the drawing of the workbench. */
public final class DemoRoom {
  public static final String ROBOT = "Keira";
  public static final FrameId MAP = frame("map");
  public static final FrameId ODOM = frame("odom");
  public static final FrameId BASE = frame("base_link");
  public static final FrameId LASER = frame("laser");
  public static final RigidTransform ROBOT_AT = RigidTransform.planar(6.35, 1.35, Math.toRadians(20));

  private static final double RESOLUTION = 0.05;
  private static final int WIDTH = 300;
  private static final int HEIGHT = 190;
  private static final int BEAMS = 541;

  private DemoRoom() {}

  public static FrameId frame(String name) {
    return new FrameId(ROBOT, name);
  }

  public static SourceId source(String port) {
    return new SourceId("base", port);
  }

  public static FakeFrames frames() {
    FakeFrames frames = new FakeFrames();
    frames.fix(MAP, ODOM, RigidTransform.IDENTITY);
    frames.fix(ODOM, BASE, ROBOT_AT);
    frames.fix(BASE, LASER, RigidTransform.planar(0.1, 0, 0));
    for (int i = 0; i < 3; i++) {
      frames.fix(BASE, frame("sonar_" + i), RigidTransform.planar(0.15, 0, Math.toRadians(-40 + 40 * i)));
    }
    return frames;
  }

  /** Gives a context everything there is. */
  public static void fill(FakeUicContext context, long nanos) {
    context.frames(frames());
    context.input(MapPorts.MAP).put(source("map"), map(), nanos, Optional.empty());
    context.input(MapPorts.SCAN).put(source("scan"), scan(), nanos, Optional.empty());
    context.input(MapPorts.SONAR).put(source("sonar"), sonars(), nanos, Optional.empty());
    context.input(MapPorts.BUMPER).put(source("bumper"), bumpers(), nanos, Optional.empty());
    context.input(MapPorts.PATH).put(source("plan"), plan(), nanos, Optional.empty());
    context.input(MapPorts.ODOM).put(source("odom"), odometry(ROBOT_AT), nanos, Optional.empty());
  }

  public static List<Odometry> drive() {
    List<Odometry> way = new ArrayList<>();
    for (int i = 0; i <= 120; i++) {
      double t = i / 120.0;
      double x = 1.0 + 5.35 * t;
      double y = 1.2 + 1.5 * Math.sin(Math.PI * t * 0.95) + 0.15 * t;
      way.add(odometry(RigidTransform.planar(x, y, 0)));
    }
    way.add(odometry(ROBOT_AT));
    return way;
  }

  public static Odometry odometry(RigidTransform pose) {
    double[] covariance = new double[Odometry.COVARIANCE_SIZE];
    covariance[0] = 0.04;
    covariance[1] = 0.015;
    covariance[6] = 0.015;
    covariance[7] = 0.02;
    return new Odometry(ODOM, BASE, pose, Doubles.wrap(covariance), new Vector3(0.27, 0, 0), new Vector3(0, 0, -0.18),
        Doubles.EMPTY);
  }

  public static Path plan() {
    double[][] points = {{6.35, 1.35}, {7.3, 3.5}, {8.3, 5.2}, {9.3, 5.9}};
    return new Path(MAP, List.of(points).stream().map(p -> RigidTransform.planar(p[0], p[1], 0)).toList());
  }

  public static GridMap map() {
    byte[] cells = new byte[WIDTH * HEIGHT];
    Arrays.fill(cells, GridMap.UNKNOWN);
    for (int row = 0; row < HEIGHT; row++) {
      for (int column = 0; column < WIDTH; column++) {
        double x = column * RESOLUTION - 1;
        double y = row * RESOLUTION - 1;
        if (wall(x, y)) {
          cells[row * WIDTH + column] = 100;
        } else if (inside(x, y)) {
          cells[row * WIDTH + column] = 0;
        }
      }
    }
    return new GridMap(MAP, RESOLUTION, WIDTH, HEIGHT, RigidTransform.planar(-1, -1, 0), Bytes.of(cells));
  }

  public static LaserScan scan() {
    float[] ranges = new float[BEAMS];
    double first = Math.toRadians(-110);
    double step = Math.toRadians(220) / (BEAMS - 1);
    RigidTransform laser = ROBOT_AT.times(RigidTransform.planar(0.1, 0, 0));
    for (int i = 0; i < BEAMS; i++) {
      ranges[i] = (float) cast(laser, first + i * step, 5.6, i);
    }
    return new LaserScan(LASER, first, step, 0.1, 5.6, 0.1, Floats.wrap(ranges), Floats.EMPTY);
  }

  public static RangeReadings sonars() {
    List<RangeReading> readings = new ArrayList<>();
    double[] ranges = {1.1, 1.6, Double.POSITIVE_INFINITY};
    for (int i = 0; i < ranges.length; i++) {
      readings.add(new RangeReading(
          frame("sonar_" + i), RangeReading.Kind.ULTRASOUND, Math.toRadians(25), 0.1, 2.5, ranges[i]));
    }
    return new RangeReadings(readings);
  }

  /** Two around the front; that at the right is pressed. */
  public static Bumpers bumpers() {
    return new Bumpers(BASE, List.of(bumper(Math.toRadians(45), false), bumper(Math.toRadians(-45), true)));
  }

  private static Bumper bumper(double bearing, boolean pressed) {
    double radius = 0.25;
    return new Bumper(RigidTransform.planar(radius * Math.cos(bearing), radius * Math.sin(bearing), bearing),
        1.4 * radius, radius, pressed);
  }

  private static double cast(RigidTransform laser, double angle, double limit, int noise) {
    Vector3 ahead = laser.rotation().times(Quaternion.fromYaw(angle)).rotate(new Vector3(1, 0, 0));
    for (double r = 0.1; r < limit; r += 0.01) {
      Vector3 at = laser.translation().plus(ahead.times(r));
      if (wall(at.x(), at.y())) {
        return r + 0.02 * Math.sin(noise * 12.9898);
      }
    }
    return Double.POSITIVE_INFINITY;
  }

  private static boolean inside(double x, double y) {
    return x > 0 && x < 11 && y > 0 && y < 7 || x > 0 && x < 13 && y > 0 && y < 3;
  }

  private static boolean wall(double x, double y) {
    boolean outer = band(y, 7) && x > 0 && x < 11.2 || band(x, 0) && y > 0 && y < 7.2
        || band(y, 0) && x > 0 && x < 13.2 || band(x, 11) && y > 3 && y < 7.2;
    boolean inner = band(x, 4) && (y > 4.6 && y < 7 || y > 0 && y < 2.9)
        || band(y, 3) && x > 11 && x < 13.2 || band(x, 13) && y > 0 && y < 2.1;
    return outer || inner;
  }

  private static boolean band(double value, double at) {
    return value >= at && value < at + 0.2;
  }
}
