package org.robotui.api.session;

import java.util.Locale;
import org.robotui.api.link.Pulse;
import org.robotui.api.port.CommandSink;
import org.robotui.data.command.VelocityCommand;

/**
 * Drives a base by velocities: nothing is sent after the end, nor into a network that may keep it, and what we drive is
 * stopped at the end. Safe for all threads.
 */
public final class BaseDriving implements CommandSink<VelocityCommand>, AutoCloseable {
  private static final double NANOS = 1e9;

  private final String peer;
  private final Pulse pulse;
  private final Base base;
  private boolean moving; // guarded by this, as the following
  private boolean closed;

  /** How a framework drives it. */
  public interface Base {
    /**
     * Sends a velocity; does not block.
     *
     * @param command zero stops
     * @return whether it is on its way
     */
    Sent drive(VelocityCommand command);

    /**
     * Stops for a stop of the robot, and whatever would drive on otherwise.
     *
     * @param zero the velocity
     * @return whether it is on its way
     */
    default Sent halt(VelocityCommand zero) {
      return drive(zero);
    }
  }

  /**
   * Of a robot.
   *
   * @param peer for users
   * @param pulse whether it is heard
   * @param base drives it
   */
  public BaseDriving(String peer, Pulse pulse, Base base) {
    this.peer = peer;
    this.pulse = pulse;
    this.base = base;
  }

  @Override
  public synchronized Sent send(VelocityCommand command) {
    boolean stops = command.equals(VelocityCommand.ZERO);
    long silence = stops ? 0 : pulse.silentFor(System.nanoTime());
    if (closed) {
      return new Sent.Refused(peer + " is no longer connected");
    }
    if (silence > 0) {
      return new Sent.Refused(String.format(Locale.ROOT,
          "the robot has not been heard for %.1f s; nothing is sent into a network that may keep it",
          silence / NANOS));
    }
    Sent sent = base.drive(command);
    moving = sent instanceof Sent.Out ? !stops : moving;
    return sent;
  }

  @Override
  public synchronized Sent stop(VelocityCommand zero, boolean ours) {
    if (closed) {
      return new Sent.Refused(peer + " is no longer connected");
    }
    moving = false;
    return base.halt(zero);
  }

  /** Stops what we drive; later calls do nothing. */
  @Override
  public synchronized void close() {
    if (moving && !closed) {
      moving = false;
      base.drive(VelocityCommand.ZERO);
    }
    closed = true;
  }
}
