package org.robotui.roboframe.internal;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.robotui.message.MessageException;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageWriter;
import org.robotui.roboframe.board.ChannelKey;
import org.robotui.roboframe.board.Posted;
import org.robotui.roboframe.wire.BoardKey;
import org.robotui.roboframe.wire.BrokerMessage;

/**
 * One key of a blackboard.
 *
 * @param <T> its values
 */
public final class BoardChannel<T> {
  private final ChannelKey<T> key;
  private final List<String> writers = new CopyOnWriteArrayList<>();
  private final List<Reader<T>> readers = new CopyOnWriteArrayList<>();
  private final AtomicLong count = new AtomicLong();
  private volatile Optional<Posted<T>> newest = Optional.empty();

  /** Who reads. */
  public record Reader<T>(String module, Consumer<Posted<T>> taking) {}

  public BoardChannel(ChannelKey<T> key) {
    this.key = key;
  }

  public ChannelKey<T> key() {
    return key;
  }

  /** The same channel, where another key means the same. */
  @SuppressWarnings("unchecked") // the sums of the types are equal, and so are the codecs' values
  public <U> BoardChannel<U> as(ChannelKey<U> other) {
    MessageInfo mine = key.codec().info();
    MessageInfo theirs = other.codec().info();
    if (!mine.type().equals(theirs.type()) || !mine.md5().equals(theirs.md5())
        || key.codec().getClass() != other.codec().getClass()) {
      throw new IllegalArgumentException("the key " + key.name() + " carries " + mine.type() + " here, not "
          + theirs.type());
    }
    return (BoardChannel<U>) this;
  }

  public Optional<Posted<T>> newest() {
    return newest;
  }

  public void add(String writer) {
    writers.add(writer);
  }

  public void remove(String writer) {
    writers.remove(writer);
  }

  public void add(Reader<T> reader) {
    readers.add(reader);
  }

  public void remove(Reader<T> reader) {
    readers.remove(reader);
  }

  /** Of a module here; answers what others are told. */
  public Outgoing post(T value) {
    Posted<T> posted =
        new Posted<>(value, System.currentTimeMillis() * 1_000_000L, count.getAndIncrement(), "");
    accept(posted);
    return outgoing(posted);
  }

  private void accept(Posted<T> posted) {
    newest = Optional.of(posted);
    readers.forEach(reader -> reader.taking().accept(posted));
  }

  /** Of another application. */
  public void came(BrokerMessage.Value value, String from) throws MessageException {
    accept(new Posted<>(key.codec().decode(value.bytes()), value.stampNanos(), value.count(), from));
  }

  /** What stands there and was written here. */
  public Optional<Outgoing> own() {
    return newest.filter(posted -> posted.from().isEmpty()).map(this::outgoing);
  }

  private Outgoing outgoing(Posted<T> posted) {
    return new Outgoing(key.name(), key.every(), () -> {
      MessageWriter out = new MessageWriter();
      key.codec().encode(posted.value(), out);
      return new BrokerMessage.Value(key.name(), posted.stampNanos(), posted.count(),
          ByteBuffer.wrap(out.toByteArray()));
    });
  }

  public boolean isUnused() {
    return writers.isEmpty() && readers.isEmpty();
  }

  public int readers() {
    return readers.size();
  }

  public BoardKey board() {
    MessageInfo info = key.codec().info();
    return new BoardKey(key.name(), info.type(), info.md5(), info.definition(), writers,
        readers.stream().map(Reader::module).toList());
  }
}
