package org.robotui.rfic.recording.internal.session;

import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.robotui.api.replay.Lane;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.TrackId;
import org.robotui.api.time.ClockSource;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingDamage;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingReader;
import org.robotui.rfic.recording.internal.time.PlayedTrack;
import org.robotui.rfic.recording.internal.time.SearchableHistory;
import org.robotui.rfic.recording.internal.time.Seat;
import org.robotui.rfic.recording.internal.time.Turn;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads a recording on a thread of its own, and delivers its messages at their times. It reads one message ahead, out
 * of chunks of which a bounded number is in memory.
 */
final class TrackPlayer implements PlayedTrack {
  private static final Logger LOG = LoggerFactory.getLogger(TrackPlayer.class);

  private final TrackId id;
  private final RecordingReader recording;
  private final TimeRange span;
  private final Supplier<List<Lane>> lanes;
  private final Supplier<SearchableHistory> history;
  private final PlayedContext context;
  private final ClockSource clock;
  private final PastMessages past;
  private final CompletableFuture<String> ended = new CompletableFuture<>();
  private final Object gate = new Object();
  private volatile Supplier<List<Reception<?>>> wanted = List::of;
  private volatile Optional<Seat> seat = Optional.empty();
  private volatile long now;
  private Set<Reception<?>> known = Set.of();
  private Optional<RecordedMessage> next = Optional.empty();
  private Optional<RecordingCursor> cursor = Optional.empty();
  private long delivered;

  /**
   * At the start of a recording.
   *
   * @param context what core gives
   * @param recording is read
   * @param span of its messages
   * @param lanes what is known of its topics
   * @param history reads all of it
   */
  TrackPlayer(PlayedContext context, RecordingReader recording, TimeRange span, Supplier<List<Lane>> lanes,
      Supplier<SearchableHistory> history) {
    this.id = new TrackId(context.robot(), context.instance());
    this.context = context;
    this.clock = context.core().clock();
    this.recording = recording;
    this.span = span;
    this.lanes = lanes;
    this.history = history;
    this.past = new PastMessages(recording);
    this.now = span.start();
    this.delivered = span.start() - 1;
    clock.replayed(now);
  }

  /** What time it is in the recording. */
  long now() {
    return now;
  }

  /** Where it lies on the timeline. */
  long offset() {
    return seat.map(Seat::offset).orElse(0L);
  }

  /** Completes with the reason where the recording cannot be read any more. */
  CompletableFuture<String> ended() {
    return ended;
  }

  /**
   * Reads from now on.
   *
   * @param topics what is wanted
   * @param place where it is on the timeline
   * @return the thread, which ends with the place
   */
  Thread start(Supplier<List<Reception<?>>> topics, Seat place) {
    wanted = topics;
    seat = Optional.of(place);
    Thread reader = context.threads().newThread(() -> run(place));
    reader.start();
    return reader;
  }

  /** Something else is wanted. */
  void look() {
    seat.ifPresent(Seat::look);
  }

