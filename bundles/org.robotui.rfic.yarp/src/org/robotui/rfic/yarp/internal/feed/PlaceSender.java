package org.robotui.rfic.yarp.internal.feed;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.robotui.api.port.CommandSink;
import org.robotui.data.geometry.Pose;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;
import org.robotui.rfic.yarp.internal.convert.NavigationForms;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.port.PortCall;

/**
 * Sends places on a map, one question after another on a thread of its own; of those that wait the newest is sent. What
 * we sent on its way is stopped with the robot and at the end, and nothing else.
 *
 * @param <C> goals, or where the robot is
 */
final class PlaceSender<C extends Pose> implements CommandSink<C>, AutoCloseable {
  private static final Duration PATIENCE = Duration.ofMillis(1500);

  /** Which map the robot is on; empty where nothing tells. Blocks. */
  interface MapNames {
    Optional<String> current();
  }

  private final Wires wires;
  private final String go;
  private final Optional<String> halt;
  private final String name;
  private final Supplier<HostPort> where;
  private final MapNames maps;
  private final Consumer<String> refused;
  private Optional<C> waiting = Optional.empty(); // guarded by this, as the following
  private boolean halts;
  private boolean running;
  private boolean ours;
  private boolean closed;

  /** By which function places are told, and by which one what we sent on its way is stopped; refusals are told. */
  PlaceSender(Wires wires, String go, Optional<String> halt, String name, Supplier<HostPort> where, MapNames maps,
      Consumer<String> refused) {
    this.wires = wires;
    this.go = go;
    this.halt = halt;
    this.name = name;
    this.where = where;
    this.maps = maps;
    this.refused = refused;
  }

  @Override
  public synchronized Sent send(C goal) {
    if (!goal.frame().equals(wires.frames().map())) {
      return new Sent.Refused(name + " takes places on " + wires.frames().map().name() + ", not on "
          + goal.frame().name() + "; use a view that is fixed to " + wires.frames().map().name());
    }
    if (closed) {
      return new Sent.Refused(name + " is no longer connected");
    }
    ours = true;
    halts = false;
    waiting = Optional.of(goal);
    work();
    return new Sent.Out();
  }

  /** Stops what we sent on its way. */
  synchronized void halt() {
    waiting = Optional.empty();
    halts = ours && halt.isPresent();
    ours = false;
    if (halts) {
      work();
    }
  }

  private void work() {
    if (!running) {
      running = true;
      wires.workers().start("yarp places " + name, this::run);
    }
  }

  private record Next<C>(Optional<C> goal, boolean halts) {}

  private synchronized Next<C> next() {
    Next<C> next = new Next<>(waiting, halts);
    waiting = Optional.empty();
    halts = false;
    running = next.halts() || next.goal().isPresent();
    return next;
  }

  private void run() {
    for (Next<C> next = next(); next.halts() || next.goal().isPresent(); next = next()) {
      try (PortCall call = PortCall.connect(where.get(), wires.own() + "/rpc", wires.options())) {
        ask(call, next);
      } catch (IOException e) {
        refused.accept(name + " did not take it: " + e.getMessage());
      }
    }
  }

  private void ask(PortCall call, Next<C> next) throws IOException {
    Bottle question = next.goal().isEmpty() ? NavigationForms.question(halt.orElseThrow())
        : NavigationForms.question(go, NavigationForms.location(maps.current().orElseThrow(
            () -> new IOException("it needs the name of the map on which the robot is, which nothing tells")),
            next.goal().get().pose()));
    Outcome<Bottle> outcome = call.ask(question, PATIENCE);
    Bottle answer = outcome.toOptional().orElseThrow(() -> new IOException(outcome.reason()));
    if (!NavigationForms.isDone(answer)) {
      throw new IOException("it answered " + answer);
    }
  }

  @Override
  public void close() {
    synchronized (this) {
      closed = true;
    }
    halt();
  }
}
