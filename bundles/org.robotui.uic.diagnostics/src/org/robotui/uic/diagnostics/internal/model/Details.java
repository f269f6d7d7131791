package org.robotui.uic.diagnostics.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Finds a line of the trees and tells everything about it. */
final class Details {
  private final Reader reader;
  private final long lastSlot;

  Details(Reader reader, long lastSlot) {
    this.reader = reader;
    this.lastSlot = lastSlot;
  }

  /** The details of a line below a root. */
  Optional<DiagnosticsDetail> of(Node root, String key) {
    return find(root, key).map(node -> detail(root, node));
  }

  private DiagnosticsDetail detail(Node root, Node node) {
    Optional<Moment> moment = reader.moment(node);
    String name = node.part().map(Part::name)
        .orElseGet(() -> node == root ? root.label() : node.key().substring(root.key().length() + 1));
    return new DiagnosticsDetail(node.key(), name, root.key(), reader.level(node),
        moment.map(Moment::hardware).orElse(""),
        reader.message(node), reader.told(node), moment.map(Details::values).orElseGet(() -> children(node)),
        node.timeline().strip(lastSlot));
  }

  private static Optional<Node> find(Node node, String key) {
    if (node.key().equals(key)) {
      return Optional.of(node);
    }
    if (!key.startsWith(node.key() + "/")) {
      return Optional.empty();
    }
    return node.children().stream().flatMap(child -> find(child, key).stream()).findFirst();
  }

  private static List<DiagnosticsDetail.Value> values(Moment moment) {
    List<DiagnosticsDetail.Value> values = new ArrayList<>();
    moment.details().forEach((name, value) -> values.add(new DiagnosticsDetail.Value(name, value)));
    return List.copyOf(values);
  }

  private List<DiagnosticsDetail.Value> children(Node node) {
    return node.children().stream().map(child -> {
      String message = reader.message(child);
      return new DiagnosticsDetail.Value(child.label(),
          reader.level(child).word() + (message.isBlank() ? "" : ": " + message));
    }).toList();
  }
}
