package org.robotui.ros2.internal.link;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.message.MessageException;
import org.robotui.message.description.TypeHash;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.log.PeerText;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Listener;
import org.robotui.ros2.Ros2Reception;
import org.robotui.ros2.Ros2Subscriber;
import org.robotui.ros2.Ros2SubscriberOptions;
import org.robotui.ros2.internal.graph.UserData;
import org.robotui.ros2.name.DdsName;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Participant;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Reader;
import org.robotui.rtps.Sample;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A topic that a node subscribes to.
 *
 * @param <T> the Java value of a message
 */
public final class SubscriberLink<T> implements Ros2Subscriber {

  private static final Logger LOG = LoggerFactory.getLogger(SubscriberLink.class);

  private final Ends ends;
  private final Ros2Name topic;
  private final Ros2Codec<T> codec;
  private final Ros2Listener<T> listener;
  private final Reader reader;
  private final AtomicLong received = new AtomicLong();
  private final AtomicLong errors = new AtomicLong();
  private final LogThrottle throttle = new LogThrottle();
  private volatile Unreadable unreadable = Unreadable.NONE;
  private volatile boolean closed;

  /**
   * Announces it.
   *
   * @param ends where it is made
   * @param topic its name
   * @param codec the codec of its messages
   * @param options how to receive
   * @param listener hears of the messages
   */
  public SubscriberLink(Ends ends, Ros2Name topic, Ros2Codec<T> codec, Ros2SubscriberOptions options,
      Ros2Listener<T> listener) {
    this.ends = ends;
    this.topic = topic;
    this.codec = codec;
    this.listener = listener;
    reader = open(options);
  }

  private Reader open(Ros2SubscriberOptions options) {
    Participant participant = ends.participant();
    String name = new DdsName(DdsName.Role.TOPIC, topic).text();
    String type = DdsName.ofType(codec.type());
    ByteBuffer data = UserData.of(codec.hash());
    return options.adapting()
        ? ends.adapting(participant.adaptingReader(name, type, options.qos(), data, this::received))
        : ends.own(participant.reader(name, type, options.qos(), data, this::received));
  }

  private void received(Sample sample) {
    if (closed || sample.kind() != Sample.Kind.ALIVE) {
      return;
    }
    Optional<TypeHash> hash = ends.graph().hash(sample.writer());
    Ros2Reception reception = reception(sample, hash);
    try {
      if (hash.isPresent() && codec.hash().filter(own -> !own.equals(hash.get())).isPresent()) {
        throw new MessageException("its " + codec.type() + " has the sum " + hash.get().brief() + ", the one expected "
            + codec.hash().get().brief() + ": the definitions differ", "", 0);
      }
      T value = codec.decode(reception.raw());
      received.incrementAndGet();
      tell(value, reception);
    } catch (MessageException e) {
      unreadable = new Unreadable(unreadable.count() + 1,
          topic + " from " + reception.from() + ": " + PeerText.brief(String.valueOf(e.getMessage())));
    }
  }

  private Ros2Reception reception(Sample sample, Optional<TypeHash> hash) {
    OptionalLong source =
        sample.sourceNanos() == Sample.NO_TIME ? OptionalLong.empty() : OptionalLong.of(sample.sourceNanos());
    return new Ros2Reception(ends.graph().node(sample.writer()), sample.writer(), sample.sequence(), sample.received(),
        source, sample.payload(), codec.type(), hash, ends.graph().kept(sample.writer()));
  }

  private void tell(T value, Ros2Reception reception) {
    try {
      listener.onMessage(value, reception);
    } catch (RuntimeException e) {
      errors.incrementAndGet();
      if (throttle.admit()) {
        LOG.error("the listener of {} failed ({} times)", topic, throttle.count(), e);
      }
    }
  }

  @Override
  public Ros2Name topic() {
    return topic;
  }

  @Override
  public Qos qos() {
    return reader.info().qos();
  }

  @Override
  public int numPublishers() {
    return reader.matched().size();
  }

  @Override
  public Set<Ros2Name> publishers() {
    return ends.nodes(reader);
  }

  @Override
  public List<String> mismatches() {
    return ends.mismatches(reader);
  }

  @Override
  public long received() {
    return received.get();
  }

  @Override
  public long lost() {
    return reader.statistics().lost();
  }

  @Override
  public Unreadable unreadable() {
    return unreadable;
  }

  @Override
  public long listenerErrors() {
    return errors.get();
  }

  @Override
  public void close() {
    closed = true;
    ends.close(this, reader);
  }
}
