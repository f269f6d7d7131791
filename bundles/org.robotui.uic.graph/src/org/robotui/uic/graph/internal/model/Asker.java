package org.robotui.uic.graph.internal.model;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Collectors;
import org.robotui.api.UicContext;
import org.robotui.api.port.BrowseInput;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.ui.ask.StreamNames;
import org.robotui.uic.graph.internal.GraphPorts;
import org.robotui.uic.graph.internal.model.Wiring.Tie;

/**
 * Asks the robots in the background, never oftener than every period and than a tenth of the time. A robot that does
 * not answer keeps what it said before, with the reason.
 */
final class Asker {
  private static final int MOST_TIES = 20_000;
  private static final long REST = 9;
  private static final Comparator<Vertex> BY_NAME = Comparator.comparing(Vertex::robot).thenComparing(Vertex::name);
  private static final Comparator<Tie> ORDER =
      Comparator.comparing(Tie::node, BY_NAME).thenComparing(Tie::topic, BY_NAME).thenComparing(Tie::sends);

  private record Said(List<Tie> ties, Map<Vertex, String> types) {}

  private final UicContext context;
  private final BrowseInput browse;
  private final Input<Data> streams;
  private final Map<String, Said> said = new HashMap<>();
  private final AtomicBoolean asking = new AtomicBoolean();
  private final AtomicBoolean wanted = new AtomicBoolean(true);
  private volatile long restUntil;
  private volatile Wiring wiring = Wiring.NOTHING;

  Asker(UicContext context) {
    this.context = context;
    browse = context.browse(GraphPorts.GRAPH);
    streams = context.input(GraphPorts.ALL);
  }

  /** Asks where it is time to. */
  void tick(long now, long periodNanos, boolean seen) {
    boolean due = wanted.get() || now - restUntil >= 0;
    if (seen && due && asking.compareAndSet(false, true)) {
      wanted.set(false);
      context.background().execute(() -> ask(now, periodNanos));
    }
  }

  /** Asks again soon. */
  void refresh() {
    wanted.set(true);
  }

  /** What was said; the same object as before where nothing changed. */
  Wiring wiring() {
    return wiring;
  }

  private void ask(long now, long periodNanos) {
    long begin = System.nanoTime();
    try {
      Wiring next = all(browse.robots());
      if (!next.equals(wiring)) {
        wiring = next;
      }
    } finally {
      long took = System.nanoTime() - begin;
      restUntil = now + took + Math.max(periodNanos, REST * took);
      asking.set(false);
    }
  }

  private Wiring all(List<BrowseInput.Robot> robots) {
    said.keySet().retainAll(robots.stream().map(robot -> robot.source().component()).toList());
    Map<String, String> failures = new HashMap<>();
    Map<String, List<SourceId>> ports =
        streams.candidates().stream().map(Input.Candidate::id).collect(Collectors.groupingBy(SourceId::component));
    List<Tie> ties = new ArrayList<>();
    Map<Vertex, String> types = new HashMap<>();
    Map<Vertex, SourceId> found = new HashMap<>();
    for (BrowseInput.Robot robot : robots) {
      String name = robot.source().component();
      ask(robot.browser(), name).ifPresent(why -> failures.put(name, why));
      Optional.ofNullable(said.get(name)).ifPresent(s -> {
        ties.addAll(s.ties());
        types.putAll(s.types());
        found.putAll(streams(s.types().keySet(), ports.getOrDefault(name, List.of())));
      });
    }
    return new Wiring(List.copyOf(ties), Map.copyOf(types), Map.copyOf(found), Set.copyOf(said.keySet()),
        Map.copyOf(failures));
  }

  private static Map<Vertex, SourceId> streams(Set<Vertex> topics, List<SourceId> ports) {
    StreamNames names = StreamNames.of(topics.stream().map(Vertex::name).toList(), ports);
    Map<Vertex, SourceId> found = new HashMap<>();
    topics.forEach(topic -> names.find(topic.name()).ifPresent(port -> found.put(topic, port)));
    return found;
  }

  private Optional<String> ask(Browser browser, String robot) {
    try {
      Map<Vertex, String> types = new HashMap<>();
      browser.list(Browser.Kind.TOPIC)
          .forEach(item -> types.put(new Vertex(Vertex.Kind.TOPIC, robot, item.name()), item.type()));
      Set<Tie> ties = new HashSet<>();
      for (Browser.Link link : browser.links()) {
        ties.add(new Tie(new Vertex(Vertex.Kind.NODE, robot, link.node()),
            new Vertex(Vertex.Kind.TOPIC, robot, link.topic()), link.sends()));
      }
      said.put(robot, new Said(ties.stream().sorted(ORDER).limit(MOST_TIES).toList(), types));
      return ties.size() > MOST_TIES
          ? Optional.of("it has " + ties.size() + " connections; the first " + MOST_TIES + " are shown")
          : Optional.empty();
    } catch (CallException e) {
      return Optional.of(e.getMessage());
    }
  }
}
