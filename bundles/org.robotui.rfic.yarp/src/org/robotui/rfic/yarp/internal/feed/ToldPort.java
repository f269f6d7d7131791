package org.robotui.rfic.yarp.internal.feed;

import java.time.Duration;
import java.util.List;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;
import org.robotui.yarp.wire.YarpCarrier;

/**
 * Is told to say its messages to our port. Of who does so by datagrams nobody notices that it is gone, so it is asked.
 */
final class ToldPort implements PortAsking {
  private static final long SILENCE_NANOS = Duration.ofSeconds(3).toNanos();

  private final Wires wires;
  private final YarpCarrier carrier;
  private long askedAt = System.nanoTime();

  ToldPort(Wires wires, YarpCarrier carrier) {
    this.wires = wires;
    this.carrier = carrier;
  }

  @Override
  public Outcome<String> begin(HostPort where) {
    askedAt = System.nanoTime();
    return wires.admin().connect(where, carrier, wires.own());
  }

  @Override
  public boolean there(HostPort where, boolean connected, long silentNanos) {
    long now = System.nanoTime();
    if (!connected || !carrier.datagrams() || silentNanos < SILENCE_NANOS || now - askedAt < SILENCE_NANOS) {
      return connected;
    }
    askedAt = now;
    Outcome<List<String>> targets = wires.admin().targets(where);
    return targets instanceof Outcome.Done<List<String>> done && done.value().contains(wires.own());
  }

  @Override
  public void end(HostPort where) {
    wires.admin().disconnect(where, wires.own());
  }
}
