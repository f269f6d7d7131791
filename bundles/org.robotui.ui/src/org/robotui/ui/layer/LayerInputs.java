package org.robotui.ui.layer;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.UicContext;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.api.replay.StreamHistory;
import org.robotui.data.Data;
import org.robotui.data.DataType;
import org.robotui.data.FrameId;
import org.robotui.data.Framed;

/**
 * What layers get their data from: ports of the view for types that it knows, which a configuration may connect by
 * name, and one that takes whatever else there are layers for. Worker thread.
 */
public final class LayerInputs {
  private static final int MOST_FRAMES = 1000;

  private final Map<String, Input<? extends Data>> matched = new LinkedHashMap<>();
  private final Input<Data> chosen;
  private final Map<SourceId, List<Envelope<? extends Data>>> arrived = new HashMap<>();
  private final Set<FrameId> named = new LinkedHashSet<>();
  private Map<SourceId, Input<? extends Data>> owners = Map.of();
  private List<Input.Candidate> own = List.of();
  private List<Input.Candidate> others = List.of();
  private Set<SourceId> taken = Set.of();
  private Set<SourceId> connected = new LinkedHashSet<>();

  /**
   * The ports of a view.
   *
   * @param context of the view
   * @param known its ports for types that it knows
   * @param any its port for any type, of which layers choose
   */
  public LayerInputs(UicContext context, List<? extends StreamPort<? extends Data>> known, StreamPort<Data> any) {
    known.forEach(port -> matched.put(DataType.of(port.type()).name(), context.input(port)));
    chosen = context.input(any);
  }

  /** Looks what is offered now; to be called at each tick before anything else. */
  void look() {
    Map<SourceId, Input<? extends Data>> owned = new LinkedHashMap<>();
    List<Input.Candidate> fed = new ArrayList<>();
    matched.forEach((type, input) -> input.sources().forEach(id -> {
      owned.putIfAbsent(id, input);
      fed.add(new Input.Candidate(id, type));
    }));
    owners = owned;
    own = List.copyOf(fed);
    others = chosen.candidates().stream().filter(c -> !owned.containsKey(c.id())).toList();
  }

  /**
   * What is shown by itself: what matching connected, and what else there is of types for which the view has no port.
   */
  List<Input.Candidate> automatic() {
    List<Input.Candidate> all = new ArrayList<>(own);
    others.stream().filter(c -> !matched.containsKey(c.typeName())).forEach(all::add);
    return all;
  }

  /** Whether a type has a port of its own, whose sources the configuration has chosen. */
  boolean hasPort(Class<? extends Data> type) {
    return matched.containsKey(DataType.of(type).name());
  }

  /** All that layers can be given. */
  List<Input.Candidate> all() {
    List<Input.Candidate> all = new ArrayList<>(own);
    all.addAll(others);
    return all;
  }

  /** Asks robots for what layers want beside what is connected. */
  void choose(Set<SourceId> wanted) {
    Set<SourceId> next = new HashSet<>(wanted);
    next.removeAll(owners.keySet());
    if (!next.equals(taken)) {
      taken = Set.copyOf(next);
      chosen.choose(taken);
    }
  }

  /** Takes what came. */
  void drain(boolean reset) {
    arrived.clear();
    connected = new LinkedHashSet<>(owners.keySet());
    connected.addAll(chosen.sources());
    if (reset) {
      chosen.recall(); // what layers forget now and the robot says but once
      named.clear();
    }
    chosen.drain(e -> {
      arrived.computeIfAbsent(e.source(), id -> new ArrayList<>()).add(e);
      name(e.value());
    });
    matched.values().forEach(input -> input.sources().forEach(id -> input.latest(id).ifPresent(e -> name(e.value()))));
  }

  private void name(Data value) {
    if (value instanceof Framed framed && named.size() < MOST_FRAMES) {
      framed.frames().limit(MOST_FRAMES).forEach(named::add);
    }
  }

  /** The frames that data are given in. */
  List<FrameId> named() {
    return List.copyOf(named);
  }

  /** What came of a source since the last drain, or for a layer that is new what it sent last. */
  List<Envelope<? extends Data>> arrived(SourceId source, Optional<Envelope<? extends Data>> last) {
    if (owners.containsKey(source)) {
      return owners.get(source).latest(source).filter(e -> last.filter(l -> l == e || l.value() == e.value()).isEmpty())
          .<List<Envelope<? extends Data>>>map(List::of).orElse(List.of());
    }
    List<Envelope<? extends Data>> came = arrived.getOrDefault(source, List.of());
    return came.isEmpty() && last.isEmpty()
        ? chosen.latest(source).<List<Envelope<? extends Data>>>map(List::of).orElse(List.of())
        : came;
  }

  /** The sources that were connected when it was drained last. */
  Set<SourceId> sources() {
    return connected;
  }

  Optional<StreamHistory> history(SourceId source) {
    return owners.containsKey(source) ? owners.get(source).history(source) : chosen.history(source);
  }

  InputState state(SourceId source) {
    return owners.containsKey(source) ? owners.get(source).state(source) : chosen.state(source);
  }

  /** The states of the ports that have no source, and of all sources. */
  List<InputState> states() {
    List<InputState> states = new ArrayList<>();
    matched.values().stream().filter(input -> input.sources().isEmpty()).forEach(input -> states.add(input.state()));
    sources().forEach(id -> states.add(state(id)));
    return states;
  }
}
