package org.robotui.roboframe.board;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.robotui.message.MessageException;
import org.robotui.roboframe.internal.BoardWatch;
import org.robotui.roboframe.internal.BoardChannel;
import org.robotui.roboframe.internal.Outgoing;
import org.robotui.roboframe.wire.BoardKey;
import org.robotui.roboframe.wire.BrokerFraming;
import org.robotui.roboframe.wire.BrokerMessage;

/**
 * The channels of an application. A key has one type as long as a module uses it; its newest value stands there until
 * no module uses it any more. Values are handed to readers on the thread of whoever writes. What stands there may be
 * old: modules that obey look at its stamp. Safe for all threads.
 */
public final class Blackboard {

  private final Map<String, BoardChannel<?>> channels = new TreeMap<>(); // guarded by this
  private final List<BoardWatch> watches = new CopyOnWriteArrayList<>();

  /** With no key yet. */
  public Blackboard() {
    // keys come with the modules that use them
  }

  /**
   * Announces that a module writes a key.
   *
   * @param key which
   * @param module its name
   * @param <T> the values
   * @return writes it; to be closed
   * @throws IllegalArgumentException where the key carries another type, or there are too many; says so
   */
  public <T> KeyOutput<T> advertise(ChannelKey<T> key, String module) {
    BoardChannel<T> channel;
    synchronized (this) {
      channel = taken(key);
      channel.add(module);
    }
    changed();
    return new ModuleOutput<>(channel, ending(channel, () -> channel.remove(module)));
  }

  private final class ModuleOutput<T> implements KeyOutput<T> {
    private final BoardChannel<T> channel;
    private final KeyUse end;

    ModuleOutput(BoardChannel<T> channel, KeyUse end) {
      this.channel = channel;
      this.end = end;
    }

    @Override
    public void push(T value) {
      Outgoing outgoing = channel.post(value);
      watches.forEach(watch -> watch.posted(outgoing));
    }

    @Override
    public int readers() {
      String key = channel.key().name();
      return channel.readers() + watches.stream().mapToInt(watch -> watch.readers(key)).sum();
    }

    @Override
    public void close() {
      end.close();
    }
  }

  /**
   * Requests the values of a key for a module, also from other applications. What stands there comes at once.
   *
   * @param key which
   * @param module its name
   * @param taking is given each value, on the thread of whoever writes it; must not block
   * @param <T> the values
   * @return revokes it when it is closed
   * @throws IllegalArgumentException where the key carries another type, or there are too many; says so
   */
  public <T> KeyUse request(ChannelKey<T> key, String module, Consumer<Posted<T>> taking) {
    BoardChannel<T> channel;
    BoardChannel.Reader<T> reader = new BoardChannel.Reader<>(module, taking);
    synchronized (this) {
      channel = taken(key);
      channel.add(reader);
    }
    channel.newest().ifPresent(taking);
    changed();
    return ending(channel, () -> channel.remove(reader));
  }

  /** Under the lock until it is used, as it goes when nobody uses it. */
  private <T> BoardChannel<T> taken(ChannelKey<T> key) {
    if (!channels.containsKey(key.name()) && channels.size() >= BrokerFraming.MOST_KEYS) {
      throw new IllegalArgumentException("there are " + BrokerFraming.MOST_KEYS + " keys already");
    }
    return channels.computeIfAbsent(key.name(), name -> new BoardChannel<>(key)).as(key);
  }

  private void changed() {
    watches.forEach(BoardWatch::changed);
  }

  private KeyUse ending(BoardChannel<?> channel, Runnable end) {
    AtomicBoolean ended = new AtomicBoolean();
    return () -> {
      if (ended.compareAndSet(false, true)) {
        leave(channel, end);
        changed();
      }
    };
  }

  private synchronized void leave(BoardChannel<?> channel, Runnable end) {
    end.run();
    if (channel.isUnused()) {
      channels.remove(channel.key().name(), channel);
    }
  }

  /**
   * The newest value of a key.
   *
   * @param key which
   * @param <T> its values
   * @return none where nothing was written
   * @throws IllegalArgumentException where the key carries another type
   */
  public synchronized <T> Optional<Posted<T>> newest(ChannelKey<T> key) {
    return Optional.ofNullable(channels.get(key.name())).flatMap(channel -> channel.as(key).newest());
  }

  /**
   * The keys that are used here.
   *
   * @return sorted by their names
   */
  public synchronized List<BoardKey> keys() {
    return channels.values().stream().map(BoardChannel::board).toList();
  }

  private synchronized Optional<BoardChannel<?>> channel(String key) {
    return Optional.ofNullable(channels.get(key));
  }

  /** Tells a router what happens. */
  void watch(BoardWatch watch) {
    watches.add(watch);
  }

  void unwatch(BoardWatch watch) {
    watches.remove(watch);
  }

  /** What stands at a key and was written here. */
  Optional<Outgoing> own(String key) {
    return channel(key).flatMap(BoardChannel::own);
  }

  /** Takes a value of another application, where somebody reads it. */
  void came(BrokerMessage.Value value, String from) throws MessageException {
    Optional<BoardChannel<?>> channel = channel(value.key()).filter(each -> each.readers() > 0);
    if (channel.isPresent()) {
      channel.get().came(value, from);
    }
  }
}
