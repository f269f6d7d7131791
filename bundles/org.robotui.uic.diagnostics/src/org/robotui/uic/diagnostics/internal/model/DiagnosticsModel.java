package org.robotui.uic.diagnostics.internal.model;

import java.util.Collection;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.LongUnaryOperator;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.data.status.Diagnostics;

/**
 * What the parts of a robot say, and said. The tick is called on one thread; what is to be shown may be asked for on
 * any.
 */
public final class DiagnosticsModel {
  /** In how many slots the time looked back on is divided. */
  public static final int SLOTS = 240;

  private static final long MOST_BYTES = 32L << 20;
  private static final long NANOS_PER_SECOND = 1_000_000_000L;
  private static final int SECONDS_PER_MINUTE = 60;

  private final Input<Diagnostics> input;
  private final History history;
  private final Forest forest;
  private final Timeline overall = new Timeline(SLOTS);
  private final long slotNanos;
  private final LongUnaryOperator aging;
  private final AtomicBoolean forget = new AtomicBoolean();
  private volatile Ask ask = Ask.DEFAULT;
  private volatile Shown shown;
  private long newest;
  private long seenSecond = Long.MIN_VALUE;

  /**
   * Over an input, with how much is looked back on.
   *
   * @param aging translates moments of this machine into the time by which reports grow old
   */
  public DiagnosticsModel(Input<Diagnostics> input, long minutes, LongUnaryOperator aging) {
    this(input, minutes, aging, MOST_BYTES);
  }

  DiagnosticsModel(Input<Diagnostics> input, long minutes, LongUnaryOperator aging, long mostBytes) {
    this.input = input;
    this.aging = aging;
    this.history = new History(mostBytes);
    this.forest = new Forest(history, SLOTS);
    this.slotNanos = minutes * SECONDS_PER_MINUTE * NANOS_PER_SECOND / SLOTS;
    this.shown =
        new Shown(Ask.DEFAULT, List.of(), Map.of(), overall.strip(0), Level.UNKNOWN, Optional.empty(), List.of(),
            Optional.empty(), 0, 0, slotNanos * 1e-9, 0, 0);
  }

  /** Takes what came, and prepares what is shown. Whether there is something new. */
  public boolean tick(long nowNanos, double staleSeconds) {
    long now = aging.applyAsLong(nowNanos);
    long stale = (long) (staleSeconds * NANOS_PER_SECOND);
    int taken = input
        .drain(e -> e.value().items().forEach(item -> take(e.source(), item, aging.applyAsLong(e.receivedNanos()))));
    boolean forgotten = forget.getAndSet(false);
    if (forgotten) {
      forest.forgetSilent(now, stale);
    }
    long slot = Math.floorDiv(now, slotNanos);
    boolean changed = mark(now, stale, slot);
    Ask asked = ask;
    boolean news = taken > 0 || forgotten || changed || !asked.equals(shown.ask())
        || seenSecond != Math.floorDiv(now, NANOS_PER_SECOND);
    if (news) {
      seenSecond = Math.floorDiv(now, NANOS_PER_SECOND);
      shown = shown(asked, now, stale, slot);
    }
    return news;
  }

  /** What is to be shown from the next tick on. */
  public void ask(Ask next) {
    ask = next;
  }

  /** What was asked for. */
  public Ask ask() {
    return ask;
  }

  /** Forgets at the next tick all parts that are silent. */
  public void forgetSilent() {
    forget.set(true);
  }

  /** What the last tick left. */
  public Shown current() {
    return shown;
  }

  long historyBytes() {
    return history.bytes();
  }

  private void take(SourceId source, Diagnostics.Item item, long nanos) {
    newest = nanos;
    forest.take(source, item, nanos);
  }

  private boolean mark(long now, long stale, long slot) {
    int[] changes = {0};
    forest.trees().values().forEach(tree -> tree.root().bubble(now, stale, slot, changes));
    overall.mark(slot, worst(roots(ask.source(), now, stale)));
    return changes[0] > 0;
  }

  private static Level worst(Collection<Node> roots) {
    return roots.stream().map(Node::level).reduce(Level.UNKNOWN, Level::worse);
  }

  private List<Node> roots(String asked, long now, long stale) {
    Map<SourceId, Forest.Tree> trees = forest.trees();
    return SourceChoice.choose(asked, trees, now, stale).map(source -> List.of(trees.get(source).root()))
        .orElseGet(() -> trees.values().stream().map(Forest.Tree::root).toList());
  }

  private Shown shown(Ask asked, long now, long stale, long slot) {
    Optional<Long> moment = asked.slot().filter(s -> s <= slot && s > slot - SLOTS);
    Reader reader = new Reader(now, stale, moment, slotNanos);
    List<Node> roots = roots(asked.source(), now, stale);
    RowBuilder builder = new RowBuilder(asked, reader, slot);
    if (roots.size() == 1) {
      roots.getFirst().children().forEach(node -> builder.add(node, 0));
    } else {
      roots.forEach(node -> builder.add(node, 0));
    }
    Details details = new Details(reader, slot);
    Optional<DiagnosticsDetail> detail =
        asked.selected().flatMap(key -> roots.stream().flatMap(r -> details.of(r, key).stream()).findFirst());
    Map<Level, Integer> counts = counts(roots, reader);
    return new Shown(asked.at(moment), builder.rows(), counts, overall.strip(slot),
        moment.map(overall::level).orElseGet(() -> worst(roots)), detail,
        forest.trees().keySet().stream().map(SourceId::toString).toList(),
        roots.size() == 1 ? Optional.of(roots.getFirst().key()) : Optional.empty(),
        counts.values().stream().mapToInt(Integer::intValue).sum(), forest.refused(), slotNanos * 1e-9,
        newest * 1e-9, now);
  }

  private static Map<Level, Integer> counts(Collection<Node> roots, Reader reader) {
    Map<Level, Integer> counts = new EnumMap<>(Level.class);
    roots.forEach(root -> count(root, reader, counts));
    return Map.copyOf(counts);
  }

  private static void count(Node node, Reader reader, Map<Level, Integer> counts) {
    if (node.children().isEmpty() && node.part().isPresent()) {
      counts.merge(reader.level(node), 1, Integer::sum);
    }
    node.children().forEach(child -> count(child, reader, counts));
  }
}
