package org.robotui.api.host;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.Principal;
import org.robotui.api.port.Browser;
import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.Port;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;

/**
 * The ports of a RUIC's robot interfaces for a program that is no view, such as a script. Nothing is matched: each port
 * is named. Commands pass the arbiter as those of a view do. Ports may go and come, as when a robot interface is
 * exchanged or the RUIC is restarted; they are looked up at each call. Safe for all threads; never blocks.
 */
public interface PortAccess extends AutoCloseable {
  /**
   * As whom commands are given.
   *
   * @return the principal
   */
  Principal principal();

  /**
   * A port as its robot interface offers it.
   *
   * @param kind what passes through
   * @param id which
   * @return the port, or none where it is not offered now
   */
  Optional<Port> port(PortKind kind, SourceId id);

  /**
   * The newest value of a stream. From the first call on the robot is asked for the stream, until this is closed.
   *
   * @param stream which
   * @return the value, merged for keyed types; none before the first, or where there is no such stream
   */
  Optional<Envelope<?>> newest(SourceId stream);

  /**
   * Takes the values of a stream that came since the last call, within bounds of count and size: the oldest are dropped
   * first. From the first call on the robot is asked for the stream. One thread at a time may take.
   *
   * @param stream which
   * @param consumer is called on this thread
   * @return how many were taken
   */
  int take(SourceId stream, Consumer<? super Envelope<?>> consumer);

  /**
   * Has something told of each value that has come of a stream and waits to be taken, in the place of what was told
   * before. Who takes values need not look for them again and again then.
   *
   * @param told is called by the thread that received the value, often: it must neither block nor throw
   */
  default void onArrival(Runnable told) {
    // who does not tell is looked at now and then
  }

  /**
   * The messages of a stream that hold until they are replaced, for who records it from now on.
   *
   * @param stream which
   * @return those that its robot interface knows beside the newest one, perhaps none; nothing at all where the values
   * of the stream are no messages of the robot
   */
  default Optional<List<RawMessage>> held(SourceId stream) {
    return Optional.empty();
  }

  /**
   * What a stream has, and if nothing: why.
   *
   * @param stream which
   * @return its state
   */
  InputState state(SourceId stream);

  /**
   * Gives a command. A command that keeps something moving must be renewed within its validity, else the arbiter stops
   * the motion.
   *
   * @param target a command port
   * @param command of the type of the port
   * @param validFor how long it is true; nothing is sent later
   * @return whether the arbiter of the robot took it; refused also where the port or the type is wrong
   */
  CommandOutcome send(SourceId target, Data command, Duration validFor);

  /** Ends all motions that were begun here: their zero is sent. Always possible. */
  void release();

  /**
   * Asks.
   *
   * @param target a call port
   * @param request of the type of the port
   * @param timeout how long to wait
   * @param progress is told how far it is, on a core thread
   * @return the call under way; all outcomes, also that there is no such port, come through its answer
   */
  Call<?> call(SourceId target, Object request, Duration timeout, Progress progress);

  /**
   * Answers what a robot has. Its methods may block, and set parameters only for the holder of the lease.
   *
   * @param port a browse port
   * @return the browser, or none where there is no such port
   */
  Optional<Browser> browser(SourceId port);

  /** Ends all: what was begun here is stopped, streams are left, and what is asked later is refused. */
  @Override
  void close();
}
