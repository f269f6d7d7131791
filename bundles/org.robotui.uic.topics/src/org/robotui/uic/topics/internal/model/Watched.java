package org.robotui.uic.topics.internal.model;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.ui.ask.Measure;
import org.robotui.ui.ask.Meter;

/** The streams that are asked for: the measured ones and the echoed one, and none else. The tick's thread. */
final class Watched {
  private final Input<Data> input;
  private final Map<SourceId, Meter> meters = new HashMap<>();
  private final History history = new History();
  private Set<SourceId> chosen = Set.of();
  private Optional<SourceId> echoed = Optional.empty();

  Watched(Input<Data> input) {
    this.input = input;
  }

  /** Asks for what is wanted, and gives up what is not. A stream that goes on loses nothing. */
  void follow(Catalog catalog, Wishes wishes) {
    Set<SourceId> wanted = new HashSet<>();
    wishes.measured().forEach(key -> stream(catalog, key).ifPresent(wanted::add));
    Optional<SourceId> echo = wishes.echoed().flatMap(key -> stream(catalog, key));
    echo.ifPresent(wanted::add);
    if (!echo.equals(echoed)) {
      echoed = echo;
      history.clear();
    }
    if (!wanted.equals(chosen)) {
      chosen = Set.copyOf(wanted);
      meters.keySet().retainAll(chosen);
      input.choose(chosen);
    }
  }

  /** Takes what came; returns how many messages. */
  int drain(int capacity, Wishes wishes) {
    boolean held = wishes.paused() || wishes.pinned().isPresent();
    return input.drain(envelope -> take(envelope, capacity, held));
  }

  Map<Key, Measure> measures(Catalog catalog, Wishes wishes, long now) {
    Map<Key, Measure> all = new HashMap<>();
    wishes.measured().forEach(key -> measure(catalog, key, now).ifPresent(m -> all.put(key, m)));
    wishes.echoed().ifPresent(key -> measure(catalog, key, now).ifPresent(m -> all.put(key, m)));
    return Map.copyOf(all);
  }

  History history() {
    return history;
  }

  Optional<Heard> shown(OptionalLong pinned) {
    return pinned.isPresent() ? history.find(pinned.getAsLong()) : history.newest();
  }

  Optional<SourceId> echoed() {
    return echoed;
  }

  Optional<InputState> state() {
    return echoed.map(input::state);
  }

  int streams() {
    return chosen.size();
  }

  void close() {
    chosen = Set.of();
    input.choose(chosen);
  }

  private Optional<Measure> measure(Catalog catalog, Key key, long now) {
    return stream(catalog, key)
        .map(source -> Optional.ofNullable(meters.get(source)).map(m -> m.measure(now)).orElse(Measure.NOTHING));
  }

  private void take(Envelope<Data> envelope, int capacity, boolean held) {
    SourceId source = envelope.source();
    if (chosen.contains(source)) {
      meters.computeIfAbsent(source, s -> new Meter()).take(envelope.receivedNanos(), Heard.size(envelope));
      if (echoed.equals(Optional.of(source))) {
        history.take(envelope, capacity, held);
      }
    }
  }

  private static Optional<SourceId> stream(Catalog catalog, Key key) {
    return catalog.find(key).flatMap(Entry::stream);
  }
}
