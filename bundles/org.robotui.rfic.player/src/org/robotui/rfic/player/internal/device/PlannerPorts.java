package org.robotui.rfic.player.internal.device;

import java.util.List;
import java.util.Optional;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.data.FrameId;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.Path;
import org.robotui.player.interfaces.Planner;
import org.robotui.rfic.player.internal.convert.PlayerPlaces;
import org.robotui.rfic.player.internal.convert.Poses;

/** A planner: its way, which is asked for when its state tells that there is another one, and its goal. */
final class PlannerPorts {
  private static final long AGAIN_NANOS = 1_000_000_000L;

  private final DeviceFeed feed;
  private final Outlet<Path> outlet;
  private final FrameId map;
  private Optional<Planner.State> asked = Optional.empty(); // as the following, only on the receiving thread
  private long askedAt;

  PlannerPorts(DeviceFeed feed) {
    this.feed = feed;
    this.map = feed.around().tree().names().map();
    this.outlet = feed.outlet("", Path.class, "the path that it has planned");
    feed.on(Planner.STATE, outlet, this::told);
    feed.records("/state",
        feed.around().layouts().byName("planner").flatMap(p -> p.message(Planner.STATE.wireType(), "state")));
    feed.onOpen(() -> asked = Optional.empty());
    feed.command("/goal", NavigationGoal.class, "where the robot shall go, on the map", this::go);
  }

  private void told(Planner.State state, Reception reception) {
    boolean changed = asked.filter(before -> before.valid() == state.valid() && before.goal().equals(state.goal())
        && before.waypoints() == state.waypoints()).isEmpty();
    boolean due = state.valid() && !state.done() && reception.nanos() - askedAt > AGAIN_NANOS;
    if (!outlet.wanted() || !changed && !due) {
      return;
    }
    asked = Optional.of(state);
    askedAt = reception.nanos();
    if (state.valid()) {
      feed.ask(Planner.GET_WAYPOINTS, w -> outlet.publish(PlayerPlaces.way(w, map), Reception.now()), outlet::failed);
    } else {
      outlet.publish(new Path(map, List.of()), reception);
    }
  }

  private Sent go(NavigationGoal goal) {
    if (!goal.frame().equals(map)) {
      return new Sent.Refused(feed.name() + " takes goals on " + map.name() + ", not on " + goal.frame().name()
          + "; set the goal in a view that is fixed to " + map.name());
    }
    feed.linger();
    boolean out = feed.device().command(Planner.GOAL, new Planner.Place(Poses.planar(goal.pose())));
    return out ? new Sent.Out() : new Sent.Refused(Driving.obstacle(feed));
  }
}
