package org.robotui.roblets.body;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyPath;

/**
 * The state of a whole body as one tree. Whoever asks has a snapshot, so that nothing changes while it is looked at.
 * Bounded: {@value #MOST_ROBLETS} roblets, {@value #MOST_MESSAGES} names of messages of each. Safe for all threads.
 */
public final class Bodymap {
  /** As many roblets has a body at most. */
  public static final int MOST_ROBLETS = 128;

  /** As many names have the messages of one roblet at most. */
  public static final int MOST_MESSAGES = 64;

  private final int kept;
  private final Map<String, Deque<BodyEntry>> past = new HashMap<>(); // guarded by this
  private final List<Listening> listeners = new CopyOnWriteArrayList<>();
  private volatile BodySnapshot snapshot = BodySnapshot.EMPTY;

  private record Listening(Optional<BodyPath> path, BodyListener listener) {
    boolean concerns(BodyChange change) {
      return path.isEmpty() || !path.get().elements(BodyElement.of(BodySnapshot.ROOT)
          .with(List.of(BodyElement.of(change.roblet()).with(List.of(change.now().element()))))).isEmpty();
    }
  }

  /**
   * Empty.
   *
   * @param kept how many messages of each name are remembered, 1 to 10,000
   */
  public Bodymap(int kept) {
    if (kept < 1 || kept > 10_000) {
      throw new IllegalArgumentException("a bodymap remembers 1 to 10000 messages of each name, not " + kept);
    }
    this.kept = kept;
  }

  /**
   * What is so now.
   *
   * @return never changes
   */
  public BodySnapshot snapshot() {
    return snapshot;
  }

  /**
   * Takes a message, and tells listeners.
   *
   * @param roblet who said it
   * @param entry what it said
   * @return false where there are too many roblets or names of messages already
   */
  public boolean put(String roblet, BodyEntry entry) {
    BodyChange change;
    synchronized (this) {
      Map<String, BodyEntry> has = snapshot.parts().getOrDefault(roblet, Map.of());
      boolean fits = has.isEmpty() ? snapshot.parts().size() < MOST_ROBLETS
          : has.containsKey(entry.element().name()) || has.size() < MOST_MESSAGES;
      if (!fits) {
        return false;
      }
      Optional<BodyEntry> before = snapshot.entry(roblet, entry.element().name());
      snapshot = snapshot.with(roblet, entry);
      Deque<BodyEntry> remembered = past.computeIfAbsent(key(roblet, entry.element().name()), k -> new ArrayDeque<>());
      remembered.addLast(entry);
      if (remembered.size() > kept) {
        remembered.removeFirst();
      }
      change = new BodyChange(roblet, before, entry, snapshot);
    }
    listeners.stream().filter(l -> l.concerns(change)).forEach(l -> l.listener().changed(change));
    return true;
  }

  private static String key(String roblet, String message) {
    return roblet + "/" + message;
  }

  /**
   * Forgets a roblet with all that it said.
   *
   * @param roblet its name
   */
  public synchronized void remove(String roblet) {
    snapshot.parts().getOrDefault(roblet, Map.of()).keySet().forEach(message -> past.remove(key(roblet, message)));
    snapshot = snapshot.without(roblet);
  }

  /**
   * What a roblet said by one name, up to now.
   *
   * @param roblet who
   * @param message the name of what it said
   * @return the oldest first; as many as are remembered
   */
  public synchronized List<BodyEntry> history(String roblet, String message) {
    return List.copyOf(past.getOrDefault(key(roblet, message), new ArrayDeque<>()));
  }

  /**
   * Tells of all that comes.
   *
   * @param listener hears of it
   * @return ends it
   */
  public Runnable listen(BodyListener listener) {
    return listening(new Listening(Optional.empty(), listener));
  }

  /**
   * Tells of what comes where a path leads.
   *
   * @param path begins with roblets; each message is looked at for itself
   * @param listener hears of it
   * @return ends it
   */
  public Runnable listen(BodyPath path, BodyListener listener) {
    return listening(new Listening(Optional.of(path), listener));
  }

  private Runnable listening(Listening one) {
    listeners.add(one);
    return () -> listeners.remove(one);
  }
}
