package org.robotui.uic.scene3d.internal.waypoint;

import java.util.Optional;
import java.util.function.Function;
import org.robotui.api.command.Output;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.navigation.Path;
import org.robotui.ui.Health;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.ui.scene.Commander;

/** Sends all waypoints at once, to programs that go along them by themselves. Safe for all threads. */
public final class WaypointSender {
  private final Commander commander;
  private final Output<Path> paths;
  private final Output<PoseArray> poses;

  /** Sends by a commander. */
  public WaypointSender(Commander commander, Output<Path> paths, Output<PoseArray> poses) {
    this.commander = commander;
    this.paths = paths;
    this.poses = poses;
  }

  /** Whether somebody takes ways. */
  public boolean takesPath() {
    return !(paths.state() instanceof InputState.Unconnected);
  }

  /** Whether somebody takes poses. */
  public boolean takesPoses() {
    return !(poses.state() instanceof InputState.Unconnected);
  }

  /** Sends them as a way. */
  public CommandNotice path(Route route) {
    return send(paths, route, frame -> new Path(frame, route.poses()));
  }

  /** Sends them as poses. */
  public CommandNotice poses(Route route) {
    return send(poses, route, frame -> new PoseArray(frame, route.poses()));
  }

  private <T extends Data> CommandNotice send(Output<T> output, Route route, Function<FrameId, T> made) {
    Optional<T> command = route.frame().filter(frame -> !route.poses().isEmpty()).map(made);
    return command.map(all -> commander.send(output, all, route.poses().size() + " waypoints sent"))
        .orElse(new CommandNotice(Health.BAD, "Not sent: there are no waypoints"));
  }
}
