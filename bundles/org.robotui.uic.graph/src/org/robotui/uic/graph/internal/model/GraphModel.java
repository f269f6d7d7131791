package org.robotui.uic.graph.internal.model;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.api.UicContext;
import org.robotui.api.port.InputState;
import org.robotui.api.show.Subject;
import org.robotui.ui.Health;
import org.robotui.ui.ask.Measure;
import org.robotui.ui.ask.Presence;
import org.robotui.ui.diagram.Diagram;
import org.robotui.ui.diagram.TextWidths;
import org.robotui.uic.graph.internal.GraphOptions;
import org.robotui.uic.graph.internal.GraphPorts;
import org.robotui.uic.graph.internal.model.Vertex.Kind;
import org.robotui.uic.graph.internal.model.Wiring.Tie;

/**
 * How the programs of robots are connected, laid out. The tick prepares all that is seen; what is asked for may be said
 * on any thread and counts from the next tick on. Robots are asked, and nets laid out, in the background.
 */
public final class GraphModel {
  /** The most boxes that are laid out. */
  static final int MOST_BOXES = 1200;

  private static final long SEEN_NANOS = 3_000_000_000L;
  private static final long HEARTBEAT_NANOS = 1_000_000_000L;
  private static final long FIGURES_NANOS = 500_000_000L;

  private final Asker asker;
  private final Laying laying;
  private final Gauges gauges;
  private final Presence presence;
  private volatile Ask ask = Ask.FIRST;
  private volatile TextWidths widths = TextWidths.estimate();
  private volatile long seenAt;
  private volatile boolean seen;
  private volatile boolean anew;
  private volatile GraphViewState look;
  private Wiring netted = Wiring.NOTHING;
  private Ask asked = Ask.FIRST;
  private int closeFrom;
  private List<Tie> sifted = List.of();
  private Net net = Net.EMPTY;
  private Map<Vertex, Measure> measures = Map.of();
  private long figures;
  private long beat;
  private boolean ever;

  /** With what core gives to the view. */
  public GraphModel(UicContext context) {
    asker = new Asker(context);
    laying = new Laying(context.background());
    gauges = new Gauges(context.input(GraphPorts.ALL));
    presence = new Presence(context, GraphPorts.GRAPH, "its nodes");
    look = look(Ask.FIRST, presence.state(Set.of(), Map.of()));
  }

  /** Takes what came and prepares what is seen; whether there is something new to show. */
  public boolean tick(long now, GraphOptions options) {
    Ask wanted = ask;
    boolean visible = seen && now - seenAt < SEEN_NANOS;
    asker.tick(now, options.periodNanos(), visible);
    follow(asker.wiring(), wanted, options.boxes());
    measure(now, wanted, options, visible);
    GraphViewState next = look(wanted, presence.state(netted.known(), netted.failures()));
    boolean beats = !ever || now - beat >= HEARTBEAT_NANOS;
    beat = beats ? now : beat;
    ever = true;
    boolean changed = beats || !same(next, look);
    look = next;
    return changed;
  }

  private void follow(Wiring wiring, Ask wanted, int boxes) {
    if (wiring != netted || !wanted.sameNet(asked) || boxes != closeFrom) {
      netted = wiring;
      asked = wanted;
      closeFrom = boxes;
      sifted = Sieve.sift(wiring.ties(), wanted);
      net = Netting.of(sifted, wanted, boxes);
    }
    if (net.vertices().size() <= MOST_BOXES) {
      boolean fresh = anew;
      anew = false;
      laying.want(net, widths, fresh);
    }
  }

  private void measure(long now, Ask wanted, GraphOptions options, boolean visible) {
    gauges.drain();
    gauges.follow(
        visible && wanted.measuring() ? wanted.selected().map(this::topicsOf).orElseGet(this::topics) : Set.of(),
        netted, options.measured());
    if (now - figures >= FIGURES_NANOS || !ever) {
      figures = now;
      measures = gauges.measures(now);
    }
  }

