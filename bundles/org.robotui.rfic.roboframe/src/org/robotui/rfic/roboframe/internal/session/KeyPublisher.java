package org.robotui.rfic.roboframe.internal.session;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.robotui.message.MessageCodec;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageWriter;
import org.robotui.message.topic.TopicPublisher;
import org.robotui.roboframe.link.BrokerLink;
import org.robotui.roboframe.wire.BoardKey;
import org.robotui.roboframe.wire.BrokerMessage;

/**
 * A key that is written for somebody.
 *
 * @param <M> its values
 */
final class KeyPublisher<M> implements TopicPublisher<M> {
  private static final long MILLION = 1_000_000;

  private final BrokerLink link;
  private final BoardKey key;
  private final MessageCodec<M> codec;
  private final Manner manner;
  private final Consumer<KeyPublisher<M>> end;
  private final AtomicLong count = new AtomicLong();
  private volatile Optional<OfferedKey> reader = Optional.empty();
  private Optional<BrokerMessage.Value> last = Optional.empty(); // guarded by this

  /** What becomes of values that the application does not take at once, or asks for later. */
  enum Manner {
    /** Only the newest counts, and only now. */
    COMMAND,
    /** All count, in turn. */
    MESSAGE,
    /** As messages; the last is given to modules that ask later. */
    KEPT
  }

  KeyPublisher(BrokerLink link, String name, MessageCodec<M> codec, Manner manner, Consumer<KeyPublisher<M>> end) {
    MessageInfo info = codec.info();
    this.link = link;
    this.codec = codec;
    this.manner = manner;
    this.end = end;
    this.key = new BoardKey(name, info.type(), info.md5(), info.definition(), List.of(RoboframeTopics.NAME), List.of());
  }

  BoardKey key() {
    return key;
  }

  /** Notes whether a module of the application reads it now. */
  synchronized void follow(Optional<OfferedKey> now) {
    boolean begins = subscribers() == 0;
    reader = now;
    if (begins && subscribers() > 0) {
      last.ifPresent(link::queue);
    }
  }

  @Override
  public int subscribers() {
    return link.over().isPresent() ? 0
        : reader.filter(each -> each.key().carriesWhat(key)).map(each -> each.key().readers().size()).orElse(0);
  }

  @Override
  public Optional<String> obstacle() {
    return reader.filter(each -> !each.key().carriesWhat(key)).map(each -> "the application's definition of "
        + each.key().type() + " at " + each.key().name() + " is another one than ours of " + key.type());
  }

  @Override
  public void publish(M message) {
    BrokerMessage.Value value = value(message);
    synchronized (this) {
      last = manner == Manner.KEPT ? Optional.of(value) : Optional.empty();
    }
    if (subscribers() == 0) {
      return;
    }
    if (manner == Manner.COMMAND) {
      link.push(value);
    } else {
      link.queue(value);
    }
  }

  private BrokerMessage.Value value(M message) {
    MessageWriter out = new MessageWriter();
    codec.encode(message, out);
    return new BrokerMessage.Value(key.name(), System.currentTimeMillis() * MILLION, count.getAndIncrement(),
        ByteBuffer.wrap(out.toByteArray()));
  }

  @Override
  public void publishUrgently(M message) {
    if (subscribers() > 0) {
      link.push(value(message));
    }
  }

  @Override
  public void awaitSent(Duration patience) {
    // what the link has taken is sent also when the key is given up
  }

  @Override
  public void close() {
    end.accept(this);
  }
}
