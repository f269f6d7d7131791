package org.robotui.rfic.smartsoft.internal.convert;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.robotui.api.session.RobotFrames;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Floats;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.geometry.RigidTransform;
import org.robotui.message.DynamicMessage;

/** What the robot's sensors say. */
public final class SmartSensing {
  /** Angles of scans are in hundredths of a degree. */
  private static final double HUNDREDTH = Math.toRadians(0.01);
  /** The most rays of a scan: their numbers have 16 bits. */
  private static final int MOST_RAYS = 1 << 16;
  private static final int MOST_SENSORS = 1024;
  private static final double IR_VIEW = Math.toRadians(5);
  /** Uncertainties of a satellite fix are for 95 percent, two standard deviations. */
  private static final double DEVIATIONS = 2;
  private static final int FREE_TO_OCCUPIED = 127;
  private static final int UNKNOWN = 205;
  private static final int CERTAIN = 100;

  private SmartSensing() {}

  /** A {@code CommLaserScan}. Only rays that hit something are sent, each with its number. */
  public static LaserScan scan(DynamicMessage scan, FrameId frame) {
    double unit = ObjectFields.of(scan, "length_unit") / SmartPlaces.PER_METRE;
    List<DynamicMessage> points = ObjectFields.list(scan, "scan_points");
    int rays = (int) Math.min(MOST_RAYS, Math.max(ObjectFields.of(scan, "max_scan_points"), last(points) + 1));
    float[] ranges = new float[rays];
    float[] intensities = new float[rays];
    Arrays.fill(ranges, Float.POSITIVE_INFINITY);
    for (DynamicMessage point : points) {
      int ray = (int) ObjectFields.of(point, "index");
      ranges[ray] = (float) (unit * ObjectFields.of(point, "distance"));
      intensities[ray] = (float) ObjectFields.of(point, "intensity");
    }
    double start = HUNDREDTH * ObjectFields.of(scan, "start_angle");
    return new LaserScan(frame, start > Math.PI ? start - 2 * Math.PI : start,
        HUNDREDTH * ObjectFields.of(scan, "resolution"), unit * ObjectFields.of(scan, "distance_min"),
        unit * ObjectFields.of(scan, "distance_max"), 0, Floats.wrap(ranges), Floats.wrap(intensities));
  }

  private static int last(List<DynamicMessage> points) {
    int last = -1;
    for (DynamicMessage point : points) {
      last = Math.max(last, (int) ObjectFields.of(point, "index"));
    }
    return last;
  }

  /** A {@code CommIRScan}, each sensor in a frame of its own. */
  public static RangeReadings infrared(DynamicMessage scan, RobotFrames frames, String name) {
    double[] distances = ObjectFields.numbers(scan, "distances");
    double least = Math.max(0, ObjectFields.of(scan, "distance_min"));
    double most = Math.max(least, ObjectFields.of(scan, "distance_max"));
    List<RangeReading> readings = new ArrayList<>();
    for (int i = 0; i < Math.min(MOST_SENSORS, distances.length); i++) {
      readings.add(new RangeReading(frames.device(sensor(name, i)), RangeReading.Kind.INFRARED, IR_VIEW, least, most,
          distances[i]));
    }
    return new RangeReadings(readings);
  }

  /** How a sensor's frame is called. */
  public static String sensor(String name, int index) {
    return name + "_" + index;
  }

  /** Where the sensors of a {@code CommIRScan} are on the robot, in their order. */
  public static List<RigidTransform> mounts(DynamicMessage scan) {
    return ObjectFields.list(scan, "poses3D").stream().limit(MOST_SENSORS).map(SmartPlaces::pose).toList();
  }

  /** A {@code CommGpsFix}. */
  public static GpsFix fix(DynamicMessage fix, FrameId frame) {
    boolean plane = ObjectFields.of(fix, "is_2D") != 0;
    boolean space = ObjectFields.of(fix, "is_3D") != 0;
    return new GpsFix(frame, plane || space ? GpsFix.Quality.FIX : GpsFix.Quality.NO_FIX,
        Math.toRadians(ObjectFields.of(fix, "latitude")), Math.toRadians(ObjectFields.of(fix, "longitude")),
        space ? ObjectFields.of(fix, "altitude") : Double.NaN, Math.hypot(ObjectFields.of(fix, "latitude_uncertainty"),
            ObjectFields.of(fix, "longitude_uncertainty")) / DEVIATIONS);
  }

  /**
   * A {@code CommGridMap}: rows from the smallest y; 0 is free, 127 occupied, above it obstacles and what is near them.
   */
  public static GridMap map(DynamicMessage map, FrameId frame) {
    double[] told = ObjectFields.numbers(map, "cell");
    int width = (int) ObjectFields.of(map, "xSizeCells");
    int height = (int) ObjectFields.of(map, "ySizeCells");
    if (width <= 0 || height <= 0 || (long) width * height != told.length) {
      throw new IllegalArgumentException(told.length + " cells are none of " + width + " x " + height);
    }
    byte[] cells = new byte[told.length];
    for (int i = 0; i < cells.length; i++) {
      cells[i] = occupancy((int) told[i]);
    }
    RigidTransform origin = RigidTransform.planar(ObjectFields.of(map, "xOffsetMM") / SmartPlaces.PER_METRE,
        ObjectFields.of(map, "yOffsetMM") / SmartPlaces.PER_METRE, 0);
    return new GridMap(frame, ObjectFields.of(map, "cellSizeMM") / SmartPlaces.PER_METRE, width, height, origin,
        Bytes.wrap(cells, 0, cells.length));
  }

  private static byte occupancy(int cell) {
    if (cell <= FREE_TO_OCCUPIED) {
      return (byte) Math.round((float) CERTAIN * cell / FREE_TO_OCCUPIED);
    }
    return cell == UNKNOWN ? GridMap.UNKNOWN : CERTAIN;
  }
}
