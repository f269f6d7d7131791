package org.robotui.rtps.internal.participant;

import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BiFunction;
import org.robotui.net.collection.LruMap;
import org.robotui.rtps.DiscoveryListener;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.Guid;
import org.robotui.rtps.MatchListener;
import org.robotui.rtps.Mismatch;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Reader;
import org.robotui.rtps.ReaderStatistics;
import org.robotui.rtps.Sample;
import org.robotui.rtps.SampleListener;
import org.robotui.rtps.internal.discovery.DiscoveredParticipants;

/** A reader that is made anew when the writers of its topic offer more or less than before. */
final class AdaptingReader implements Reader, DiscoveryListener {

  private static final int MOST_WRITERS = 1000;

  private final String topic;
  private final String type;
  private final Qos preferred;
  private final DiscoveredParticipants discovered;
  private final BiFunction<Qos, SampleListener, Reader> factory;
  private final SampleListener listener;
  private final List<MatchListener> listeners = new CopyOnWriteArrayList<>();
  /** The last sample of each writer that came. Only the receiving thread uses it. */
  private final Map<Guid, Long> last = new LruMap<>(MOST_WRITERS);
  private volatile Reader reader;
  private ReaderStatistics before = new ReaderStatistics(0, 0, 0, 0, 0, 0, 0, 0);
  private volatile boolean closed;

  private AdaptingReader(String topic, String type, Qos preferred, DiscoveredParticipants discovered,
      BiFunction<Qos, SampleListener, Reader> factory, SampleListener listener) {
    this.topic = topic;
    this.type = type;
    this.preferred = preferred;
    this.discovered = discovered;
    this.factory = factory;
    this.listener = listener;
    this.reader = factory.apply(wanted(preferred), this::received);
  }

  static AdaptingReader open(String topic, String type, Qos preferred, DiscoveredParticipants discovered,
      BiFunction<Qos, SampleListener, Reader> factory, SampleListener listener) {
    AdaptingReader reader = new AdaptingReader(topic, type, preferred, discovered, factory, listener);
    discovered.addListener(reader);
    return reader;
  }

  private boolean concerns(EndpointInfo endpoint) {
    return endpoint.kind() == EndpointKind.WRITER && endpoint.topic().equals(topic) && endpoint.type().equals(type);
  }

  private Qos wanted(Qos without) {
    List<Qos> offered = discovered.endpoints().stream().filter(this::concerns).map(EndpointInfo::qos).toList();
    return offered.isEmpty() ? without : Adaptation.of(preferred, offered);
  }

  @Override
  public void endpointFound(EndpointInfo endpoint) {
    if (concerns(endpoint)) {
      adapt();
    }
  }

  @Override
  public void endpointChanged(EndpointInfo endpoint) {
    endpointFound(endpoint);
  }

  @Override
  public void endpointLost(EndpointInfo endpoint, String reason) {
    endpointFound(endpoint);
  }

  /** Called for one event of discovery after the other, without a lock. */
  private void adapt() {
    Reader old = reader;
    Qos now = old.info().qos();
    Qos wanted = wanted(now);
    if (closed || wanted.equals(now)) {
      return;
    }
    // writers hear of the new one first, so that there is always one
    Reader fresh = factory.apply(wanted, this::received);
    old.close();
    if (replace(old, fresh)) {
      listeners.forEach(fresh::addListener);
    } else {
      fresh.close();
    }
  }

  private synchronized boolean replace(Reader old, Reader fresh) {
    before = sum(before, old.statistics());
    reader = fresh;
    return !closed;
  }

  /** Writers may send what the reader before had already, as it was made anew. */
  private void received(Sample sample) {
    Long highest = last.put(sample.writer(), sample.sequence());
    if (highest != null && highest >= sample.sequence()) {
      last.put(sample.writer(), highest);
    } else {
      listener.received(sample);
    }
  }

  @Override
  public EndpointInfo info() {
    return reader.info();
  }

  @Override
  public List<EndpointInfo> matched() {
    return reader.matched();
  }

  @Override
  public List<Mismatch> mismatches() {
    return reader.mismatches();
  }

  @Override
  public void addListener(MatchListener added) {
    listeners.add(added);
    reader.addListener(added);
  }

  @Override
  public synchronized ReaderStatistics statistics() {
    return sum(before, reader.statistics());
  }

  private static ReaderStatistics sum(ReaderStatistics one, ReaderStatistics other) {
    return new ReaderStatistics(one.received() + other.received(), one.receivedBytes() + other.receivedBytes(),
        one.lost() + other.lost(), one.incomplete() + other.incomplete(), one.damaged() + other.damaged(),
        one.deadlinesMissed() + other.deadlinesMissed(), one.livelinessLost() + other.livelinessLost(),
        one.listenerErrors() + other.listenerErrors());
  }

  @Override
  public void close() {
    discovered.removeListener(this);
    synchronized (this) {
      closed = true;
    }
    reader.close();
  }
}
