package org.robotui.core.internal.command;

import java.util.ArrayDeque;
import java.util.Optional;
import java.util.Queue;
import java.util.function.Consumer;
import org.robotui.data.Data;
import org.robotui.data.command.Motion;

/**
 * What one command port still has to send: a stop before all else, then the newest motion, then other commands in
 * order. The port makes it, and only its sender touches it, under the lock of the sender.
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

  private final String port;
  private final Consumer<Pending<T>> delivery;
  private Optional<Pending<T>> stop = Optional.empty();
  private Optional<Pending<T>> motion = Optional.empty();
  private final Queue<Pending<T>> others = new ArrayDeque<>();
  private volatile String fence = "";

  /**
   * Without anything to send.
   *
   * @param port its name, for messages
   * @param delivery sends one command to the robot; on the thread of the sender, without its lock
   */
  Outbox(String port, Consumer<Pending<T>> delivery) {
    this.port = port;
    this.delivery = delivery;
  }

  String port() {
    return port;
  }

  /** Why nothing is sent here any more; empty where that is not so. Any thread. */
  String fence() {
    return fence;
  }

  void fence(String reason) {
    fence = reason;
  }

  /** Sends what was taken. On the thread of the sender, without its lock. */
  void deliver(Pending<T> taken) {
    delivery.accept(taken);
  }

  /** Adds; false where too many wait. */
  boolean add(Pending<T> pending) {
    if (pending.command() instanceof Motion<?>) {
      motion = Optional.of(pending);
      return true;
    }
    return others.size() < WAITING && others.add(pending);
  }

  /**
   * Puts a stop first; the motion that waited is never sent. A latched stop that waits is not replaced by the mere end
   * of a motion.
   */
  void stop(Pending<T> zero) {
    motion = Optional.empty();
    stop = Optional
        .of(stop.filter(s -> zero.purpose() == Purpose.COMMAND && s.generation() == zero.generation()).orElse(zero));
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
