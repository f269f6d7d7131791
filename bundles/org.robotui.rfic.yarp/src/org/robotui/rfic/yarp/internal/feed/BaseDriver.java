package org.robotui.rfic.yarp.internal.feed;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.port.CommandSink;
import org.robotui.data.command.VelocityCommand;
import org.robotui.net.socket.HostPort;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.BottleCodec;
import org.robotui.yarp.bottle.YarpValue;
import org.robotui.yarp.port.PortStream;
import org.robotui.yarp.wire.YarpCarrier;
import org.robotui.yarp.wire.YarpMessage;

/**
 * Drives a base by the port that takes its velocities: forward, sideways, and how it turns in degrees per second. The
 * connection is made with the first command, and by tcp, so that one message at most is under way.
 */
final class BaseDriver implements CommandSink<VelocityCommand>, AutoCloseable {
  private static final Duration LASTS = Duration.ofMillis(500);
  private static final String KIND = "velocity";

  private final Wires wires;
  private final String name;
  private final Supplier<HostPort> where;
  private final Runnable halting;
  private Optional<PortStream> stream = Optional.empty(); // guarded by this, as the following
  private boolean moving;
  private boolean closed;

  BaseDriver(Wires wires, String name, Supplier<HostPort> where, Runnable halting) {
    this.halting = halting;
    this.wires = wires;
    this.name = name;
    this.where = where;
  }

  @Override
  public synchronized Sent send(VelocityCommand command) {
    boolean stops = command.equals(VelocityCommand.ZERO);
    long silence = stops ? 0 : wires.pulse().silentFor(System.nanoTime());
    if (closed) {
      return new Sent.Refused(name + " is no longer connected");
    }
    if (silence > 0) {
      return new Sent.Refused(String.format(Locale.ROOT,
          "the robot has not been heard for %.1f s; nothing is sent into a network that may keep it", silence / 1e9));
    }
    Optional<String> over = stream.flatMap(PortStream::over);
    if (over.isPresent()) {
      stream = Optional.empty();
    }
    if (over.isPresent() && !stops) {
      return new Sent.Refused(name + " does not take velocities: " + over.get());
    }
    boolean sent = connected().post(KIND, message(command), stops ? Duration.ZERO : LASTS);
    moving = sent ? !stops : moving;
    return sent ? new Sent.Out() : new Sent.Refused(name + " does not take anything more");
  }

  /** Goals that we sent would let it drive on. */
  @Override
  public Sent stop(VelocityCommand zero, boolean ours) {
    halting.run();
    return send(zero);
  }

  private PortStream connected() {
    if (stream.isEmpty()) {
      stream = Optional.of(
          new PortStream(where.get(), YarpCarrier.TCP, wires.own() + "/velocity", wires.options(), wires.workers()));
    }
    return stream.get();
  }

  private static YarpMessage message(VelocityCommand command) {
    return YarpMessage.of(BottleCodec.bytes(new Bottle(List.of(real(command.linear().x()), real(command.linear().y()),
        real(Math.toDegrees(command.angular().z()))), 0)));
  }

  private static YarpValue real(double value) {
    return new YarpValue.Real(value, Double.SIZE);
  }

  /** Stops what we drive; a base that others drive is left alone. */
  @Override
  public synchronized void close() {
    if (moving && !closed && stream.isPresent()) {
      moving = false;
      stream.get().post(KIND, message(VelocityCommand.ZERO), Duration.ZERO);
    }
    closed = true;
    stream.ifPresent(PortStream::close);
  }
}
