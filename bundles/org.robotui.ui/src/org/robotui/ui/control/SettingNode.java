package org.robotui.ui.control;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;

/**
 * What a user gives to one setting, with all that is within it: a line, a group with its members, or many items. What
 * is blank is left to the component. Display thread.
 */
final class SettingNode {
  private Setting setting;
  private final BiFunction<Setting, Object, Optional<String>> check;
  private final boolean item;
  private final List<SettingNode> nodes = new ArrayList<>();
  private Object before;
  private String name;
  private SettingShape shape;
  private SettingValue line;

  private SettingNode(Setting setting, String name, Optional<Object> value, boolean item,
      BiFunction<Setting, Object, Optional<String>> check) {
    this.setting = setting;
    this.name = name;
    this.item = item;
    this.check = check;
    take(SettingShape.of(setting.type(), value.orElse("")), value);
  }

  /** One setting of a component. */
  static SettingNode of(Setting setting, Optional<Object> value, BiFunction<Setting, Object, Optional<String>> check) {
    return new SettingNode(setting, setting.name(), value, false, check);
  }

  private void take(SettingShape next, Optional<Object> value) {
    shape = next;
    before = value.orElse("");
    nodes.clear();
    line = new SettingValue(setting, value.filter(v -> next instanceof SettingShape.Line), check);
    switch (next) {
      case SettingShape.Line l -> line = new SettingValue(typed(setting, l.type()), line.value(), check);
      case SettingShape.Group g -> g.schema().settings().forEach(
          s -> nodes.add(of(within(s, map(before)), Optional.ofNullable(map(before).get(s.name())), check)));
      case SettingShape.Many m when m.named() -> map(before).forEach((n, v) -> put(n.toString(), Optional.of(v)));
      case SettingShape.Many m -> list(before).forEach(v -> put("", Optional.of(v)));
    }
  }

  /** A setting whose type follows from others, with the type that it has among them. */
  private static Setting within(Setting setting, Map<?, ?> group) {
    return setting.type() instanceof ValueType.Dependent dependent ? typed(setting, dependent.in(group)) : setting;
  }

  private static Setting typed(Setting setting, ValueType type) {
    return new Setting(setting.name(), type, setting.fallback(), setting.required(), setting.help());
  }

  /**
   * Gives another form to what follows from a setting that was changed. Words that nothing is known of change nothing,
   * as such are there while one is typed.
   *
   * @return whether anything has another form now
   */
  boolean follow() {
    boolean followed = false;
    if (shape instanceof SettingShape.Group group) {
      for (Setting declared : group.schema().settings()) {
        followed |= declared.type() instanceof ValueType.Dependent dependent && follow(declared, dependent);
      }
    }
    for (SettingNode node : nodes) {
      followed |= node.follow();
    }
    return followed;
  }

  private boolean follow(Setting declared, ValueType.Dependent dependent) {
    ValueType next = dependent.in(members());
    SettingNode node = nodes.stream().filter(n -> n.name.equals(declared.name())).findFirst().orElseThrow();
    boolean other = dependent.types().containsValue(next) && !node.setting.type().equals(next);
    if (other) {
      Optional<Object> value = node.value();
      node.setting = typed(declared, next);
      node.take(SettingShape.of(next, value.orElse("")), value);
    }
    return other;
  }

  private static Map<?, ?> map(Object value) {
    return value instanceof Map<?, ?> map ? map : Map.of();
  }

  private static List<?> list(Object value) {
    return value instanceof List<?> list ? list : List.of();
  }

  private SettingNode put(String named, Optional<Object> value) {
    Setting element = new Setting(setting.name(), ((SettingShape.Many) shape).element(), Optional.empty(), false,
        setting.help());
    SettingNode node = new SettingNode(element, named, value, true, check);
    nodes.add(node);
    return node;
  }

  /** One more item, with a name where items have one. */
  SettingNode add(String named) {
    return put(named, Optional.empty());
  }

  void remove(SettingNode node) {
    nodes.remove(node);
  }

  /** Moves an item by some places; stays where there is no such place. */
  void move(SettingNode node, int by) {
    int at = nodes.indexOf(node);
    if (at + by >= 0 && at + by < nodes.size()) {
      nodes.remove(at);
      nodes.add(at + by, node);
    }
  }

