package org.robotui.uic.diagnostics.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Makes the lines of the trees: what is open, or leads to what was searched for. */
final class RowBuilder {
  private final Ask ask;
  private final Reader reader;
  private final long lastSlot;
  private final List<String> words;
  private final List<DiagnosticsRow> rows = new ArrayList<>();

  RowBuilder(Ask ask, Reader reader, long lastSlot) {
    this.ask = ask;
    this.reader = reader;
    this.lastSlot = lastSlot;
    this.words = List.of(ask.search().strip().toLowerCase(Locale.ROOT).split("\\s+"));
  }

  /** Adds a line and all below it that are to be shown. */
  void add(Node node, int depth) {
    add(node, depth, false);
  }

  List<DiagnosticsRow> rows() {
    return List.copyOf(rows);
  }

  /**
   * Whether anything was added: a group of nothing is not shown while something is filtered; below a group found, all
   * is.
   */
  private boolean add(Node node, int depth, boolean aboveFound) {
    boolean found = aboveFound || contains(node);
    int at = rows.size();
    boolean group = !node.children().isEmpty();
    boolean filtered = filtered();
    boolean open = group && (filtered || ask.isOpen(node.key(), depth));
    rows.add(row(node, depth, group, open));
    boolean below = false;
    if (open) {
      for (Node child : node.children()) {
        below |= add(child, depth + 1, found);
      }
    }
    boolean wanted =
        !filtered || below || (found || ask.search().isBlank()) && (!ask.problems() || reader.level(node).problem());
    if (!wanted) {
      rows.subList(at, rows.size()).clear();
    }
    return wanted;
  }

  private boolean filtered() {
    return ask.problems() || !ask.search().isBlank();
  }

  private DiagnosticsRow row(Node node, int depth, boolean group, boolean open) {
    return new DiagnosticsRow(node.key(), depth, node.label(), group, open, reader.level(node), reader.message(node),
        node.timeline().strip(lastSlot));
  }

  private boolean contains(Node node) {
    if (ask.search().isBlank()) {
      return false;
    }
    Optional<Moment> moment = reader.moment(node);
    String text = (node.part().map(Part::name).orElse(node.label()) + '\n'
        + moment.map(m -> m.message() + '\n' + m.hardware() + '\n' + m.keys() + m.values()).orElse(""))
        .toLowerCase(Locale.ROOT);
    return words.stream().allMatch(text::contains);
  }
}
