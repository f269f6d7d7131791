package org.robotui.uic.topics.internal.model;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.api.UicContext;
import org.robotui.api.port.BrowseInput;
import org.robotui.api.port.Browser.Description;
import org.robotui.api.port.CallException;
import org.robotui.api.port.Input;
import org.robotui.data.Data;
import org.robotui.net.collection.LruMap;
import org.robotui.uic.topics.internal.TopicsPorts;
import org.robotui.uic.topics.internal.model.TopicRow.Counts;

/**
 * Asks the robots in the background, slowly: what they have, and more about what is selected. A robot that takes long
 * is asked less often. The tick starts, the background answers.
 */
final class Poller {
  private static final int MOST_KNOWN = 1000;
  private static final int REST = 3;

  private final BrowseInput browse;
  private final Input<Data> streams;
  private final Executor background;
  private final Lister lister = new Lister();
  private final AtomicBoolean listing = new AtomicBoolean();
  private final AtomicBoolean asked = new AtomicBoolean();
  private final Map<Key, Known> known = new LruMap<>(MOST_KNOWN);
  private volatile Catalog catalog = Catalog.NOTHING;
  private volatile Optional<Described> described = Optional.empty();
  private volatile Optional<Key> selected = Optional.empty();
  private volatile long restUntil;
  private volatile boolean begun;
  private final AtomicLong version = new AtomicLong();

  /** What stays known of a thing that was described. */
  record Known(String type, Counts counts) {}

  Poller(UicContext context) {
    browse = context.browse(TopicsPorts.GRAPH);
    streams = context.input(TopicsPorts.ALL);
    background = context.background();
  }

  /** Asks again soon. Any thread. */
  void refresh() {
    asked.set(true);
  }

  /** Asks where it is time to. */
  void tick(long now, long periodNanos, boolean seen) {
    boolean due = !begun || asked.get() || now - restUntil >= 0;
    if (seen && due && listing.compareAndSet(false, true)) {
      asked.set(false);
      background.execute(() -> list(now, periodNanos));
    }
  }

  /** Describes something, and again each time after what there is was listed. Any thread. */
  void select(Optional<Key> key) {
    if (!selected.equals(key)) {
      selected = key;
      described = key.map(Described::asking);
      version.incrementAndGet();
      key.ifPresent(k -> background.execute(() -> describe(k)));
    }
  }

  Catalog catalog() {
    return catalog;
  }

  Optional<Described> described() {
    return described;
  }

  /** Changes whenever there is something new. */
  long version() {
    return version.get();
  }

  synchronized Optional<Known> known(Key key) {
    return Optional.ofNullable(known.get(key));
  }

  private void list(long now, long periodNanos) {
    long begin = System.nanoTime();
    try {
      Catalog next = lister.list(browse.robots(), streams.candidates());
      if (next != catalog) {
        catalog = next;
        version.incrementAndGet();
      }
      selected.ifPresent(this::describe);
    } finally {
      long took = System.nanoTime() - begin;
      restUntil = now + took + Math.max(periodNanos, REST * took);
      begun = true;
      listing.set(false);
    }
  }

  private void describe(Key key) {
    if (!selected.equals(Optional.of(key))) {
      return;
    }
    Described next = ask(key);
    next.description().ifPresent(d -> remember(key, new Known(next.type(), Facts.counts(key.kind(), d.facts()))));
    if (selected.equals(Optional.of(key)) && !described.equals(Optional.of(next))) {
      described = Optional.of(next);
      version.incrementAndGet();
    }
  }

  private Described ask(Key key) {
    Optional<BrowseInput.Robot> robot =
        browse.robots().stream().filter(r -> r.source().component().equals(key.robot())).findFirst();
    if (robot.isEmpty()) {
      return failed(key, key.robot() + " cannot be asked now");
    }
    try {
      String type = catalog.find(key).map(Entry::type).orElse("");
      Description description = robot.get().browser().describe(key.item(type));
      return new Described(key, Optional.of(description), Facts.of(key, description.facts(), catalog),
          Optional.empty());
    } catch (CallException e) {
      return failed(key, e.getMessage());
    }
  }

  /** What was known before stays, with the reason why it may be old. */
  private Described failed(Key key, String reason) {
    Optional<Described> before = described.filter(d -> d.key().equals(key));
    return new Described(key, before.flatMap(Described::description), before.map(Described::facts).orElse(List.of()),
        Optional.of(reason));
  }

  private synchronized void remember(Key key, Known what) {
    known.put(key, what);
  }
}