  /** All that are not left out. */
  private Set<Vertex> topics() {
    return sifted.stream().map(Tie::topic).collect(Collectors.toSet());
  }

  /** Of a topic itself; of a node what it sends and takes. */
  private Set<Vertex> topicsOf(Vertex selected) {
    return selected.kind() == Kind.TOPIC ? Set.of(selected)
        : sifted.stream().filter(tie -> tie.node().equals(selected)).map(Tie::topic).collect(Collectors.toSet());
  }

  private GraphViewState look(Ask wanted, InputState state) {
    Laying.Laid laid = laying.laid();
    boolean crowded = net.vertices().size() > MOST_BOXES;
    Diagram diagram =
        crowded || net.vertices().isEmpty() ? Diagram.EMPTY : Labels.with(laid.diagram(), laid.net(), measures);
    Optional<String> notice = Optional.of(Presence.notice(state, netted.failures())).filter(why -> !why.isEmpty())
        .or(() -> Optional.of(laid.failure()).filter(why -> !why.isEmpty()));
    return new GraphViewState(wanted, state, diagram, laying.busy(), notice, empty(wanted, crowded),
        wanted.selected().map(vertex -> VertexText.of(vertex, netted, measures)).orElse(""),
        (int) sifted.stream().map(Tie::node).distinct().count(),
        (int) sifted.stream().map(Tie::topic).distinct().count());
  }

  private Optional<GraphViewState.Empty> empty(Ask wanted, boolean crowded) {
    if (crowded) {
      return Optional.of(new GraphViewState.Empty(Health.WARNING, "Too many boxes to draw",
          net.vertices().size() + " boxes; up to " + MOST_BOXES
              + " are laid out. Filter, close namespaces, or show nodes only."));
    }
    if (!net.vertices().isEmpty()) {
      return Optional.empty();
    }
    String what =
        wanted.words().isEmpty() ? "There are no topics here besides those of tools. The eye lists what is hidden."
            : "No node or topic that is shown contains these words. Esc clears the filter.";
    return Optional
        .of(new GraphViewState.Empty(Health.NONE, wanted.words().isEmpty() ? "Nothing to draw" : "No match", what));
  }

  private static boolean same(GraphViewState one, GraphViewState other) {
    return one.diagram().equals(other.diagram()) && one.ask().equals(other.ask()) && one.state().equals(other.state())
        && one.laying() == other.laying() && one.notice().equals(other.notice())
        && one.selected().equals(other.selected())
        && one.empty().equals(other.empty()) && one.title().equals(other.title());
  }

  /** What the last tick prepared. */
  public GraphViewState look() {
    return look;
  }

  /** What a box stands for, as other views know it: a program, or the stream that carries a topic. Any thread. */
  public Optional<Subject> subject(Vertex vertex) {
    return switch (vertex.kind()) {
      case NODE -> Optional.of(new Subject.Node(vertex.name()));
      case TOPIC -> asker.wiring().stream(vertex).map(Subject.Stream::of);
      case GROUP -> Optional.empty();
    };
  }

  /** The box of a program, where it is known. Any thread. */
  public Optional<Vertex> node(String name) {
    return asker.wiring().ties().stream().map(Tie::node).filter(vertex -> vertex.name().equals(name)).findFirst();
  }

  /** What is asked for now. */
  public Ask ask() {
    return ask;
  }

  /** Asks for something else. */
  public void ask(Ask next) {
    ask = next;
  }

  /** Lays out from scratch, without regard for where things are. */
  public void anew() {
    anew = true;
    asker.refresh();
  }

  /** How wide letters are where it is painted. */
  public void widths(TextWidths exact) {
    widths = exact;
  }

  /** The view is seen now: robots are asked for as long as it is. */
  public void seen(long now) {
    seenAt = now;
    seen = true;
  }

  /** Gives up what it asked for. */
  public void close() {
    seen = false;
    gauges.close();
  }
}
