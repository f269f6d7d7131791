package org.robotui.rtps.internal.participant;

import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.log.PeerText;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.Reader;
import org.robotui.rtps.ReaderStatistics;
import org.robotui.rtps.Sample;
import org.robotui.rtps.SampleListener;
import org.robotui.rtps.internal.endpoint.Change;
import org.robotui.rtps.internal.endpoint.Destination;
import org.robotui.rtps.internal.endpoint.ReaderCore;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A reader with its listener. */
final class LocalReader extends LocalEndpoint implements Reader, ReaderPort {

  private static final Logger LOG = LoggerFactory.getLogger(LocalReader.class);

  private final ReaderCore core;
  private final Switchboard switchboard;
  private final SampleListener listener;
  private final LogThrottle faults = new LogThrottle();
  private final AtomicLong errors = new AtomicLong();
  private volatile boolean closed;

  LocalReader(EndpointInfo info, Matching matching, Switchboard switchboard, ReaderCore core,
      SampleListener listener) {
    super(info, matching);
    this.switchboard = switchboard;
    this.core = core;
    this.listener = listener;
  }

  @Override
  public EntityId entity() {
    return info().guid().entity();
  }

  @Override
  public ReaderCore core() {
    return core;
  }

  @Override
  void connect(EndpointInfo remote, Destination destination) {
    switchboard.connect(remote.guid(), this);
    core.match(remote, destination);
  }

  @Override
  void disconnect(Guid remote) {
    switchboard.disconnect(remote, this);
    core.unmatch(remote);
  }

  @Override
  void end() {
    closed = true;
    matched().forEach(each -> switchboard.disconnect(each.guid(), this));
    core.close();
  }

  @Override
  public void deliver(Guid writer, List<Change> changes) {
    long now = System.nanoTime();
    for (Change change : changes) {
      if (!closed && (change.kind() != Sample.Kind.ALIVE || change.payload().hasRemaining())) {
        deliver(new Sample(change.payload(), change.kind(), writer, change.sequence(), change.sourceNanos(),
            change.related(), now));
      }
    }
  }

  private void deliver(Sample sample) {
    try {
      listener.received(sample);
    } catch (RuntimeException | LinkageError | AssertionError | StackOverflowError e) {
      errors.incrementAndGet();
      if (faults.admit()) {
        LOG.error("the listener of {} threw ({} times so far)", PeerText.name(info().topic()), faults.count(), e);
      }
    }
  }

  @Override
  public ReaderStatistics statistics() {
    return core.statistics(errors.get());
  }
}
