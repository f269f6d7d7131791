package org.robotui.api.session;

import java.io.IOException;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.robotui.api.port.CommandSink;
import org.robotui.data.FrameId;
import org.robotui.data.geometry.Pose;

/**
 * Places on a map that a robot is told by questions, one after another on a thread of its own; of those that wait the
 * newest is told. What we sent on its way is stopped with the robot and at the end, and nothing else. Safe for all
 * threads.
 *
 * @param <C> goals, or where the robot is
 */
public final class PlaceCommands<C extends Pose> implements CommandSink<C>, AutoCloseable {

  /**
   * How a framework is told.
   *
   * @param <C> what it is told
   */
  public interface Telling<C> {

    /**
     * Tells a place; may block for a second or two.
     *
     * @param place on the map
     * @throws IOException where the robot does not take it, with a reason for users
     */
    void tell(C place) throws IOException;

    /**
     * Stops what is on its way; may block for a second or two.
     *
     * @throws IOException where the robot does not take it, with a reason for users
     */
    default void halt() throws IOException {
      // a place that is only known moves nothing
    }
  }

  private final String name;
  private final FrameId map;
  private final BiConsumer<String, Runnable> threads;
  private final Telling<C> telling;
  private final Consumer<String> refused;
  private Optional<C> waiting = Optional.empty(); // guarded by this, as the following
  private boolean halts;
  private boolean running;
  private boolean ours;
  private boolean closed;

  /**
   * Of a robot.
   *
   * @param name of who takes places, for users
   * @param map the frame in which they are given
   * @param threads starts the thread that tells, which has a name
   * @param telling tells
   * @param refused hears why the robot did not take a place, on that thread
   */
  public PlaceCommands(String name, FrameId map, BiConsumer<String, Runnable> threads, Telling<C> telling,
      Consumer<String> refused) {
    this.name = name;
    this.map = map;
    this.threads = threads;
    this.telling = telling;
    this.refused = refused;
  }

  @Override
  public synchronized Sent send(C place) {
    if (!place.frame().equals(map)) {
      return new Sent.Refused(name + " takes places on " + map.name() + ", not on " + place.frame().name()
          + "; use a view that is fixed to " + map.name());
    }
    if (closed) {
      return new Sent.Refused(name + " is no longer connected");
    }
    ours = true;
    halts = false;
    waiting = Optional.of(place);
    work();
    return new Sent.Out();
  }

  /** Stops what we sent on its way; does not block. */
  public synchronized void halt() {
    waiting = Optional.empty();
    if (ours) {
      ours = false;
      halts = true;
      work();
    }
  }

  private void work() {
    if (!running) {
      running = true;
      threads.accept("places of " + name, this::run);
    }
  }

  private record Next<C>(Optional<C> place, boolean halts) {
    boolean isNothing() {
      return place.isEmpty() && !halts;
    }
  }

  private synchronized Next<C> next() {
    Next<C> next = new Next<>(waiting, halts);
    waiting = Optional.empty();
    halts = false;
    running = !next.isNothing();
    return next;
  }

  private void run() {
    for (Next<C> next = next(); !next.isNothing(); next = next()) {
      try {
        if (next.place().isPresent()) {
          telling.tell(next.place().get());
        } else {
          telling.halt();
        }
      } catch (IOException e) {
        refused.accept(name + " did not take it: " + e.getMessage());
      }
    }
  }

  /** Stops what we sent on its way, and takes nothing more; does not block. */
  @Override
  public synchronized void close() {
    closed = true;
    halt();
  }
}
