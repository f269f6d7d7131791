package org.robotui.testkit;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.StreamHistory;
import org.robotui.data.Data;
import org.robotui.data.DataType;
import org.robotui.data.Late;
import org.robotui.data.Stamp;

/**
 * An input that holds what a test puts in. It conflates nothing: {@link #drain} gives all values put since the last
 * call.
 *
 * @param <T> the type of the data
 */
public final class FakeInput<T extends Data> implements Input<T> {
  private final Map<SourceId, Envelope<T>> newest = new LinkedHashMap<>();
  private final Map<SourceId, InputState> states = new LinkedHashMap<>();
  private final List<Envelope<T>> queue = new ArrayList<>();
  private Optional<Envelope<T>> last = Optional.empty();
  private InputState state = new InputState.Unconnected("nothing there offers such a port");
  private List<Candidate> candidates = List.of();
  private Set<SourceId> chosen = Set.of();
  private final Set<SourceId> kept = new HashSet<>();
  private final Map<SourceId, Long> sequences = new LinkedHashMap<>();
  private final Map<SourceId, StreamHistory> histories = new LinkedHashMap<>();
  private long dropped;

  /**
   * Sets the state of the whole, and of all sources.
   *
   * @param next the state from now on
   */
  public synchronized void state(InputState next) {
    state = next;
    states.replaceAll((source, old) -> next);
  }

  /**
   * Sets the state of one source, which is connected by that.
   *
   * @param source the source
   * @param next its state
   */
  public synchronized void state(SourceId source, InputState next) {
    states.put(source, next);
  }

  /**
   * Sets what could be chosen.
   *
   * @param fitting the candidates
   */
  public synchronized void candidates(List<Candidate> fitting) {
    candidates = List.copyOf(fitting);
  }

  /**
   * What the view has chosen last.
   *
   * @return the sources
   */
  public synchronized Set<SourceId> chosen() {
    return chosen;
  }

  /**
   * Puts a value in; the input is live at 10 Hz by that.
   *
   * @param source where it comes from; connected by that
   * @param value the value
   * @param receivedNanos when it was received
   * @param stamp when it was measured
   */
  public synchronized void put(SourceId source, T value, long receivedNanos, Optional<Stamp> stamp) {
    put(source, value, receivedNanos, stamp, Optional.empty());
  }

  /**
   * Puts a value in together with the message that it came in; the input is live at 10 Hz by that.
   *
   * @param source where it comes from; connected by that
   * @param value the value
   * @param receivedNanos when it was received
   * @param stamp when it was measured
   * @param raw the message
   */
  public synchronized void put(
      SourceId source, T value, long receivedNanos, Optional<Stamp> stamp, Optional<RawMessage> raw) {
    Envelope<T> envelope =
        new Envelope<>(value, source, sequences.merge(source, 0L, (n, first) -> n + 1), stamp, receivedNanos, raw);
    newest.put(source, envelope);
    last = Optional.of(envelope);
    queue.add(envelope);
    state = new InputState.Live(10, 0);
    states.put(source, state);
  }

  /**
   * Loses values on the way: the next of the source has a sequence number that much higher.
   *
   * @param source the source
   * @param count how many are lost
   */
  public synchronized void skip(SourceId source, long count) {
    sequences.merge(source, count - 1, (n, first) -> n + count);
    dropped += count;
  }

  /**
   * Puts a value in, received now, from {@code base.data}.
   *
   * @param value the value
   */
  public void put(T value) {
    put(new SourceId("base", "data"), value, System.nanoTime(), Optional.empty());
  }

  /**
   * Takes a source away.
   *
   * @param source the source
   */
  public synchronized void remove(SourceId source) {
    newest.remove(source);
    states.remove(source);
  }

  /**
   * Has a source keep its last value, so that {@link #recall} gives it again.
   *
   * @param source the source
   */
  public synchronized void keep(SourceId source) {
    kept.add(source);
  }

  /**
   * Has a source be that of a recording.
   *
   * @param source the source
   * @param history all that it has
   */
  public synchronized void history(SourceId source, StreamHistory history) {
    histories.put(source, history);
  }

  @Override
  public synchronized Optional<StreamHistory> history(SourceId source) {
    return Optional.ofNullable(histories.get(source));
  }

  /**
   * Sets the count of lost values.
   *
   * @param count the count
   */
  public synchronized void dropped(long count) {
    dropped = count;
  }

  @Override
  public synchronized InputState state() {
    return state;
  }

  @Override
  public synchronized List<SourceId> sources() {
    return List.copyOf(states.keySet());
  }

  @Override
  public synchronized List<Candidate> candidates() {
    return candidates;
  }

  @Override
  public synchronized void choose(Set<SourceId> sources) {
    chosen = Set.copyOf(sources);
  }

  @Override
  public synchronized InputState state(SourceId source) {
    return states.getOrDefault(source, new InputState.Unconnected("no such source"));
  }

  @Override
  public synchronized Optional<Envelope<T>> latest() {
    return last;
  }

  @Override
  public synchronized Optional<Envelope<T>> latest(SourceId source) {
    return Optional.ofNullable(newest.get(source));
  }

  @Override
  public int drain(Consumer<? super Envelope<T>> consumer) {
    List<Envelope<T>> taken = take();
    taken.forEach(consumer);
    return taken.size();
  }

  @Override
  public synchronized long dropped() {
    return dropped;
  }

  @Override
  public synchronized void recall() {
    newest.forEach((source, envelope) -> {
      DataType type = DataType.of(envelope.value().getClass());
      if (type.late() != Late.NONE && (kept.contains(source) || !type.expires())) {
        queue.removeIf(e -> e.source().equals(source));
        queue.add(envelope);
      }
    });
  }

  private synchronized List<Envelope<T>> take() {
    List<Envelope<T>> taken = List.copyOf(queue);
    queue.clear();
    return taken;
  }
}
