package org.robotui.sim.internal.player;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.concurrent.ThreadFactory;
import org.robotui.player.layout.Layouts;
import org.robotui.player.server.PlayerServer;
import org.robotui.player.server.ServerOptions;
import org.robotui.sim.internal.Face;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;

/** The robot as the devices of a Player server on loopback. */
public final class PlayerFace implements Face {
  private static final double NANOS = 1e-9;

  private final int port;
  private final ThreadFactory threads;
  private final List<Part> parts = new ArrayList<>();
  private Optional<PlayerServer> server = Optional.empty();
  private Optional<SimulatedRobot> robot = Optional.empty();
  private volatile double now;

  /** @param port where it listens; 0 for a free one */
  public PlayerFace(int port, ThreadFactory threads) {
    this.port = port;
    this.threads = threads;
  }

  @Override
  public void show(SimulatedRobot shown, long stamp) throws IOException {
    now = stamp * NANOS;
    Layouts layouts = Layouts.standard();
    PlayerServer opened = new PlayerServer(layouts, ServerOptions.loopback(threads, port, () -> now));
    server = Optional.of(opened);
    robot = Optional.of(shown);
    Bench bench = new Bench(layouts, opened, shown);
    parts.add(new Base(bench));
    boolean sonars = shown.model().sonars().count() > 0;
    if (sonars) {
      parts.add(new Sonars(bench));
    }
    parts.add(new Scanner(bench, sonars ? 1 : 0));
    if (!shown.model().bumpers().isEmpty()) {
      parts.add(new Bumpers(bench));
    }
    if (shown.model().head()) {
      parts.add(new Neck(bench));
    }
    parts.add(new Energy(bench));
    parts.add(new Inertia(bench));
    parts.add(new Cameras(bench));
    parts.add(new Maps(bench));
    parts.add(new Localizer(bench));
    parts.add(new Planning(bench));
  }

  @Override
  public void step(long step, long stamp) {
    now = stamp * NANOS;
    robot.map(SimulatedRobot::state).ifPresent(state -> step(step, state));
  }

  private void step(long step, RobotState state) {
    parts.forEach(part -> part.step(step, state, now));
  }

  @Override
  public SequencedMap<String, String> addresses() {
    SequencedMap<String, String> variables = new LinkedHashMap<>();
    server.ifPresent(listening -> {
      variables.put("PLAYER_HOST", "127.0.0.1");
      variables.put("PLAYER_PORT", Integer.toString(listening.port()));
    });
    return variables;
  }

  @Override
  public void close() {
    parts.forEach(Part::close);
    server.ifPresent(PlayerServer::close);
  }
}
