package org.robotui.uic.map.internal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.robotui.data.array.Floats;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;

/** Reads scans and poses of a CARMEN log with a scanner of 180 degrees. */
final class CarmenLog {
  record Entry(LaserScan scan, RigidTransform odomFromBase) {}

  private static final double STEP = Math.toRadians(0.5);
  private static final double MAX = 80;

  private CarmenLog() {}

  static List<Entry> read(Path file) throws IOException {
    return Files.readAllLines(file).stream().filter(l -> l.startsWith("FLASER ")).map(CarmenLog::entry).toList();
  }

  private static Entry entry(String line) {
    String[] words = line.split(" ");
    int count = Integer.parseInt(words[1]);
    float[] ranges = new float[count];
    for (int i = 0; i < count; i++) {
      float range = Float.parseFloat(words[2 + i]);
      ranges[i] = range > MAX ? Float.POSITIVE_INFINITY : range;
    }
    int odometry = 2 + count + 3;
    RigidTransform pose = RigidTransform.planar(Double.parseDouble(words[odometry]),
        Double.parseDouble(words[odometry + 1]), Double.parseDouble(words[odometry + 2]));
    return new Entry(
        new LaserScan(DemoRoom.LASER, -Math.PI / 2, STEP, 0, MAX, 0.2, Floats.wrap(ranges), Floats.EMPTY), pose);
  }
}
