package org.robotui.core.internal.port;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.Intake;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.StreamHistory;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.data.Data;

/**
 * A view's end of a stream. Matching changes its sources while it is used, and so does the view's choice where it has
 * one.
 */
public final class InputEnd<T extends Data> implements Input<T> {
  private record Line<T extends Data>(StreamSource<T> source, Tap<T> tap) {}

  /** Views ask for each of their sources, several times a tick: fifty robots would be looked through fifty times. */
  private record Lines<T extends Data>(List<Line<T>> all, Map<SourceId, Line<T>> byId, List<Candidate> candidates,
      String reason) {
    static <T extends Data> Lines<T> of(List<Line<T>> all, List<Candidate> candidates, String reason) {
      return new Lines<>(List.copyOf(all),
          all.stream().collect(Collectors.toMap(l -> l.source().id(), l -> l, (first, second) -> first)), candidates,
          reason);
    }
  }

  private final Intake intake;
  private final NanoClock clock;
  private final Runnable filled;
  private List<StreamSource<T>> matched = List.of(); // under the lock
  private Set<SourceId> chosen = Set.of(); // under the lock
  private volatile Lines<T> lines = Lines.of(List.of(), List.of(), "not matched yet");

  /** An end without sources. */
  public InputEnd(Intake intake, NanoClock clock) {
    this(intake, clock, () -> {});
  }

  /** An end without sources, which tells of each value that waits to be drained; on the thread that received it. */
  public InputEnd(Intake intake, NanoClock clock, Runnable filled) {
    this.intake = intake;
    this.clock = clock;
    this.filled = filled;
  }

  /**
   * Connects the end to these sources; those it has already keep what they hold. Called on the worker of the RUIC.
   *
   * @param sources in the order of matching, each of a type that the view accepts
   * @param reason what matching says
   */
  public synchronized void connect(List<StreamSource<T>> sources, String reason) {
    matched = List.copyOf(sources);
    List<Candidate> candidates =
        matched.stream().map(s -> new Candidate(s.id(), s.port().typeName())).toList();
    draw(candidates, reason);
  }

  @Override
  public synchronized void choose(Set<SourceId> sources) {
    if (intake != Intake.CHOSEN) {
      throw new IllegalStateException("a port takes what matching connects, unless it is declared as " + Intake.CHOSEN);
    }
    chosen = Set.copyOf(sources);
    draw(lines.candidates(), lines.reason());
  }

  private void draw(List<Candidate> candidates, String reason) {
    List<Line<T>> before = lines.all();
    List<Line<T>> after = new ArrayList<>();
    for (StreamSource<T> source : matched) {
      if (intake == Intake.MATCHED || chosen.contains(source.id())) {
        after.add(before.stream().filter(l -> l.source() == source).findFirst()
            .orElseGet(() -> new Line<>(source, source.join(intake, filled))));
      }
    }
    lines = Lines.of(after, candidates, reason);
    before.stream().filter(l -> !after.contains(l)).forEach(l -> l.source().leave(l.tap()));
  }

  @Override
  public List<Candidate> candidates() {
    return lines.candidates();
  }

  @Override
  public InputState state() {
    Lines<T> now = lines;
    return now.all().stream().map(this::state).min(Comparator.comparingInt(InputEnd::rank))
        .orElseGet(() -> new InputState.Unconnected(nothing(now)));
  }

  private static String nothing(Lines<?> now) {
    int fitting = now.candidates().size();
    return fitting == 0 ? now.reason()
        : "nothing is chosen; " + fitting + (fitting == 1 ? " stream fits" : " streams fit");
  }

  private InputState state(Line<T> line) {
    return line.source().state(line.tap(), clock);
  }

  private static int rank(InputState state) {
    return switch (state) {
      case InputState.Live live -> 0;
      case InputState.Stale stale -> 1;
      case InputState.Waiting waiting -> 2;
      case InputState.Failed failed -> 3;
      case InputState.Unconnected unconnected -> 4;
    };
  }

  @Override
  public List<SourceId> sources() {
    return lines.all().stream().map(l -> l.source().id()).toList();
  }

  @Override
  public InputState state(SourceId source) {
    return find(source).map(this::state).orElseGet(() -> new InputState.Unconnected(source + " is not connected"));
  }

  @Override
  public Optional<Envelope<T>> latest() {
    return lines.all().stream().map(l -> l.tap().latest()).flatMap(Optional::stream)
        .max(Comparator.comparingLong(Envelope::receivedNanos));
  }

  @Override
  public Optional<Envelope<T>> latest(SourceId source) {
    return find(source).flatMap(l -> l.tap().latest());
  }

  @Override
  public synchronized Optional<StreamHistory> history(SourceId source) {
    return matched.stream().filter(s -> s.id().equals(source)).findFirst().flatMap(StreamSource::history);
  }

  private Optional<Line<T>> find(SourceId source) {
    return Optional.ofNullable(lines.byId().get(source));
  }

  @Override
  public int drain(Consumer<? super Envelope<T>> consumer) {
    List<Line<T>> now = lines.all();
    return now.size() == 1 ? now.getFirst().tap().drain(consumer) : drainInOrder(now, consumer);
  }

  private int drainInOrder(List<Line<T>> now, Consumer<? super Envelope<T>> consumer) {
    List<Envelope<T>> taken = new ArrayList<>();
    now.forEach(l -> l.tap().drain(taken::add));
    taken.sort(Comparator.comparingLong(Envelope::receivedNanos));
    taken.forEach(consumer);
    return taken.size();
  }

  @Override
  public synchronized void recall() {
    Lines<T> now = lines;
    List<Line<T>> again = now.all().stream().filter(l -> l.source().holds()).toList();
    lines = Lines.of(
        now.all().stream().map(l -> again.contains(l) ? new Line<>(l.source(), l.source().join(intake, filled)) : l)
            .toList(),
        now.candidates(), now.reason());
    again.forEach(l -> l.source().leave(l.tap())); // after the new ones have joined, so that the robot is not asked to
                                                   // stop
  }

  @Override
  public long dropped() {
    return lines.all().stream().mapToLong(l -> l.tap().dropped()).sum();
  }
}
