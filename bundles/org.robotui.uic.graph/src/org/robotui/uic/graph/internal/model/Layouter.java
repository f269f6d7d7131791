package org.robotui.uic.graph.internal.model;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.elk.alg.layered.LayeredLayoutProvider;
import org.eclipse.elk.alg.layered.options.LayeredMetaDataProvider;
import org.eclipse.elk.alg.layered.options.LayeredOptions;
import org.eclipse.elk.core.data.LayoutMetaDataService;
import org.eclipse.elk.core.math.ElkPadding;
import org.eclipse.elk.core.math.KVector;
import org.eclipse.elk.core.options.Direction;
import org.eclipse.elk.core.options.EdgeLabelPlacement;
import org.eclipse.elk.core.options.EdgeRouting;
import org.eclipse.elk.core.options.HierarchyHandling;
import org.eclipse.elk.core.util.BasicProgressMonitor;
import org.eclipse.elk.graph.ElkEdge;
import org.eclipse.elk.graph.ElkEdgeSection;
import org.eclipse.elk.graph.ElkLabel;
import org.eclipse.elk.graph.ElkNode;
import org.eclipse.elk.graph.util.ElkGraphUtil;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.diagram.Box;
import org.robotui.ui.diagram.Diagram;
import org.robotui.ui.diagram.TextWidths;
import org.robotui.ui.diagram.Wire;
import org.robotui.ui.diagram.Wire.Corner;
import org.robotui.uic.graph.internal.model.Net.Edge;
import org.robotui.uic.graph.internal.model.Vertex.Kind;

/**
 * Lays a net out from left to right, by the layered algorithm of the Eclipse Layout Kernel. What was there before keeps
 * its order among what stands above and below it. Takes up to seconds for a thousand boxes; for a background thread,
 * whose interruption ends it.
 */
final class Layouter {
  private static final double PADDING = 24;
  private static final double LEAST = 60;
  private static final double MOST = 260;
  private static final double FRAME_TOP = 26;
  private static final double FRAME_SIDE = 12;
  private static final double BETWEEN = 14;
  private static final double BETWEEN_WIRES = 7;
  private static final double HIGHEST = 300;
  private static final double BETWEEN_LAYERS = 46;
  private static final double LABEL_SIDE = 10;
  private static final double LABEL_HEIGHT = 16;
  private static final int SWEEPS = 4;
  private static final int SEED = 1;

  static {
    // The library looks for its parts as services of one class path, which bundles do not share.
    LayoutMetaDataService.getInstance().registerLayoutMetaDataProviders(new LayeredMetaDataProvider());
  }

  private final Net net;
  private final TextWidths widths;
  private final Map<Vertex, ElkNode> nodes = new HashMap<>();
  private final Map<Edge, ElkEdge> edges = new HashMap<>();
  private final Map<Vertex, Integer> begins = new HashMap<>();
  private final Map<Vertex, Integer> ends = new HashMap<>();

  private Layouter(Net net, TextWidths widths) {
    this.net = net;
    this.widths = widths;
    net.edges().forEach(edge -> {
      begins.merge(edge.from(), 1, Integer::sum);
      ends.merge(edge.to(), 1, Integer::sum);
    });
  }

  /** The layout, or none where it was interrupted. */
  static Optional<Diagram> lay(Net net, TextWidths widths, Diagram before) {
    return new Layouter(net, widths).lay(before);
  }

  private Optional<Diagram> lay(Diagram before) {
    ElkNode root = ElkGraphUtil.createGraph();
    options(root);
    net.frames().forEach(frame -> nodes.put(frame, frame(frame, root)));
    Map<Object, Box> places = new HashMap<>();
    before.boxes().forEach(box -> places.put(box.key(), box));
    net.vertices().forEach(vertex -> nodes.put(vertex, node(vertex, root, Optional.ofNullable(places.get(vertex)))));
    net.edges().forEach(edge -> edges.put(edge, edge(edge)));
    new LayeredLayoutProvider().layout(root, new Interruptible());
    return Thread.currentThread().isInterrupted() ? Optional.empty() : Optional.of(diagram(root));
  }

  private static void options(ElkNode graph) {
    graph.setProperty(LayeredOptions.DIRECTION, Direction.RIGHT);
    graph.setProperty(LayeredOptions.EDGE_ROUTING, EdgeRouting.ORTHOGONAL);
    graph.setProperty(LayeredOptions.HIERARCHY_HANDLING, HierarchyHandling.INCLUDE_CHILDREN);
    graph.setProperty(LayeredOptions.SPACING_NODE_NODE, BETWEEN);
    graph.setProperty(LayeredOptions.SPACING_NODE_NODE_BETWEEN_LAYERS, BETWEEN_LAYERS);
    graph.setProperty(LayeredOptions.RANDOM_SEED, SEED);
    graph.setProperty(LayeredOptions.THOROUGHNESS, SWEEPS);
    graph.setProperty(LayeredOptions.CROSSING_MINIMIZATION_SEMI_INTERACTIVE, true);
    graph.setProperty(LayeredOptions.ASPECT_RATIO, 1.6);
  }

