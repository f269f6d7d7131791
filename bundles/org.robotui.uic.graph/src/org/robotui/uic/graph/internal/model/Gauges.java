package org.robotui.uic.graph.internal.model;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.ui.ask.Measure;
import org.robotui.ui.ask.Meter;

/** Measures the topics that are looked at, and asks robots for no others. The tick's thread. */
final class Gauges {
  private final Input<Data> input;
  private final Map<SourceId, Meter> meters = new HashMap<>();
  private Map<Vertex, SourceId> measured = Map.of();

  Gauges(Input<Data> input) {
    this.input = input;
  }

  /** Asks for what is wanted, and gives up what is not. */
  void follow(Set<Vertex> topics, Wiring wiring, int most) {
    Map<Vertex, SourceId> next = new HashMap<>();
    topics.stream().sorted((a, b) -> a.name().compareTo(b.name()))
        .forEach(topic -> wiring.stream(topic).filter(s -> next.size() < most)
            .ifPresent(stream -> next.put(topic, stream)));
    if (!next.equals(measured)) {
      measured = Map.copyOf(next);
      Set<SourceId> chosen = new HashSet<>(next.values());
      meters.keySet().retainAll(chosen);
      input.choose(chosen);
    }
  }

  /** Takes what came. */
  void drain() {
    input.drain(this::take);
  }

  private void take(Envelope<Data> envelope) {
    if (measured.containsValue(envelope.source())) {
      OptionalInt size = envelope.raw().map(raw -> OptionalInt.of(raw.bytes().size())).orElseGet(OptionalInt::empty);
      meters.computeIfAbsent(envelope.source(), s -> new Meter()).take(envelope.receivedNanos(), size);
    }
  }

  Map<Vertex, Measure> measures(long now) {
    Map<Vertex, Measure> all = new HashMap<>();
    measured.forEach((topic, stream) -> all.put(topic,
        meters.containsKey(stream) ? meters.get(stream).measure(now) : Measure.NOTHING));
    return Map.copyOf(all);
  }

  void close() {
    measured = Map.of();
    input.choose(Set.of());
  }
}
