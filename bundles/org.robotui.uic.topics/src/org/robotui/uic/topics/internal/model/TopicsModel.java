package org.robotui.uic.topics.internal.model;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.robotui.api.UicContext;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.record.DynamicRecord;
import org.robotui.ui.ask.Measure;
import org.robotui.ui.ask.Presence;
import org.robotui.uic.topics.internal.TopicsOptions;
import org.robotui.uic.topics.internal.TopicsPorts;

/**
 * What robots have, what the chosen topics carry, and saying messages. The tick prepares all that is seen; wishes may
 * be said on any thread and count from the next tick on.
 */
public final class TopicsModel {
  private static final long SEEN_NANOS = 3_000_000_000L;
  private static final long HEARTBEAT_NANOS = 1_000_000_000L;
  private static final long FRAME_NANOS = 100_000_000L;
  private static final long FIGURES_NANOS = 500_000_000L;

  private final Poller poller;
  private final Watched watched;
  private final Presence presence;
  private final Speaker speaker;
  private final RowMaker maker;
  private final RecordedTopic recorded;
  private final Listed listed = new Listed();
  private final Due frame = new Due(FRAME_NANOS);
  private final Due heartbeat = new Due(HEARTBEAT_NANOS);
  private final Due figures = new Due(FIGURES_NANOS);
  private volatile UnaryOperator<List<TopicRow>> sorting = List::copyOf;
  private volatile Wishes wishes = Wishes.FIRST;
  private volatile long seenAt;
  private volatile boolean seen;
  private volatile String refusal = "";
  private volatile TopicsViewState look;
  private Map<Key, Measure> measures = Map.of();
  private long version = -1;
  private boolean heard;

  /** With what core gives to the view. */
  public TopicsModel(UicContext context) {
    poller = new Poller(context);
    watched = new Watched(context.input(TopicsPorts.ALL));
    presence = new Presence(context, TopicsPorts.GRAPH, "what it has");
    speaker = new Speaker(context.output(TopicsPorts.PUBLISH), context.principal());
    maker = new RowMaker(poller::known);
    recorded = new RecordedTopic(context.input(TopicsPorts.ALL), context.background());
    look = look(presence.state(Set.of(), Map.of()), TopicsViewState.Echo.NOTHING, MessageListing.NOTHING);
  }

  /** Takes what came and prepares what is seen; whether there is something new to show. */
  public boolean tick(long now, TopicsOptions options) {
    Wishes wanted = wishes;
    speaker.tick(now);
    heard |= watched.drain(options.history(), wanted) > 0;
    boolean asked = !look.wishes().equals(wanted) || version != poller.version();
    if (!asked && !frame.passed(now)) {
      return false;
    }
    frame.mark(now);
    boolean visible = seen && now - seenAt < SEEN_NANOS;
    poller.tick(now, options.period().toNanos(), visible);
    return prepare(now, wanted, visible);
  }

  private boolean prepare(long now, Wishes wanted, boolean visible) {
    version = poller.version();
    Catalog catalog = poller.catalog();
    watched.follow(catalog, visible ? wanted : wanted.quiet());
    if (figures.passed(now)) {
      figures.mark(now);
      measures = watched.measures(catalog, wanted, now);
    }
    listed.follow(catalog, wanted);
    TopicsViewState next = look(presence.state(catalog.known(), catalog.failures()), echo(catalog, wanted),
        messages(catalog, visible ? wanted : wanted.quiet()));
    boolean beat = heartbeat.passed(now);
    boolean changed = beat || heard || next.speech().hertz().isPresent() || !same(next, look);
    if (beat) {
      heartbeat.mark(now);
    }
    heard = false;
    look = next;
    return changed;
  }

  /** What the last tick prepared. */
  public TopicsViewState look() {
    return look;
  }

  /** Says messages. */
  public Speaker speaker() {
    return speaker;
  }

  /** Why no message can be said on the selected topic, empty where one can be. */
  public String silenced(Described described) {
    return Obstacles.publish(described, speaker);
  }

  /** The view is seen now: robots are asked for as long as it is. */
  public void seen(long now) {
    seenAt = now;
    seen = true;
  }

  /** The view is not seen any more: nothing is asked for. */
  public void gone() {
    seen = false;
    speaker.stop("the view was closed");
    wishes(w -> w.echo(Optional.empty()).list(Optional.empty()));
  }

  /** How rows are sorted from the next tick on. */
  public void sorting(UnaryOperator<List<TopicRow>> order) {
    sorting = order;
    listed.again = true;
  }

  /** Asks the robots again soon. */
  public void refresh() {
    poller.refresh();
  }

  /**
   * Lists another kind, and only what contains all these words. What is then not in the list is not selected any more.
   */
  public void list(Kind kind, String words) {
    wishes(w -> w.section(kind).filter(words));
    Catalog catalog = poller.catalog();
    boolean gone =
        wishes.selected().flatMap(catalog::find).filter(entry -> !RowMaker.lists(kind, words, entry)).isPresent();
    if (gone) {
      select(Optional.empty());
    }
  }

  /** The topic that a stream carries, as soon as it is known. */
  public Optional<Key> topic(SourceId stream) {
    return poller.catalog().of(Kind.TOPIC).stream().filter(entry -> entry.stream().filter(stream::equals).isPresent())
        .map(Entry::key).findFirst();
  }

  /** A program by the robot's name of it, as soon as it is known. */
  public Optional<Key> node(String name) {
    return poller.catalog().of(Kind.NODE).stream().map(Entry::key).filter(key -> key.name().equals(name)).findFirst();
  }

