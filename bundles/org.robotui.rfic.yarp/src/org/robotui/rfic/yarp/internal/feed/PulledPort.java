package org.robotui.rfic.yarp.internal.feed;

import java.util.Optional;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.port.MjpegStream;
import org.robotui.yarp.port.PortArrival;
import org.robotui.yarp.port.PortReader;

/** Is connected to by us, as {@code mjpeg} wants it; nobody is told anything. */
final class PulledPort implements PortAsking, PortReader {
  private final Wires wires;
  private final String name;
  private final PortReader reader;
  private Optional<MjpegStream> stream = Optional.empty(); // guarded by this
  private volatile Optional<String> over = Optional.empty();

  PulledPort(Wires wires, String name, PortReader reader) {
    this.wires = wires;
    this.name = name;
    this.reader = reader;
  }

  /** How it went the last time is all that is known at once. */
  @Override
  public synchronized Outcome<String> begin(HostPort where) {
    Optional<String> before = over;
    over = Optional.empty();
    stream.ifPresent(MjpegStream::close);
    stream = Optional.of(new MjpegStream(name, where, this, wires.options(), wires.workers()));
    return before.<Outcome<String>>map(Outcome.Failed::new).orElseGet(() -> new Outcome.Done<>(""));
  }

  @Override
  public synchronized boolean there(HostPort where, boolean connected, long silentNanos) {
    return stream.filter(each -> !each.over()).isPresent();
  }

  @Override
  public synchronized void end(HostPort where) {
    stream.ifPresent(MjpegStream::close);
    stream = Optional.empty();
    over = Optional.empty();
  }

  @Override
  public Optional<Bottle> received(PortArrival arrival) {
    return reader.received(arrival);
  }

  @Override
  public void ended(String from, String reason) {
    over = Optional.of(reason);
    reader.ended(from, reason);
  }
}
