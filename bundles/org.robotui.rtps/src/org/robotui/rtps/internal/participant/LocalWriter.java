package org.robotui.rtps.internal.participant;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;
import java.util.OptionalLong;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.Guid;
import org.robotui.rtps.Sample;
import org.robotui.rtps.SampleIdentity;
import org.robotui.rtps.Writer;
import org.robotui.rtps.WriterStatistics;
import org.robotui.rtps.internal.endpoint.Destination;
import org.robotui.rtps.internal.endpoint.SourceClock;
import org.robotui.rtps.internal.endpoint.WriterCore;

/** A writer. */
final class LocalWriter extends LocalEndpoint implements Writer {

  private final WriterCore core;
  private final Switchboard switchboard;
  private final int mostBytes;

  LocalWriter(EndpointInfo info, Matching matching, Switchboard switchboard, WriterCore core, int mostBytes) {
    super(info, matching);
    this.switchboard = switchboard;
    this.core = core;
    this.mostBytes = mostBytes;
    switchboard.add(info.guid().entity(), core);
  }

  WriterCore core() {
    return core;
  }

  @Override
  void connect(EndpointInfo remote, Destination destination) {
    core.match(remote, destination);
  }

  @Override
  void disconnect(Guid remote) {
    core.unmatch(remote);
  }

  @Override
  void end() {
    switchboard.remove(info().guid().entity());
    core.close();
  }

  @Override
  public OptionalLong write(ByteBuffer payload) {
    return write(copy(payload), Optional.empty());
  }

  @Override
  public OptionalLong write(ByteBuffer payload, SampleIdentity related) {
    return write(copy(payload), Optional.of(related));
  }

  @Override
  public OptionalLong writeKept(ByteBuffer payload) {
    return write(payload.slice(), Optional.empty());
  }

  private static ByteBuffer copy(ByteBuffer payload) {
    byte[] bytes = new byte[payload.remaining()];
    payload.get(payload.position(), bytes);
    return ByteBuffer.wrap(bytes);
  }

  private OptionalLong write(ByteBuffer payload, Optional<SampleIdentity> related) {
    if (payload.remaining() > mostBytes) {
      throw new IllegalArgumentException(
          "a sample of " + payload.remaining() + " bytes on " + info().topic() + "; at most " + mostBytes
              + " are sent");
    }
    return core.write(Sample.Kind.ALIVE, payload, SourceClock.nanos(), related, Optional.empty());
  }

  @Override
  public void assertLiveliness() {
    core.assertAlive();
  }

  @Override
  public boolean awaitAcknowledged(Duration timeout) throws InterruptedException {
    return core.awaitAcknowledged(timeout);
  }

  @Override
  public WriterStatistics statistics() {
    return core.statistics();
  }
}
