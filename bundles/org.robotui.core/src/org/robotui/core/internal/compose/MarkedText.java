package org.robotui.core.internal.compose;

import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.yaml.snakeyaml.DumperOptions.FlowStyle;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.error.Mark;
import org.yaml.snakeyaml.nodes.CollectionNode;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.NodeTuple;
import org.yaml.snakeyaml.nodes.ScalarNode;
import org.yaml.snakeyaml.nodes.SequenceNode;

/** A YAML text with its nodes, and where in the text they stand. The text was read without an error before. */
final class MarkedText {
  /** From a character to before another one. */
  record Span(int from, int to) {}

  private final String text;
  /** Counting from the beginning for each mark takes long, and hardly a text has such characters. */
  private final boolean isBasic;
  private final Optional<Node> root;
  private final List<Span> comments = new ArrayList<>();

  /** Parses; throws a YAMLException where it is none. */
  MarkedText(String text) {
    this.text = text;
    this.isBasic = text.codePointCount(0, text.length()) == text.length();
    LoaderOptions options = new LoaderOptions();
    options.setCodePointLimit(Math.max(1, text.length()));
    this.root = Optional.ofNullable(new Yaml(options).compose(new StringReader(text)));
    List<Span> scalars = new ArrayList<>();
    root.ifPresent(node -> scalars(node, scalars));
    int at = 0;
    for (Span scalar : scalars) {
      comments(at, scalar.from());
      at = Math.max(at, scalar.to());
    }
    comments(at, text.length());
  }

  String text() {
    return text;
  }

  Optional<Node> root() {
    return root;
  }

  /** The texts of all comments, in their order. */
  List<String> comments() {
    return comments(new Span(0, text.length()));
  }

  /** The texts of the comments that begin within a part of the text, in their order. */
  List<String> comments(Span within) {
    return comments.stream().filter(c -> c.from() >= within.from() && c.from() < within.to())
        .map(c -> text.substring(c.from(), c.to())).toList();
  }

  int begin(Node node) {
    return index(node.getStartMark());
  }

  /** Behind what it consists of: the end marks of blocks lie at what follows them. */
  int end(Node node) {
    if (node instanceof CollectionNode<?> c && c.getFlowStyle() == FlowStyle.BLOCK) {
      return switch (node) {
        case MappingNode m -> m.getValue().stream().mapToInt(this::end).max().orElse(begin(node));
        case SequenceNode s -> s.getValue().stream().mapToInt(this::end).max().orElse(begin(node));
        default -> begin(node);
      };
    }
    return begin(node) + text.substring(begin(node), index(node.getEndMark())).stripTrailing().length();
  }

  /** The same of a name with its value. */
  int end(NodeTuple tuple) {
    return Math.max(end(tuple.getKeyNode()), end(tuple.getValueNode()));
  }

  /** From 1. */
  int line(Node node) {
    return node.getStartMark().getLine() + 1;
  }

  int lineBegin(int at) {
    return text.lastIndexOf('\n', at - 1) + 1;
  }

  /** Before the end of the line. */
  int lineEnd(int at) {
    int end = text.indexOf('\n', at);
    return end < 0 ? text.length() : end > at && text.charAt(end - 1) == '\r' ? end - 1 : end;
  }

  /** How its lines end. */
  String lineBreak() {
    return text.contains("\r\n") ? "\r\n" : "\n";
  }

  /** Marks count characters beyond the basic plane once. */
  private int index(Mark mark) {
    return isBasic ? mark.getIndex() : text.offsetByCodePoints(0, mark.getIndex());
  }

  private void scalars(Node node, List<Span> found) {
    switch (node) {
      case ScalarNode s -> found.add(new Span(begin(s), index(s.getEndMark())));
      case MappingNode m -> m.getValue().forEach(t -> {
        scalars(t.getKeyNode(), found);
        ifWrittenBehind(begin(t.getKeyNode()), t.getValueNode(), found);
      });
      case SequenceNode s -> s.getValue().forEach(item -> ifWrittenBehind(begin(s), item, found));
      default -> {}
    }
  }

  /** An alias is the node that it stands for, which was written before. */
  private void ifWrittenBehind(int before, Node node, List<Span> found) {
    if (begin(node) >= before) {
      scalars(node, found);
    }
  }

  private void comments(int from, int to) {
    int at = from;
    while (at < to) {
      boolean begins = text.charAt(at) == '#' && (at == 0 || Character.isWhitespace(text.charAt(at - 1)));
      if (begins) {
        comments.add(new Span(at, lineEnd(at)));
      }
      at = begins ? lineEnd(at) : at + 1;
    }
  }
}
