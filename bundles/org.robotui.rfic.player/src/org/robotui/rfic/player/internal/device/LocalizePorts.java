package org.robotui.rfic.player.internal.device;

import org.robotui.api.port.CommandSink.Sent;
import org.robotui.data.FrameId;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.player.interfaces.Localize;
import org.robotui.rfic.player.internal.convert.PlayerPlaces;

/**
 * Localisation: its best guess, which carries the odometry on the map, all guesses, its particles, and saying where the
 * robot is.
 */
final class LocalizePorts {
  private static final long AGAIN_NANOS = 1_000_000_000L;

  private final DeviceFeed feed;
  private final Outlet<PoseEstimate> estimate;
  private final Outlet<PoseArray> guesses;
  private final Outlet<PoseArray> particles;
  private final FrameId map;
  private long askedAt = System.nanoTime() - AGAIN_NANOS; // only on the thread that follows the devices

  LocalizePorts(DeviceFeed feed) {
    this.feed = feed;
    this.map = feed.around().tree().names().map();
    this.estimate = feed.outlet("", PoseEstimate.class, "where the robot most likely is");
    this.guesses = feed.outlet("/guesses", PoseArray.class, "where else it may be");
    this.particles = feed.outlet("/particles", PoseArray.class, "a sample of the filter");
    feed.on(Localize.HYPOTHESES, estimate, this::told);
    feed.onTick(this::sample);
    feed.command("/initial_pose", PoseEstimate.class, "where the robot is, on the map", this::place);
  }

  private void told(Localize.Hypotheses m, Reception reception) {
    PlayerPlaces.estimate(m, map).ifPresent(best -> {
      feed.around().tree().located(best, reception.stamp(), feed.name());
      estimate.publish(best, reception);
    });
    guesses.publish(PlayerPlaces.guesses(m, map), reception);
  }

  private void sample(long nowNanos) {
    if (particles.wanted() && nowNanos - askedAt >= AGAIN_NANOS) {
      askedAt = nowNanos;
      feed.ask(Localize.GET_PARTICLES, p -> particles.publish(PlayerPlaces.particles(p, map), Reception.now()),
          particles::failed);
    }
  }

  private Sent place(PoseEstimate pose) {
    if (!pose.frame().equals(map)) {
      return new Sent.Refused(feed.name() + " takes poses on " + map.name() + ", not on " + pose.frame().name()
          + "; set the pose in a view that is fixed to " + map.name());
    }
    feed.linger();
    if (!feed.open()) {
      return new Sent.Refused(Driving.obstacle(feed));
    }
    feed.ask(Localize.SET_POSE, PlayerPlaces.estimate(pose), done -> estimate.failed(""), estimate::failed);
    return new Sent.Out();
  }
}
