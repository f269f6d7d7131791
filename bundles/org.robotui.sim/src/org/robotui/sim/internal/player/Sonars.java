package org.robotui.sim.internal.player;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.robotui.player.interfaces.Pose3d;
import org.robotui.player.interfaces.Ranger;
import org.robotui.player.interfaces.Size3d;
import org.robotui.player.interfaces.Sonar;
import org.robotui.player.server.ServedDevice;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.sensor.SonarSpec;

/** The sonars as {@code sonar:0} and {@code ranger:0}. */
final class Sonars implements Part {
  private static final Rate RATE = new Rate(10);
  private static final Size3d SIZE = new Size3d(0.04, 0.02, 0.04);
  private static final double RESOLUTION = 0.02;

  private final Bench bench;
  private final SonarSpec spec;
  private final ServedDevice sonar;
  private final ServedDevice ranger;

  Sonars(Bench bench) {
    this.bench = bench;
    spec = bench.robot().model().sonars();
    List<Pose3d> mounts = spec.mounts().stream().map(mount -> Poses.mount(mount, spec.height())).toList();
    sonar = bench.add("sonar", 0, bench.handler()
        .on(Sonar.GET_GEOMETRY, none -> Optional.of(new Sonar.Geometry(mounts))));
    double diameter = 2 * bench.robot().model().radius();
    ranger = bench.add("ranger", 0, bench.handler()
        .on(Ranger.GET_GEOMETRY,
            none -> Optional
                .of(new Ranger.Geometry(Poses.ahead(0, 0), new Size3d(diameter, diameter, SIZE.height()), mounts,
                    Collections.nCopies(spec.count(), SIZE))))
        .on(Ranger.GET_CONFIG, none -> Optional.of(new Ranger.Config(
            -spec.cone() / 2, spec.cone() / 2, spec.cone(), spec.rangeMin(), spec.rangeMax(), RESOLUTION,
            RATE.hertz()))));
  }

  @Override
  public void step(long step, RobotState state, double stamp) {
    if (!RATE.isDue(step) || sonar.clients() + ranger.clients() == 0) {
      return;
    }
    double[] ranges = IntStream.range(0, spec.count())
        .mapToDouble(i -> Math.min(bench.robot().sensors().sonar(i), spec.rangeMax())).toArray();
    float[] same = new float[ranges.length];
    for (int i = 0; i < same.length; i++) {
      same[i] = (float) ranges[i];
    }
    sonar.publish(Sonar.RANGES, new Sonar.Ranges(same), stamp);
    ranger.publish(Ranger.RANGES, new Ranger.Ranges(ranges), stamp);
  }
}
