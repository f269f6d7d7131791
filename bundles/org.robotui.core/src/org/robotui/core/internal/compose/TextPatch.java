package org.robotui.core.internal.compose;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import org.robotui.core.internal.compose.MarkedText.Span;
import org.yaml.snakeyaml.DumperOptions.FlowStyle;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.NodeTuple;

/**
 * Puts words into a YAML text, in the style of what stands around them: each gives the new text.
 *
 * @param marked the text
 */
record TextPatch(MarkedText marked) {
  private static final int USUAL_STEP = 2;

  String replace(Span span, String with) {
    return marked.text().substring(0, span.from()) + with + marked.text().substring(span.to());
  }

  /** A value, in sections that are made for it: {@code a: {b: word}}. */
  static String inBraces(List<String> path, String word) {
    String name = YamlWords.text(path.getFirst()) + ": ";
    return name + (path.size() == 1 ? word : "{" + inBraces(path.subList(1, path.size()), word) + "}");
  }

  /** Items of a list, each in a line, but for the indentation of the first. */
  String lines(List<String> items, int column) {
    return items.stream().map(i -> "- " + i).collect(Collectors.joining(marked.lineBreak() + " ".repeat(column)));
  }

  /** A name that is not there yet, with its value, as the last of a section. */
  String insert(MappingNode within, List<String> path, String word) {
    if (within.getFlowStyle() == FlowStyle.BLOCK) {
      int behind = marked.lineEnd(within.getValue().stream().mapToInt(marked::end).max().orElseThrow());
      int column = within.getValue().getFirst().getKeyNode().getStartMark().getColumn();
      return replace(new Span(behind, behind), block(path, word, column, step(within)));
    }
    if (within.getValue().isEmpty()) {
      int inside = marked.begin(within) + 1;
      return replace(new Span(inside, inside), inBraces(path, word));
    }
    int behind = marked.end(within.getValue().getLast());
    return replace(new Span(behind, behind), ", " + inBraces(path, word));
  }

  /** A section that holds nothing yet. */
  String fill(MappingNode within, NodeTuple entry, List<String> path, String word) {
    Node nothing = entry.getValueNode();
    int begin = marked.begin(nothing);
    boolean written = marked.end(nothing) > begin;
    if (written) {
      return replace(new Span(begin, marked.end(nothing)), "{" + inBraces(path, word) + "}");
    }
    if (within.getFlowStyle() == FlowStyle.FLOW) {
      return behindName(entry, "{" + inBraces(path, word) + "}");
    }
    int behind = marked.lineEnd(marked.end(entry.getKeyNode()));
    int step = step(within);
    int column = entry.getKeyNode().getStartMark().getColumn() + step;
    return replace(new Span(behind, behind), block(path, word, column, step));
  }

  /** In place of what stands behind a name, or of nothing; comments behind the name stay. */
  String behindName(NodeTuple entry, String word) {
    int name = marked.end(entry.getKeyNode());
    int colon = marked.text().indexOf(':', name);
    int end = marked.end(entry);
    boolean hasColon = colon >= 0 && marked.text().substring(name, colon).isBlank();
    if (!hasColon) {
      return replace(new Span(name, name), ": " + word);
    }
    if (end <= colon + 1) {
      return replace(new Span(colon + 1, colon + 1), " " + word);
    }
    int begin = marked.begin(entry.getValueNode());
    boolean commented = !marked.comments(new Span(colon, begin)).isEmpty();
    int kept = commented ? marked.lineEnd(marked.lineBegin(begin) - 2) : colon + 1;
    return replace(new Span(colon + 1, end), " " + word + marked.text().substring(colon + 1, kept));
  }

  /** Whether nothing stands before it in its line, such as the dash of a list. */
  boolean beginsLine(NodeTuple entry) {
    int begin = marked.begin(entry.getKeyNode());
    return marked.text().substring(marked.lineBegin(begin), begin).isBlank();
  }

  /**
   * Without a name that begins its line or stands in braces, and its value; comments beside them get lines of their
   * own.
   */
  String without(MappingNode within, NodeTuple entry) throws PathEdit.Refusal {
    int begin = marked.begin(entry.getKeyNode());
    int end = marked.end(entry);
    if (within.getFlowStyle() == FlowStyle.FLOW) {
      return withoutInBraces(within, entry, new Span(begin, end));
    }
    int line = marked.lineBegin(begin);
    int lineEnd = marked.lineEnd(end);
    String indent = marked.text().substring(line, begin);
    String comments = marked.comments(new Span(line, lineEnd)).stream()
        .map(c -> indent + c).collect(Collectors.joining(marked.lineBreak()));
    int next = marked.text().indexOf('\n', lineEnd) + 1;
    return comments.isEmpty() && next > 0 ? replace(new Span(line, next), "")
        : comments.isEmpty() ? replace(new Span(Math.max(0, line - marked.lineBreak().length()), lineEnd), "")
            : replace(new Span(line, lineEnd), comments);
  }

  private String withoutInBraces(MappingNode within, NodeTuple entry, Span own) throws PathEdit.Refusal {
    int at = within.getValue().indexOf(entry);
    boolean last = at == within.getValue().size() - 1;
    Span span = last && at > 0 ? new Span(marked.end(within.getValue().get(at - 1)), own.to())
        : last ? own : new Span(own.from(), marked.begin(within.getValue().get(at + 1).getKeyNode()));
    if (!marked.comments(span).isEmpty()) {
      throw new PathEdit.Refusal(marked.line(entry.getKeyNode()), "a comment stands beside it within the braces; change"
          + " it with an editor");
    }
    return replace(span, "");
  }

  /** Lines, each behind a line break. */
  private String block(List<String> path, String word, int column, int step) {
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < path.size(); i++) {
      String end = i == path.size() - 1 ? " " + word : "";
      lines.add(marked.lineBreak() + " ".repeat(column + i * step) + YamlWords.text(path.get(i)) + ":" + end);
    }
    return String.join("", lines);
  }

  /** How far sections are indented: those within, else those of the whole text. */
  private int step(MappingNode within) {
    OptionalInt near = steps(within, 0);
    return near.orElseGet(() -> marked.root().map(r -> steps(r, 0).orElse(USUAL_STEP)).orElse(USUAL_STEP));
  }

  private static OptionalInt steps(Node node, int depth) {
    if (!(node instanceof MappingNode m) || m.getFlowStyle() == FlowStyle.FLOW || depth > 4) {
      return OptionalInt.empty();
    }
    for (NodeTuple entry : m.getValue()) {
      int step = entry.getValueNode() instanceof MappingNode inner && inner.getFlowStyle() == FlowStyle.BLOCK
          ? inner.getStartMark().getColumn() - entry.getKeyNode().getStartMark().getColumn()
          : 0;
      if (step > 0) {
        return OptionalInt.of(step);
      }
    }
    return m.getValue().stream().map(e -> steps(e.getValueNode(), depth + 1)).filter(OptionalInt::isPresent)
        .findFirst().orElse(OptionalInt.empty());
  }
}
