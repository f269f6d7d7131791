package org.robotui.core.internal.command;

import java.util.ArrayDeque;
import java.util.Optional;
import java.util.Queue;
import org.robotui.data.Data;
import org.robotui.data.Motion;

/**
 * What one command port still has to send: a stop before all else, then the newest motion, then other commands in order.
 * Guarded by the sender.
 */
final class Outbox<T extends Data> {
  /** What a command is for. */
  enum Purpose {
    /** Somebody commands, or what we move ends. */
    COMMAND,
    /** The latched stop, where we never drove. */
    STOP,
    /** The latched stop, where we drove. */
    OUR_STOP
  }

  /**
   * A command that waits for the sender.
   *
   * @param command the command
   * @param deadline nothing is sent later
   * @param generation of the link for which it was given
   * @param purpose what it is for
   */
  record Pending<T>(T command, long deadline, long generation, Purpose purpose) {}

  private static final int WAITING = 16;

  private Optional<Pending<T>> stop = Optional.empty();
  private Optional<Pending<T>> motion = Optional.empty();
  private final Queue<Pending<T>> others = new ArrayDeque<>();

  /** Adds; false where too many wait. */
  boolean add(Pending<T> pending) {
    if (pending.command() instanceof Motion<?>) {
      motion = Optional.of(pending);
      return true;
    }
    return others.size() < WAITING && others.add(pending);
  }

  /** Puts a stop first; the motion that waited is never sent. A latched stop that waits is not replaced by the mere end of a motion. */
  void stop(Pending<T> zero) {
    motion = Optional.empty();
    stop = Optional.of(stop.filter(s -> zero.purpose() == Purpose.COMMAND && s.generation() == zero.generation()).orElse(zero));
  }

  void clear() {
    motion = Optional.empty();
    others.clear();
  }

  boolean hasStop() {
    return stop.isPresent();
  }

  boolean isEmpty() {
    return stop.isEmpty() && motion.isEmpty() && others.isEmpty();
  }

  Optional<Pending<T>> take() {
    Optional<Pending<T>> next = stop.or(() -> motion).or(() -> Optional.ofNullable(others.peek()));
    if (stop.isPresent()) {
      stop = Optional.empty();
    } else if (motion.isPresent()) {
      motion = Optional.empty();
    } else {
      others.poll();
    }
    return next;
  }
}
