package org.robotui.rfic.yarp.internal.feed;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.RawOrigin;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;
import org.robotui.rfic.yarp.internal.convert.BottleRecord;
import org.robotui.yarp.bottle.BottleCodec;
import org.robotui.yarp.bottle.YarpFormatException;
import org.robotui.yarp.port.PortArrival;

/**
 * A port of the robot as streams. It is told to connect to ours only while somebody wants one of them. Messages come on
 * reading threads; {@link #tick} is for the thread that follows the robot.
 */
final class PortFeed implements AutoCloseable {
  static final String ENCODING = "yarp";
  private static final long AGAIN_NANOS = Duration.ofSeconds(1).toNanos();

  private final Wires wires;
  private final String name;
  private final boolean placed;
  private final PortAsking asking;
  private final List<PortOutlet<?>> outlets = new CopyOnWriteArrayList<>();
  private final List<BooleanSupplier> others = new CopyOnWriteArrayList<>();
  private volatile HostPort where;
  private volatile boolean asked;
  private volatile boolean closed;
  private volatile long heardAt = System.nanoTime();
  private long askedAt = System.nanoTime() - AGAIN_NANOS; // only on the thread that follows

  /** Placed where it says something only to those who know where the robot is. */
  PortFeed(Wires wires, String name, HostPort where, boolean placed, PortAsking asking) {
    this.asking = asking;
    this.wires = wires;
    this.name = name;
    this.where = where;
    this.placed = placed;
  }

  <D extends Data> PortOutlet<D> offer(String port, Class<D> type, String help, PortOutlet.Making<D> making) {
    PortOutlet<D> outlet = new PortOutlet<>(wires, port, type, name + ": " + help, making);
    outlets.add(outlet);
    return outlet;
  }

  /** What it says is wanted by others, too, while they say so. */
  void alsoWanted(BooleanSupplier other) {
    others.add(other);
  }

  void at(HostPort now) {
    where = now;
  }

  boolean wanted() {
    return !closed
        && (outlets.stream().anyMatch(PortOutlet::demanded) || others.stream().anyMatch(BooleanSupplier::getAsBoolean));
  }

  boolean placedAndWanted() {
    return placed && wanted();
  }

  /** Acts on what is wanted now, which may block. */
  void tick(boolean needed, boolean connected) {
    long now = System.nanoTime();
    boolean due = needed && !closed && now - askedAt >= AGAIN_NANOS;
    if (due && !asking.there(where, connected, now - heardAt)) {
      askedAt = now;
      asked = true;
      Outcome<String> outcome = asking.begin(where);
      String reason = outcome.reason();
      outlets.forEach(outlet -> outlet.failed(reason.isEmpty() ? "" : name + " does not say anything: " + reason));
    } else if (!needed && asked) {
      letGo();
    }
  }

  /** The robot's port says nothing more to ours; blocks. */
  void letGo() {
    if (asked) {
      asked = false;
      asking.end(where);
      askedAt = System.nanoTime() - AGAIN_NANOS;
    }
  }

  void received(PortArrival arrival) {
    long now = System.nanoTime();
    heardAt = now;
    wires.pulse().heard(now);
    if (!closed) {
      Optional<Stamp> stamp = wires.stamp(arrival.stamp());
      RawMessage raw = raw(arrival);
      outlets.forEach(outlet -> outlet.take(arrival.bottle(), stamp, now, raw));
    }
  }

  void unreadable(String reason) {
    outlets.stream().filter(PortOutlet::demanded).forEach(outlet -> outlet.lost(name + ": " + reason));
  }

  private RawMessage raw(PortArrival arrival) {
    Bytes bytes = Bytes.wrap(arrival.bytes(), 0, arrival.bytes().length);
    return new RawMessage(name, ENCODING, bytes, read -> record(arrival.bytes()),
        new RawOrigin(name, name, false, Optional::empty));
  }

  private Optional<DynamicRecord> record(byte[] bytes) {
    try {
      return Optional.of(new BottleRecord(name, BottleCodec.read(bytes)));
    } catch (YarpFormatException e) {
      return Optional.empty();
    }
  }

  @Override
  public void close() {
    closed = true;
    outlets.forEach(PortOutlet::close);
  }
}
