package org.robotui.core.internal.compose;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.config.ValueType;
import org.robotui.core.internal.config.ForNames;
import org.yaml.snakeyaml.DumperOptions.FlowStyle;
import org.yaml.snakeyaml.DumperOptions.ScalarStyle;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.nodes.CollectionNode;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.NodeTuple;
import org.yaml.snakeyaml.nodes.ScalarNode;
import org.yaml.snakeyaml.nodes.SequenceNode;

/**
 * Sets or removes one value of a YAML text and leaves every other character as it is. That nothing else has changed is
 * looked at afterwards, in what the text says and in its comments.
 */
final class PathEdit {
  /** What a component says that is written as one word. */
  static final String TYPE = "type";

  private static final Set<String> COMPONENTS = Set.of("rfics", "uics");
  private static final int ID_DEPTH = 3;

  /** What cannot be changed like this. */
  static final class Refusal extends Exception {
    private static final long serialVersionUID = 1L;
    private final int line;

    /** A sentence that follows the place, and the line from 1. */
    Refusal(int line, String reason) {
      super(reason);
      this.line = line;
    }

    int line() {
      return line;
    }
  }

  private final MarkedText text;
  private final List<String> path;
  private final TextPatch patch;

  private PathEdit(MarkedText text, List<String> path) {
    this.text = text;
    this.path = path;
    this.patch = new TextPatch(this.text);
  }

  /** The text with a value at a path; sections that are not there are made. */
  static String set(String text, List<String> path, Object value, ValueType type) throws Refusal {
    String word = YamlWords.value(value, type);
    List<String> items = value instanceof List<?> list
        ? list.stream().map(v -> YamlWords.value(v, YamlWords.element(type))).toList()
        : List.of();
    PathEdit edit = new PathEdit(new MarkedText(text), path);
    return edit.checked(Optional.of(word), edit.set(word, items));
  }

  /** The text without the value at a path; the same where there is none. */
  static String remove(String text, List<String> path) throws Refusal {
    PathEdit edit = new PathEdit(new MarkedText(text), path);
    return edit.checked(Optional.empty(), edit.remove());
  }

  private String checked(Optional<String> word, String after) throws Refusal {
    try {
      Object wanted = YamlTree.with(YamlTree.of(text), path, word.map(YamlTree::of));
      MarkedText now = new MarkedText(after);
      if (YamlTree.of(now).equals(wanted) && now.comments().equals(text.comments())) {
        return after;
      }
    } catch (YAMLException e) {
      throw new Refusal(1, "its style is one that only an editor can change (" + e.getMessage() + ")");
    }
    throw new Refusal(1, "its style is one that only an editor can change: '" + String.join("/", path) + "'");
  }

  private String set(String word, List<String> items) throws Refusal {
    CollectionNode<?> at = top();
    for (int depth = 0;; depth++) {
      Optional<NodeTuple> found = find(at, path.get(depth));
      List<String> rest = path.subList(depth + 1, path.size());
      if (found.isEmpty()) {
        return patch.insert(section(at), path.subList(depth, path.size()), word);
      }
      NodeTuple entry = found.get();
      Node value = entry.getValueNode();
      if (rest.isEmpty()) {
        return replaced(entry, word, items);
      }
      if (value instanceof CollectionNode<?> part) {
        at = part;
      } else if (YamlTree.isNothing(value)) {
        return patch.fill(section(at), entry, rest, word);
      } else if (depth == ID_DEPTH && COMPONENTS.contains(path.get(depth - 1))
          && value instanceof ScalarNode type) {
        return patch.replace(new MarkedText.Span(text.begin(type), text.end(type)),
            "{type: " + YamlWords.text(type.getValue()) + ", " + TextPatch.inBraces(rest, word) + "}");
      } else {
        throw new Refusal(text.line(value), "'" + path.get(depth) + "' is no section there");
      }
    }
  }

  private String replaced(NodeTuple entry, String word, List<String> items) throws Refusal {
    Node value = entry.getValueNode();
    MarkedText.Span span = new MarkedText.Span(text.begin(value), text.end(value));
    boolean block = value instanceof CollectionNode<?> c && c.getFlowStyle() == FlowStyle.BLOCK;
    boolean folded =
        value instanceof ScalarNode s && Set.of(ScalarStyle.LITERAL, ScalarStyle.FOLDED).contains(s.getScalarStyle());
    if (folded || !text.comments(span).isEmpty()) {
      throw new Refusal(text.line(value), "the value has lines of its own or comments in it; change it with an editor");
    }
    if (value instanceof SequenceNode && block && !items.isEmpty()) {
      return patch.replace(span, patch.lines(items, value.getStartMark().getColumn()));
    }
    if (entry.getKeyNode() == value && span.from() < span.to()) {
      return patch.replace(span, word); // an item of a list
    }
    return block || YamlTree.isNothing(value) && span.from() == span.to() ? patch.behindName(entry, word)
        : patch.replace(span, word);
  }