  void rename(String next) {
    name = next;
  }

  /** Another form of the same value: what was typed is gone. */
  void reshape(SettingShape next) {
    take(next, Optional.empty());
  }

  Setting setting() {
    return setting;
  }

  /** Of the setting, or of an item that has one; else empty. */
  String name() {
    return name;
  }

  boolean isItem() {
    return item;
  }

  SettingShape shape() {
    return shape;
  }

  /** What is typed, where its shape is a line. */
  SettingValue line() {
    return line;
  }

  /** Members or items. */
  List<SettingNode> nodes() {
    return List.copyOf(nodes);
  }

  /** What is given: Boolean, numbers where a text might be meant as well, else String, List or Map. */
  Optional<Object> value() {
    return switch (shape) {
      case SettingShape.Line l -> line.value().or(() -> item ? Optional.of("") : Optional.empty());
      case SettingShape.Group g -> Optional.<Object>of(members()).filter(v -> item || !nodesGiven().isEmpty());
      case SettingShape.Many m when nodes.isEmpty() -> Optional.empty();
      case SettingShape.Many m when m.named() -> Optional.of(items());
      case SettingShape.Many m -> Optional.of(nodes.stream().map(n -> n.value().orElse("")).toList());
    };
  }

  private List<SettingNode> nodesGiven() {
    return nodes.stream().filter(n -> n.value().isPresent()).toList();
  }

  /** In the order of the file, so that nothing moves there. */
  private Map<String, Object> members() {
    Map<String, Object> given = new LinkedHashMap<>();
    nodesGiven().forEach(n -> given.put(n.name, n.value().orElseThrow()));
    Set<String> order = new LinkedHashSet<>();
    map(before).keySet().forEach(k -> order.add(k.toString()));
    order.addAll(given.keySet());
    Map<String, Object> members = new LinkedHashMap<>();
    order.stream().filter(given::containsKey).forEach(n -> members.put(n, given.get(n)));
    return members;
  }

  private Map<String, Object> items() {
    Map<String, Object> items = new LinkedHashMap<>();
    nodes.forEach(n -> items.put(n.name, n.value().orElse("")));
    return items;
  }

  /** What is wrong with it itself, not with what is within it, as the end of a sentence that begins with its name. */
  Optional<String> problem() {
    if (shape instanceof SettingShape.Line) {
      return item && line.value().isEmpty() ? Optional.of("is blank; write what is meant, or remove it")
          : line.problem();
    }
    if (value().isEmpty()) {
      return setting.required() ? Optional.of("'" + name + "' is needed: " + setting.help()) : Optional.empty();
    }
    return problemsWithin("").isEmpty() ? check.apply(setting, value().get()) : Optional.empty();
  }

  /** All that is wrong, each with the path from here. */
  List<FormProblem> problems(String path) {
    List<FormProblem> problems = problemsWithin(path);
    if (problems.isEmpty()) {
      problem().ifPresent(p -> problems.add(new FormProblem(path, p)));
    }
    return problems;
  }

  private List<FormProblem> problemsWithin(String path) {
    List<FormProblem> problems = new ArrayList<>();
    boolean asked = item || setting.required() || value().isPresent();
    for (int i = 0; asked && i < nodes.size(); i++) {
      SettingNode node = nodes.get(i);
      problems.addAll(node.problems(path + "/" + (node.name.isEmpty() ? Integer.toString(i + 1) : node.name)));
    }
    return problems;
  }

  /** What it is called among others: its name, else its place from 1. */
  String title(int index) {
    return name.isEmpty() ? Integer.toString(index + 1) : name;
  }

  /** A few words on what is in it. */
  String summary() {
    return switch (shape) {
      case SettingShape.Line l -> line.text();
      case SettingShape.Many m -> nodes.isEmpty() ? "none" : nodes.size() + (nodes.size() == 1 ? " item" : " items");
      case SettingShape.Group g -> String.join(", ", nodesGiven().stream()
          .map(n -> n.shape instanceof SettingShape.Line ? n.line.text() : n.name + ": " + n.summary())
          .filter(Objects::nonNull).toList());
    };
  }
}
