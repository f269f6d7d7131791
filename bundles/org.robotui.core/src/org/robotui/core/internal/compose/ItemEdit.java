package org.robotui.core.internal.compose;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.nodes.CollectionNode;

/**
 * Changes the items of one list or section within a YAML text: their order, names and number. What the new text says is
 * compared with what was wanted.
 */
final class ItemEdit {
  private final MarkedText text;
  private final List<String> path;
  private final ItemSpans items;

  private ItemEdit(String text, List<String> path) throws PathEdit.Refusal {
    this.text = new MarkedText(text);
    this.path = path;
    CollectionNode<?> node = PathEdit.items(this.text, path);
    this.items = ItemSpans.of(this.text, node);
  }

  /** The text with the items in another order, each by its present place. */
  static String arranged(String text, List<String> path, List<Integer> order) throws PathEdit.Refusal {
    ItemEdit edit = new ItemEdit(text, path);
    Object wanted = switch (edit.said()) {
      case List<?> list -> order.stream().map(list::get).toList();
      case Map<?, ?> map -> arranged(map, order);
      default -> throw edit.refusal();
    };
    return edit.checked(edit.items.arranged(order), wanted, true);
  }

  private static Map<Object, Object> arranged(Map<?, ?> map, List<Integer> order) {
    List<Map.Entry<?, ?>> entries = new ArrayList<>(map.entrySet());
    Map<Object, Object> wanted = new LinkedHashMap<>();
    order.forEach(i -> wanted.put(entries.get(i).getKey(), entries.get(i).getValue()));
    return wanted;
  }

  /** The text with another name for an entry of a section. */
  static String renamed(String text, List<String> path, String from, String to) throws PathEdit.Refusal {
    ItemEdit edit = new ItemEdit(text, path);
    if (!(edit.said() instanceof Map<?, ?> map)) {
      throw edit.refusal();
    }
    Map<Object, Object> wanted = new LinkedHashMap<>();
    map.forEach((name, value) -> wanted.put(name.equals(from) ? to : name, value));
    return edit.checked(edit.items.named(List.copyOf(map.keySet()).indexOf(from), to), wanted, false);
  }

  /** The text with one more item at the end of a list. */
  static String appended(String text, List<String> path, String word) throws PathEdit.Refusal {
    ItemEdit edit = new ItemEdit(text, path);
    if (!(edit.said() instanceof List<?> list)) {
      throw edit.refusal();
    }
    List<Object> wanted = new ArrayList<>(list);
    wanted.add(YamlTree.of(word));
    return edit.checked(edit.items.with(word), wanted, false);
  }

  private Object said() {
    return YamlTree.at(YamlTree.of(text), path);
  }

  /** Maps are equal whatever their order; their words are not. */
  private String checked(String after, Object wanted, boolean moves) throws PathEdit.Refusal {
    try {
      MarkedText now = new MarkedText(after);
      Object tree = YamlTree.of(now);
      boolean fine = tree.equals(YamlTree.with(YamlTree.of(text), path, Optional.of(wanted)))
          && YamlTree.at(tree, path).toString().equals(wanted.toString())
          && comments(now, moves).equals(comments(text, moves));
      if (fine) {
        return after;
      }
    } catch (YAMLException e) {
      throw refusal();
    }
    throw refusal();
  }

  private static List<String> comments(MarkedText text, boolean moves) {
    return moves ? text.comments().stream().sorted().toList() : text.comments();
  }

  private PathEdit.Refusal refusal() {
    return new PathEdit.Refusal(1, "its style is one that only an editor can change: '" + String.join("/", path) + "'");
  }
}