  /** What is selected. */
  public Optional<Key> selected() {
    return wishes.selected();
  }

  /** Describes a thing. */
  public void select(Optional<Key> key) {
    wishes(w -> w.select(key));
    poller.select(key);
  }

  /** Shows the messages of a topic in place of those of another. */
  public void echo(Optional<Key> key) {
    wishes(w -> w.echo(key));
  }

  /** Lists all messages of a topic of a recording in place of those of another. */
  public void listMessages(Optional<Key> key) {
    wishes(w -> w.list(key));
  }

  /** Holds the echo, or lets it go on. */
  public void pause(boolean held) {
    wishes(w -> w.pause(held, OptionalLong.empty()));
  }

  /** Shows one message of the history; the echo is held by that. */
  public void pin(long number) {
    wishes(w -> w.pause(true, OptionalLong.of(number)));
  }

  /** Begins or ends measuring a topic; too many at once are refused, and the reason shown. */
  public void measure(Key key, boolean on, int most) {
    wishes(w -> {
      Set<Key> keys = new HashSet<>(w.measured());
      boolean full = on && !keys.contains(key) && keys.size() >= most;
      refusal = full
          ? most + (most == 1 ? " topic is" : " topics are") + " measured already; end one first, or raise max_measured"
          : "";
      if (on && !full) {
        keys.add(key);
      } else {
        keys.remove(key);
      }
      return w.measure(keys);
    });
  }

  /** Gives up what it asked for. */
  public void close() {
    speaker.stop("the view was closed");
    watched.close();
  }

  /** How many things were looked at so far, for tests of what it costs. */
  long looked() {
    return maker.looked();
  }

  private synchronized void wishes(UnaryOperator<Wishes> change) {
    wishes = change.apply(wishes);
  }

  private TopicsViewState.Echo echo(Catalog catalog, Wishes wanted) {
    Optional<Key> key = wanted.echoed().or(wanted::selected);
    String obstacle = key.map(k -> Obstacles.echo(k, catalog.find(k), poller.described())).orElse("");
    Optional<Heard> shown = watched.shown(wanted.pinned());
    InputState state = watched.state().orElseGet(() -> new InputState.Unconnected(obstacle));
    Optional<DynamicRecord> record = shown.map(h -> look.echo().shown().equals(shown)
        ? look.echo().record().orElseGet(() -> h.envelope().record())
        : h.envelope().record());
    return new TopicsViewState.Echo(watched.echoed(), obstacle, state, shown, record, watched.history().all(),
        watched.history().count(),
        watched.history().missed(), wanted.echoed().map(measures::get).orElse(Measure.NOTHING));
  }

  private MessageListing messages(Catalog catalog, Wishes wanted) {
    Optional<Key> key = wanted.listed();
    String obstacle = key.map(k -> Obstacles.echo(k, catalog.find(k), poller.described())).orElse("");
    return recorded.follow(key.flatMap(catalog::find).flatMap(Entry::stream), obstacle);
  }

  private TopicsViewState look(InputState state, TopicsViewState.Echo echo, MessageListing messages) {
    Catalog catalog = poller.catalog();
    String notice = refusal.isEmpty() ? Presence.notice(state, catalog.failures()) : refusal;
    return new TopicsViewState(listed.wishes, state, listed.rows, listed.counts,
        catalog.of(listed.wishes.section()).size(), notice,
        poller.described(), echo, speaker.look(), watched.streams(), messages);
  }

  /** Rows and records are compared by identity: they are made anew only where something changed. */
  private static boolean same(TopicsViewState one, TopicsViewState other) {
    return one.rows() == other.rows() && one.counts() == other.counts() && one.wishes().equals(other.wishes())
        && one.state().equals(other.state()) && one.notice().equals(other.notice())
        && one.described() == other.described()
        && one.echo().state().getClass() == other.echo().state().getClass()
        && one.echo().obstacle().equals(other.echo().obstacle())
        && one.echo().shown().equals(other.echo().shown()) && one.speech().equals(other.speech())
        && one.streams() == other.streams() && one.messages() == other.messages();
  }

  /** The rows, made again only where something that they show changed. The tick's thread. */
  private final class Listed {
    private Wishes wishes = Wishes.FIRST;
    private List<TopicRow> rows = List.of();
    private Map<Kind, Integer> counts = Map.of();
    private Catalog from = Catalog.NOTHING;
    private Map<Key, Measure> shown = Map.of();
    private long known = -1;
    private volatile boolean again;

    void follow(Catalog catalog, Wishes wanted) {
      boolean filtered = catalog != from || !wanted.filter().equals(wishes.filter());
      boolean stale = filtered || again || wanted.section() != wishes.section() || known != version
          || !wanted.measured().equals(wishes.measured())
          || shown != measures && !(shown.isEmpty() && measures.isEmpty());
      if (filtered || counts.isEmpty()) {
        counts = maker.counts(catalog, wanted.filter());
      }
      if (stale) {
        again = false;
        rows = sorting.apply(maker.rows(catalog, wanted, measures));
      }
      wishes = wanted;
      from = catalog;
      shown = measures;
      known = version;
    }
  }

  /** Something that is done again after a while. */
  private static final class Due {
    private final long period;
    private long last;
    private boolean ever;

    Due(long period) {
      this.period = period;
    }

    boolean passed(long now) {
      return !ever || now - last >= period;
    }

    void mark(long now) {
      last = now;
      ever = true;
    }
  }
}