  private ElkNode frame(Vertex frame, ElkNode root) {
    ElkNode made = ElkGraphUtil.createNode(parent(frame, root));
    options(made);
    made.setProperty(LayeredOptions.PADDING, new ElkPadding(FRAME_TOP, FRAME_SIDE, FRAME_SIDE, FRAME_SIDE));
    return made;
  }

  private ElkNode node(Vertex vertex, ElkNode root, Optional<Box> before) {
    ElkNode made = ElkGraphUtil.createNode(parent(vertex, root));
    double wanted = Math.max(widths.title(title(vertex)), widths.note(note(vertex))) + PADDING;
    double wires = Math.max(begins.getOrDefault(vertex, 0), ends.getOrDefault(vertex, 0)) * BETWEEN_WIRES;
    made.setDimensions(Math.clamp(wanted, LEAST, MOST),
        Math.clamp(wires, note(vertex).isEmpty() ? Box.LOW : Box.HIGH, HIGHEST));
    before.ifPresent(box -> made.setProperty(LayeredOptions.POSITION, new KVector(box.x(), box.y())));
    return made;
  }

  /** A label gets room of its own. */
  private ElkEdge edge(Edge edge) {
    ElkEdge made = ElkGraphUtil.createSimpleEdge(nodes.get(edge.from()), nodes.get(edge.to()));
    String words = Labels.plain(edge);
    if (!words.isEmpty()) {
      ElkLabel label = ElkGraphUtil.createLabel(words, made);
      label.setDimensions(widths.note(words) + LABEL_SIDE, LABEL_HEIGHT);
      label.setProperty(LayeredOptions.EDGE_LABELS_PLACEMENT, EdgeLabelPlacement.CENTER);
      label.setProperty(LayeredOptions.EDGE_LABELS_INLINE, true);
    }
    return made;
  }

  private ElkNode parent(Vertex vertex, ElkNode root) {
    return net.frameOf(vertex).map(nodes::get).orElse(root);
  }

  private Diagram diagram(ElkNode root) {
    List<Box> boxes = new ArrayList<>();
    net.frames().forEach(frame -> boxes.add(box(frame, Box.Form.GROUP)));
    net.vertices()
        .forEach(vertex -> boxes.add(box(vertex, vertex.kind() == Kind.TOPIC ? Box.Form.PILL : Box.Form.ROUNDED)));
    List<Wire> wires = net.edges().stream().map(this::wire).flatMap(Optional::stream).toList();
    return new Diagram(boxes, wires, root.getWidth(), root.getHeight());
  }

  private Box box(Vertex vertex, Box.Form form) {
    ElkNode node = nodes.get(vertex);
    KVector at = absolute(node);
    Role role = vertex.kind() == Kind.NODE ? Role.ACCENT : vertex.kind() == Kind.TOPIC ? Role.LINE : Role.DIM;
    return new Box(vertex, at.x, at.y, node.getWidth(), node.getHeight(), form,
        form == Box.Form.GROUP ? frameTitle(vertex) : title(vertex),
        form == Box.Form.GROUP ? "" : note(vertex), Health.NONE, role);
  }

  private Optional<Wire> wire(Edge edge) {
    ElkEdge laid = edges.get(edge);
    if (laid.getSections().isEmpty()) {
      return Optional.empty();
    }
    ElkEdgeSection section = laid.getSections().getFirst();
    KVector at = laid.getContainingNode() == null ? new KVector() : absolute(laid.getContainingNode());
    List<Corner> corners = new ArrayList<>();
    corners.add(new Corner(at.x + section.getStartX(), at.y + section.getStartY()));
    section.getBendPoints().forEach(bend -> corners.add(new Corner(at.x + bend.getX(), at.y + bend.getY())));
    corners.add(new Corner(at.x + section.getEndX(), at.y + section.getEndY()));
    Optional<Corner> room = laid.getLabels().stream().findFirst()
        .map(label -> new Corner(at.x + label.getX() + label.getWidth() / 2,
            at.y + label.getY() + label.getHeight() / 2));
    return Optional.of(new Wire(edge.from(), edge.to(), corners, Labels.plain(edge), room, Role.DIM, false));
  }

  private static KVector absolute(ElkNode node) {
    KVector at = new KVector();
    for (ElkNode up = node; up != null; up = up.getParent()) {
      at.add(up.getX(), up.getY());
    }
    return at;
  }

  /** In a frame the name is that within it. */
  private String title(Vertex vertex) {
    String outer = net.frameOf(vertex).map(Vertex::name).orElse("");
    String name = vertex.name().isEmpty() ? vertex.robot() : vertex.name();
    return outer.isEmpty() || name.equals(outer) || !name.startsWith(outer + "/") ? name
        : name.substring(outer.length() + 1);
  }

  private String frameTitle(Vertex frame) {
    return frame.name().isEmpty() ? frame.robot() : frame.name();
  }

  private String note(Vertex vertex) {
    return vertex.kind() == Kind.GROUP ? net.sizes().getOrDefault(vertex, 0) + " inside" : "";
  }

  /** Ends where its thread is interrupted. */
  private static final class Interruptible extends BasicProgressMonitor {
    @Override
    public boolean isCanceled() {
      return Thread.currentThread().isInterrupted();
    }
  }
}