  private String remove() throws Refusal {
    CollectionNode<?> at = top();
    for (String name : path.subList(0, path.size() - 1)) {
      Optional<Node> next = find(at, name).map(NodeTuple::getValueNode);
      if (next.isEmpty() || !(next.get() instanceof CollectionNode<?> part)) {
        return text.text();
      }
      at = part;
    }
    Optional<NodeTuple> entry = find(at, path.getLast());
    if (entry.isEmpty()) {
      return text.text();
    }
    boolean alone =
        at instanceof MappingNode m && (m.getFlowStyle() == FlowStyle.FLOW || patch.beginsLine(entry.get()));
    return alone ? patch.without(section(at), entry.get())
        : ItemSpans.of(text, at).without(at instanceof MappingNode m ? m.getValue().indexOf(entry.get())
            : Integer.parseInt(path.getLast()));
  }

  /** The list or section at a path, whose items are to be changed. */
  static CollectionNode<?> items(MarkedText text, List<String> path) throws Refusal {
    PathEdit edit = new PathEdit(text, path);
    CollectionNode<?> at = edit.top();
    for (String name : path) {
      Optional<NodeTuple> found = edit.find(at, name);
      if (found.isEmpty() || !(found.get().getValueNode() instanceof CollectionNode<?> part)
          || part.getValue().isEmpty()) {
        throw new Refusal(text.line(at), "there are no items in '" + name + "'");
      }
      at = part;
    }
    if (at instanceof MappingNode section) {
      edit.find(section, ""); // refuses what a template may form
    }
    return at;
  }

  private MappingNode section(CollectionNode<?> at) throws Refusal {
    if (at instanceof MappingNode section) {
      return section;
    }
    throw new Refusal(text.line(at), "there is a list, which has not so many items");
  }

  private MappingNode top() throws Refusal {
    if (text.root().orElse(null) instanceof MappingNode top) {
      return top;
    }
    throw new Refusal(1, "there is no configuration in it");
  }

  /** What the path leads to must stand there once, and mean itself only. */
  private Optional<NodeTuple> find(CollectionNode<?> within, String name) throws Refusal {
    return within instanceof SequenceNode list ? item(list, name) : entry(section(within), name);
  }

  private Optional<NodeTuple> item(SequenceNode list, String place) throws Refusal {
    for (Node item : list.getValue()) {
      if (isTemplate(item)) {
        throw formed(item, place);
      }
    }
    int index = Integer.parseInt(place);
    if (index >= list.getValue().size()) {
      return Optional.empty();
    }
    Node item = list.getValue().get(index);
    if (text.begin(item) < text.begin(list) || item.getAnchor() != null) {
      throw shared(item, place);
    }
    return Optional.of(new NodeTuple(item, item));
  }

  private Refusal shared(Node at, String name) {
    return new Refusal(text.line(at), "'" + name + "' is shared by an anchor or an alias (& or *); change it with an"
        + " editor");
  }

  private Optional<NodeTuple> entry(MappingNode within, String name) throws Refusal {
    for (NodeTuple entry : within.getValue()) {
      Node key = entry.getKeyNode();
      Node value = entry.getValueNode();
      boolean meant = key instanceof ScalarNode s && s.getValue().equals(name);
      if (meant && (text.begin(value) < text.begin(key) || value.getAnchor() != null)) {
        throw shared(key, name);
      }
      if (meant && isTemplate(value)) {
        throw formed(key, name);
      }
      if (meant) {
        return Optional.of(entry);
      }
    }
    for (NodeTuple entry : within.getValue()) {
      if (isTemplate(entry.getValueNode())) {
        throw formed(entry.getKeyNode(), name);
      }
    }
    return Optional.empty();
  }

  private Refusal formed(Node key, String name) {
    return new Refusal(text.line(key), "'" + name + "' may be formed by the template there (for:), which means several"
        + " robots; change it with an editor");
  }

  private static boolean isTemplate(Node node) {
    return node instanceof MappingNode m && m.getValue().stream()
        .filter(t -> t.getKeyNode() instanceof ScalarNode s && ForNames.KEY.equals(s.getValue()))
        .map(NodeTuple::getValueNode)
        .anyMatch(names -> !(names instanceof ScalarNode s) || ForNames.isNames(s.getValue()));
  }
}
