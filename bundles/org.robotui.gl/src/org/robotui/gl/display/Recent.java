package org.robotui.gl.display;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.ToLongFunction;
import java.util.stream.Stream;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.data.FrameId;

/**
 * The newest value of a display, or those of the last seconds, each where it lies, with what was prepared of it.
 * Bounded by the sum of their sizes and by {@link #MOST} values; the oldest make room, the newest always stays. Worker
 * thread.
 *
 * @param <T> the type of the values
 * @param <P> what is prepared of each
 */
public final class Recent<T extends Data, P> {
  /** Values at most. */
  public static final int MOST = 1000;

  private static final float PALE = 0.35f;

  private final Class<T> type;
  private final Anchor.When when;
  private final Function<T, FrameId> frame;
  private final ToLongFunction<T> size;
  private final Deque<Entry<T, P>> entries = new ArrayDeque<>();
  private final Deque<Integer> freeSlots = new ArrayDeque<>();
  private int slots;
  private long total;
  private long dropped;

  /**
   * Without a value.
   *
   * @param type of the values
   * @param when which transform places them
   * @param frame the frame of a value
   * @param size what a value counts against the bound, for example its points
   */
  public Recent(Class<T> type, Anchor.When when, Function<T, FrameId> frame, ToLongFunction<T> size) {
    this.type = type;
    this.when = when;
    this.frame = frame;
    this.size = size;
  }

  /**
   * A value that is kept.
   *
   * @param <T> its type
   * @param <P> what is prepared of it
   */
  public static final class Entry<T extends Data, P> {
    private final Envelope<T> envelope;
    private final int slot;
    private final long size;
    private final Anchor anchor;
    private Optional<P> prepared = Optional.empty();
    private Object preparedFor = "";

    private Entry(Envelope<T> envelope, int slot, long size, Anchor anchor) {
      this.envelope = envelope;
      this.slot = slot;
      this.size = size;
      this.anchor = anchor;
    }

    /**
     * The value as it came.
     *
     * @return the envelope
     */
    public Envelope<T> envelope() {
      return envelope;
    }

    /**
     * The value.
     *
     * @return the value
     */
    public T value() {
      return envelope.value();
    }

    /**
     * A key for its part: that of a value that was forgotten is used again, so that its buffers are.
     *
     * @return a number from 0
     */
    public int slot() {
      return slot;
    }

    /**
     * Where it is.
     *
     * @return its anchor, up to date
     */
    public Anchor anchor() {
      return anchor;
    }

    /**
     * What is prepared of it: made once, and again where what it was made for changed.
     *
     * @param made what it depends on beside the value (settings), with equals
     * @param prepare makes it
     * @return the same object while nothing changed
     */
    public P prepared(Object made, Function<T, P> prepare) {
      if (prepared.isEmpty() || !preparedFor.equals(made)) {
        prepared = Optional.of(prepare.apply(value()));
        preparedFor = made;
      }
      return prepared.get();
    }
  }

  /**
   * Takes what came, forgets what is too old or too much, and places the rest.
   *
   * @param tick of the display
   * @param seconds how long values stay; 0 for the newest only
   * @param most sum of sizes
   */
  public void update(DisplayTick tick, double seconds, long most) {
    if (tick.reset() || tick.state() instanceof InputState.Unconnected) {
      clear();
    }
    arrivals(tick, seconds > 0).forEach(this::add);
    while (entries.size() > 1 && tick.ageSeconds(entries.peekFirst().envelope.receivedNanos()) > seconds) {
      remove();
    }
    while (entries.size() > 1 && (total > most || entries.size() > MOST)) {
      remove();
      dropped++;
    }
    entries.forEach(entry -> entry.anchor.update(tick.places()));
  }

  /**
   * Takes the newest value only.
   *
   * @param tick of the display
   */
  public void update(DisplayTick tick) {
    update(tick, 0, Long.MAX_VALUE);
  }

  /**
   * What is kept.
   *
   * @return oldest first
   */
  public List<Entry<T, P>> entries() {
    return new ArrayList<>(entries);
  }

  /**
   * The newest.
   *
   * @return the newest value, or none
   */
  public Optional<Entry<T, P>> newest() {
    return Optional.ofNullable(entries.peekLast());
  }

  /**
   * Those that were forgotten before their time, as there were too many.
   *
   * @return how many since the beginning
   */
  public long dropped() {
    return dropped;
  }

  /** Forgets all. */
  public void clear() {
    while (!entries.isEmpty()) {
      remove();
    }
  }

  /**
   * How opaque it is to be drawn: paler where the newest is too old to be shown as if it were true.
   *
   * @param tick of the display
   * @return 1, or less
   */
  public static float opacity(DisplayTick tick) {
    return tick.state() instanceof InputState.Stale ? PALE : 1;
  }

  /**
   * How pale what is too old is drawn; for what is drawn of many points, which would cost much more were it
   * transparent.
   *
   * @param tick of the display
   * @return for {@link org.robotui.gl.shape.Material#paled(float)}
   */
  public static float paleness(DisplayTick tick) {
    return 1 - opacity(tick);
  }

  /**
   * How the display is, the gravest first: no data, no frame, too old, a setting that is none.
   *
   * @param tick of the display
   * @param otherwise where all that is well
   * @return the status
   */
  public DisplayStatus status(DisplayTick tick, DisplayStatus otherwise) {
    Optional<DisplayStatus> trouble = newest().flatMap(entry -> entry.anchor.trouble());
    if (entries.isEmpty() || trouble.filter(DisplayStatus.NoFrame.class::isInstance).isPresent()) {
      return trouble.orElseGet(() -> new DisplayStatus.NoData(waiting(tick.state())));
    }
    if (tick.state() instanceof InputState.Stale stale) {
      return new DisplayStatus.TooOld(stale.explanation());
    }
    if (!(otherwise instanceof DisplayStatus.Shown)) {
      return otherwise;
    }
    return ColorSetting.complaint(tick.settings()).<DisplayStatus>map(DisplayStatus.Partly::new).or(() -> trouble)
        .orElse(otherwise);
  }

  private static String waiting(InputState state) {
    return state instanceof InputState.Live ? "no data yet that can be shown" : state.explanation();
  }

  private List<Envelope<T>> arrivals(DisplayTick tick, boolean all) {
    return all
        ? tick.arrived().stream().flatMap(this::mine).toList()
        : tick.newest(type).stream().toList();
  }

  @SuppressWarnings("unchecked") // the value is of the type, and an envelope only gives it out
  private Stream<Envelope<T>> mine(Envelope<? extends Data> envelope) {
    return type.isInstance(envelope.value()) ? Stream.of((Envelope<T>) envelope) : Stream.empty();
  }

  private void add(Envelope<T> envelope) {
    T value = envelope.value();
    int slot = Optional.ofNullable(freeSlots.pollFirst()).orElseGet(() -> slots++);
    Entry<T, P> entry =
        new Entry<>(envelope, slot, size.applyAsLong(value), new Anchor(when, frame.apply(value), envelope.stamp()));
    entries.addLast(entry);
    total += entry.size;
  }

  private void remove() {
    Entry<T, P> oldest = entries.removeFirst();
    total -= oldest.size;
    freeSlots.addLast(oldest.slot);
  }
}
