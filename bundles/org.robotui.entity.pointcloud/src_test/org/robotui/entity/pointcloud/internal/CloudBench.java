package org.robotui.entity.pointcloud.internal;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Locale;
import java.util.Random;
import org.robotui.data.sensor.PointCloud;
import org.robotui.geometry.RigidTransform;
import org.robotui.testkit.display.DisplayProbe;

/** How long a cloud of a million points takes to be prepared, by what colours it; for people to run. */
final class CloudBench {
  private static final int POINTS = 1_000_000;
  private static final int ROUNDS = 40;

  private CloudBench() {}

  public static void main(String[] args) {
    ByteBuffer bytes = ByteBuffer.allocate(16 * POINTS).order(ByteOrder.LITTLE_ENDIAN);
    Random random = new Random(1);
    for (int i = 0; i < POINTS; i++) {
      bytes.putFloat(random.nextFloat()).putFloat(random.nextFloat()).putFloat(random.nextFloat())
          .putFloat(random.nextFloat());
    }
    PointCloud cloud = Clouds.plain(POINTS, bytes, "intensity");
    for (String colorBy : new String[]{"flat", "field", "axis", "flat", "field", "axis"}) {
      try (DisplayProbe probe = new DisplayProbe(new PointCloudType())) {
        probe.places().put("lidar", RigidTransform.planar(1, 2, 0.3));
        probe.set("color_by", colorBy);
        double best = Double.POSITIVE_INFINITY;
        double sum = 0;
        for (int i = 0; i < ROUNDS; i++) {
          long before = System.nanoTime();
          probe.tick(cloud);
          double ms = (System.nanoTime() - before) * 1e-6;
          best = Math.min(best, ms);
          sum += i < ROUNDS / 2 ? 0 : ms / (ROUNDS - ROUNDS / 2);
        }
        System.out.printf(Locale.ROOT, "%-6s %6.1f ms mean, %6.1f ms best%n", colorBy, sum, best);
      }
    }
  }
}
