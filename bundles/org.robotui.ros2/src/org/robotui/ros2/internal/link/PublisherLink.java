package org.robotui.ros2.internal.link;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.robotui.net.thread.Uninterruptibles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Publisher;
import org.robotui.ros2.internal.graph.UserData;
import org.robotui.ros2.name.DdsName;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Durability;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Writer;

/**
 * A topic that a node publishes.
 *
 * @param <T> the Java value of a message
 */
public final class PublisherLink<T> implements Ros2Publisher<T> {

  /** What is longer is not copied; shorter ones would keep a buffer that may be far longer than they are. */
  private static final int LARGE = 16 << 10;

  private final Ends ends;
  private final Ros2Name topic;
  private final Ros2Codec<T> codec;
  private final Qos qos;
  private final Writer writer;
  private volatile boolean closed;

  /**
   * Announces it.
   *
   * @param ends where it is made
   * @param topic its name
   * @param codec the codec of its messages
   * @param qos what is offered
   */
  public PublisherLink(Ends ends, Ros2Name topic, Ros2Codec<T> codec, Qos qos) {
    this.ends = ends;
    this.topic = topic;
    this.codec = codec;
    this.qos = qos;
    writer = ends.own(ends.participant().writer(new DdsName(DdsName.Role.TOPIC, topic).text(),
        DdsName.ofType(codec.type()), qos, UserData.of(codec.hash())));
  }

  @Override
  public boolean publish(T message) {
    if (qos.durability() == Durability.VOLATILE && writer.matched().isEmpty()) {
      return true;
    }
    ByteBuffer bytes = codec.encode(message);
    return (bytes.remaining() < LARGE ? writer.write(bytes) : writer.writeKept(bytes)).isPresent();
  }

  @Override
  public boolean awaitSent(Duration patience) {
    boolean[] sent = {false};
    Uninterruptibles.await(System.nanoTime() + patience.toNanos(),
        nanos -> sent[0] = writer.awaitAcknowledged(Duration.ofNanos(Math.max(0, nanos))));
    return sent[0];
  }

  @Override
  public Ros2Name topic() {
    return topic;
  }

  @Override
  public Qos qos() {
    return qos;
  }

  @Override
  public int numSubscribers() {
    return closed ? 0 : writer.matched().size();
  }

  @Override
  public Set<Ros2Name> subscribers() {
    return ends.nodes(writer);
  }

  @Override
  public List<String> mismatches() {
    return ends.mismatches(writer);
  }

  @Override
  public void close() {
    closed = true;
    ends.close(this, writer);
  }
}
