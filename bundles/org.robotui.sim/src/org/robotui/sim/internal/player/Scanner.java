package org.robotui.sim.internal.player;

import java.util.List;
import java.util.Optional;
import org.robotui.player.interfaces.Body;
import org.robotui.player.interfaces.Laser;
import org.robotui.player.interfaces.Ranger;
import org.robotui.player.server.ServedDevice;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.sensor.LaserSpec;

/** The laser as {@code laser:0} and as a ranger. Its settings are fixed: what would change them is refused. */
final class Scanner implements Part {
  private static final double DIAMETER = 0.08;
  private static final double RESOLUTION = 0.001;

  private final Bench bench;
  private final LaserSpec spec;
  private final ServedDevice laser;
  private final ServedDevice ranger;
  private long sweeps;

  Scanner(Bench bench, int rangerIndex) {
    this.bench = bench;
    spec = bench.robot().model().laser();
    laser = bench.add("laser", 0, bench.handler()
        .on(Laser.GET_GEOMETRY, none -> Optional.of(body()))
        .on(Laser.GET_CONFIG,
            none -> Optional
                .of(new Laser.Config((float) spec.angleMin(), (float) -spec.angleMin(), (float) spec.increment(),
                    (float) spec.rangeMax(), (float) RESOLUTION, false, (float) spec.frequency()))));
    ranger = bench.add("ranger", rangerIndex, bench.handler()
        .on(Ranger.GET_GEOMETRY,
            none -> Optional.of(
                new Ranger.Geometry(body().pose(), body().size(), List.of(Poses.ahead(0, 0)), List.of(body().size()))))
        .on(Ranger.GET_CONFIG, none -> Optional.of(new Ranger.Config(
            spec.angleMin(), -spec.angleMin(), spec.increment(), spec.rangeMin(), spec.rangeMax(), RESOLUTION,
            spec.frequency()))));
  }

  private Body body() {
    return Poses.round(Poses.ahead(spec.forward(), spec.height()), DIAMETER, DIAMETER);
  }

  @Override
  public void step(long step, RobotState state, double stamp) {
    if (!bench.robot().sensors().isScanDue(step) || laser.clients() + ranger.clients() == 0) {
      return;
    }
    float[] ranges = bench.robot().sensors().scan(step);
    double[] same = new double[ranges.length];
    for (int i = 0; i < ranges.length; i++) {
      ranges[i] = Math.min(ranges[i], (float) spec.rangeMax());
      same[i] = ranges[i];
    }
    sweeps++;
    laser.publish(Laser.SCAN,
        new Laser.Scan((float) spec.angleMin(), (float) -spec.angleMin(), (float) spec.increment(),
            (float) spec.rangeMax(),
            ranges, new byte[0], sweeps),
        stamp);
    ranger.publish(Ranger.RANGES, new Ranger.Ranges(same), stamp);
  }
}