  private void run(Seat place) {
    try {
      while (take(place.await(time(next)), place)) {
        deliverTwins(place);
      }
    } catch (RecordingException e) {
      ended.complete(e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (RuntimeException e) {
      LOG.error("{} cannot be played on", recording.file(), e);
      ended.complete(recording.file() + " cannot be played on: " + e); // the timeline must not wait for it
    }
  }

  private boolean take(Turn turn, Seat place) throws RecordingException {
    switch (turn) {
      case Turn.Deliver due -> deliverNext(place);
      case Turn.Moved moved -> moveTo(moved.time(), place);
      case Turn.Look look -> renew(place.hold(), place);
      case Turn.Over over -> {
        return false;
      }
    }
    return true;
  }

  private static long time(Optional<RecordedMessage> message) {
    return message.map(RecordedMessage::logTime).orElse(Seat.NEVER);
  }

  private void deliverNext(Seat place) throws RecordingException {
    RecordedMessage message = next.orElseThrow();
    synchronized (gate) {
      if (place.isMoving()) {
        return;
      }
      passed(message.logTime());
      give(message, known);
    }
    delivered = message.logTime();
    next = cursor.isPresent() ? cursor.get().next() : Optional.empty();
  }

  /** Messages of one time belong together: who joins, joins behind all of them. */
  private void deliverTwins(Seat place) throws RecordingException {
    while (time(next) == delivered && !place.isMoving()) {
      deliverNext(place);
    }
  }

  private void moveTo(long time, Seat place) throws RecordingException {
    known = Set.copyOf(wanted.get());
    List<RecordedMessage> holding = past.at(time, List.copyOf(known));
    Set<Integer> had = holding.stream().map(each -> each.channel().id()).collect(Collectors.toSet());
    known.stream().filter(each -> each.channels().stream().noneMatch(c -> had.contains(c.channel().id())))
        .forEach(each -> context.forget(each.port()));
    holding.forEach(each -> give(each, known));
    readFrom(time);
    place.arrived(time(next));
  }

  /** Others want something, or nobody does any more. */
  private void renew(long time, Seat place) throws RecordingException {
    Set<Reception<?>> before = known;
    known = Set.copyOf(wanted.get());
    Set<Reception<?>> fresh = new HashSet<>(known);
    fresh.removeAll(before);
    List<RecordedMessage> holding = past.at(time, List.copyOf(fresh));
    synchronized (gate) {
      if (!place.isMoving()) {
        holding.forEach(each -> give(each, fresh));
      }
    }
    readFrom(time);
  }

  private void readFrom(long time) throws RecordingException {
    delivered = time;
    Set<Integer> channels = known.stream().flatMap(each -> each.channels().stream())
        .map(each -> each.channel().id()).collect(Collectors.toSet());
    cursor = channels.isEmpty() || time == Long.MAX_VALUE ? Optional.empty()
        : Optional.of(recording.cursor(RecordingInterval.from(time + 1), channels));
    next = cursor.isPresent() ? cursor.get().next() : Optional.empty();
  }

  /** With the age that it has by the time of the recording. */
  private void give(RecordedMessage message, Set<Reception<?>> to) {
    long received = clock.received(Math.min(now, message.logTime()));
    to.stream().filter(each -> each.has(message.channel().id())).forEach(each -> each.deliver(message, received));
  }

  @Override
  public void moved(long time) {
    synchronized (gate) {
      now = time;
      clock.moved(time);
      context.forgetMerged();
    }
  }

  @Override
  public void passed(long time) {
    synchronized (gate) {
      now = Math.max(now, time);
      clock.replayed(now);
    }
  }

  @Override
  public OptionalLong neighbour(boolean forward, long time, Optional<String> topic) {
    Set<Integer> channels = recording.channels().stream()
        .filter(each -> topic.isEmpty() || topic.get().equals(TopicTable.name(each))).map(RecordedChannel::id)
        .collect(Collectors.toSet());
    try {
      return channels.isEmpty() ? OptionalLong.empty()
          : forward ? after(time, channels) : before(time, channels);
    } catch (RecordingException e) {
      ended.complete(e.getMessage());
      return OptionalLong.empty();
    }
  }

  private OptionalLong after(long time, Set<Integer> channels) throws RecordingException {
    Optional<RecordedMessage> found = recording.cursor(RecordingInterval.from(time + 1), channels).next();
    return found.isPresent() ? OptionalLong.of(found.get().logTime()) : OptionalLong.empty();
  }

  private OptionalLong before(long time, Set<Integer> channels) throws RecordingException {
    OptionalLong latest = OptionalLong.empty();
    for (int channel : channels) {
      Optional<RecordedMessage> found = recording.latestBefore(channel, time - 1);
      if (found.isPresent() && (latest.isEmpty() || found.get().logTime() > latest.getAsLong())) {
        latest = OptionalLong.of(found.get().logTime());
      }
    }
    return latest;
  }

  @Override
  public TrackId id() {
    return id;
  }

  @Override
  public Path file() {
    return recording.file();
  }

  @Override
  public String identity() {
    long messages = recording.messageCounts().values().stream().mapToLong(Long::longValue).sum();
    return recording.format() + " " + span.start() + " " + span.end() + " " + messages;
  }

  @Override
  public TimeRange span() {
    return span;
  }

  @Override
  public SearchableHistory history() {
    return history.get();
  }

  @Override
  public List<Lane> lanes() {
    return lanes.get();
  }

  @Override
  public List<String> problems() {
    return recording.damages().stream().map(RecordingDamage::toString).toList();
  }
}
