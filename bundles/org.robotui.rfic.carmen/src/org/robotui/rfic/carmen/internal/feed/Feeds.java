package org.robotui.rfic.carmen.internal.feed;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentSkipListMap;
import org.robotui.carmen.message.IpcForm;
import org.robotui.carmen.module.KnownMessage;

/**
 * The messages that a central knows. Those that somebody handles are listed by it; those of CARMEN's own programs are
 * asked for by name, since who publishes is not in the list. Used by the thread that follows, but for reading and
 * closing.
 */
public final class Feeds implements AutoCloseable {
  /** More are no robot's. */
  private static final int MOST = 512;
  /** What is not there is asked for in every third look. */
  private static final int OWN_EVERY = 3;
  private static final List<String> CARRIERS =
      List.of("carmen_base_odometry", "carmen_localize_globalpos", "carmen_simulator_truepos");
  private static final String WATCH = "V_watch_";
  private static final String OWN = "x_ipc_";

  private final Shared shared;
  private final FeedMaker maker;
  private final Map<String, IpcForm> known = new ConcurrentSkipListMap<>();
  private final Map<String, MessageFeed<?>> feeds = new ConcurrentSkipListMap<>();
  private final Map<String, MapFetching> maps = new ConcurrentSkipListMap<>();
  private volatile Set<String> handled = Set.of();
  private int round;
  private volatile boolean closed;

  public Feeds(Shared shared) {
    this.shared = shared;
    this.maker = new FeedMaker(shared);
  }

  /** Looks what there is now; blocks. */
  public void discover() throws IOException {
    List<String> listed = shared.module().handled();
    handled = Set.copyOf(listed);
    Set<String> names = new HashSet<>(round++ % OWN_EVERY == 0 ? shared.forms().names() : List.of());
    listed.stream().filter(name -> !name.startsWith(WATCH) && !name.startsWith(OWN)).limit(MOST).forEach(names::add);
    for (String name : names) {
      if (!known.containsKey(name) && known.size() < MOST) {
        shared.module().look(name).filter(KnownMessage::plain).ifPresent(found -> add(found.form()));
      }
    }
  }

  private synchronized void add(IpcForm form) {
    known.put(form.name(), form);
    if (!closed && Direction.of(form.name()) == Direction.FROM_ROBOT) {
      MessageFeed<?> feed = maker.make(form);
      feeds.put(form.name(), feed);
      if (form.name().equals(MapFetching.ANSWER)) {
        maps.put(form.name(), new MapFetching(shared, feed));
      }
    }
  }

  /** What is known of all messages. */
  public Map<String, IpcForm> known() {
    return known;
  }

  /** A message. */
  public Optional<IpcForm> find(String name) {
    return Optional.ofNullable(known.get(name));
  }

  /** Whether a program takes it. */
  public boolean isHandled(String name) {
    return handled.contains(name);
  }

  /** Subscribes to what is wanted, and no more; may block. */
  public void tick() throws IOException {
    Collection<MessageFeed<?>> all = new ArrayList<>(feeds.values());
    boolean carry = shared.tree().wanted() || all.stream().anyMatch(MessageFeed::placedAndWanted);
    for (MessageFeed<?> feed : all) {
      boolean carries = carry && CARRIERS.contains(feed.form().name())
          && (shared.settings().truth() || !feed.form().name().equals("carmen_simulator_truepos"));
      feed.tick(feed.wanted() || carries);
    }
    for (MapFetching map : maps.values()) {
      map.tick();
    }
  }

  /** Whether anything of a robot is there. */
  public boolean isEmpty() {
    return feeds.isEmpty();
  }

  @Override
  public synchronized void close() {
    closed = true;
    feeds.values().forEach(MessageFeed::close);
  }
}
