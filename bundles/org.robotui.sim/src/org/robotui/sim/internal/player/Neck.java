package org.robotui.sim.internal.player;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.player.interfaces.Ptz;
import org.robotui.player.layout.Empty;
import org.robotui.player.server.ServedDevice;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.robot.Head;
import org.robotui.sim.internal.robot.Neck.Look;

/** {@code ptz:0}: the head, which looks around by itself until it is told where to look. Player tilts upwards. */
final class Neck implements Part {
  private static final Rate RATE = new Rate(10);
  private static final double FASTEST = 1.5;
  private static final double DIAMETER = 0.17;

  private final Bench bench;
  private final ServedDevice device;
  private final AtomicBoolean places = new AtomicBoolean(true);

  Neck(Bench bench) {
    this.bench = bench;
    device = bench.add("ptz", 0, bench.handler()
        .on(Ptz.MOVE, this::move)
        .on(Ptz.CONTROL_MODE, mode -> mode(mode.mode()))
        .on(Ptz.GET_GEOMETRY, none -> Optional.of(Poses.round(Poses.ahead(0, Head.HEIGHT), DIAMETER, Head.NECK)))
        .on(Ptz.GET_STATUS, none -> Optional.of(new Ptz.Status(0))));
  }

  private Optional<Empty> mode(long mode) {
    if (mode > 1) {
      return Optional.empty();
    }
    places.set(mode == 1);
    return Optional.of(new Empty());
  }

  private void move(Ptz.Move wish) {
    boolean finite = Float.isFinite(wish.pan() + wish.tilt() + wish.panSpeed() + wish.tiltSpeed());
    if (finite) {
      bench.submit(new Command.Turn(places.get() ? there(wish) : onwards(wish)));
    }
  }

  private static Look there(Ptz.Move wish) {
    return new Look(wish.pan(), -wish.tilt(), speed(wish.panSpeed()), speed(wish.tiltSpeed()));
  }

  /** A speed of zero leaves the choice to the head. */
  private static double speed(double wish) {
    return wish == 0 ? FASTEST : Math.abs(wish);
  }

  /** As far as the neck can turn. */
  private static Look onwards(Ptz.Move wish) {
    return new Look(Math.copySign(Math.PI, wish.panSpeed()), Math.copySign(Math.PI, -wish.tiltSpeed()),
        Math.abs(wish.panSpeed()), Math.abs(wish.tiltSpeed()));
  }

  @Override
  public void step(long step, RobotState state, double stamp) {
    if (RATE.isDue(step)) {
      float zoom = (float) bench.robot().model().lens().fieldOfView();
      state.head().ifPresent(head -> device.publish(Ptz.STATE,
          new Ptz.State((float) head.pan(), (float) -head.tilt(), zoom, (float) head.panSpeed(),
              (float) -head.tiltSpeed(), 0),
          stamp));
    }
  }
}
