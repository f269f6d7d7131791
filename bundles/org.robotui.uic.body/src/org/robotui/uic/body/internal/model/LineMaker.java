package org.robotui.uic.body.internal.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.status.BodyState;
import org.robotui.data.status.Diagnostics;
import org.robotui.ui.Health;

/** Makes the lines of a body: parts, what they said, and its fields. */
final class LineMaker {
  private static final int MOST = 5000;
  private static final int DEEPEST = 12;
  private static final int MOST_ITEMS = 100;

  private final BodyWish wish;
  private final double staleSeconds;
  private final double older;
  private final List<BodyLine> lines = new ArrayList<>();

  /** Of a body that is so many seconds older than its ages say. */
  LineMaker(BodyWish wish, double staleSeconds, double older) {
    this.wish = wish;
    this.staleSeconds = staleSeconds;
    this.older = older;
  }

  /** What a line is made of before it is known whether it is seen. */
  private record Node(String key, String title, String value, OptionalDouble number, double age, Health health,
      List<Node> below) {
    boolean has(String words) {
      return words.isBlank() || (title + " " + value).toLowerCase(Locale.ROOT).contains(words)
          || below.stream().anyMatch(node -> node.has(words));
    }

    Optional<Node> at(String wanted) {
      return key.equals(wanted) ? Optional.of(this)
          : below.stream().filter(node -> isAt(wanted, node.key())).flatMap(node -> node.at(wanted).stream())
              .findFirst();
    }
  }

  List<BodyLine> lines(String source, boolean named, BodyState body) {
    for (BodyState.Part part : body.parts()) {
      show(part(source, named, part), 0, true);
    }
    return lines;
  }

  /** One line alone, whether it is seen or not: nothing else is made. */
  static Optional<BodyLine> line(String source, BodyState body, String key) {
    LineMaker maker = new LineMaker(BodyWish.FIRST, Double.MAX_VALUE, 0);
    return body.parts().stream().filter(part -> isAt(key, source + "/" + part.name()))
        .map(part -> maker.part(source, false, part)).flatMap(node -> node.at(key).stream()).findFirst()
        .map(node -> new BodyLine(key, 0, node.title(), node.value(), node.number(), node.age(), node.health(),
            node.below().size(), false));
  }

  private static boolean isAt(String key, String above) {
    return key.equals(above) || key.startsWith(above + "/");
  }

  private Node part(String source, boolean named, BodyState.Part part) {
    String key = source + "/" + part.name();
    double age = part.silence() + older;
    boolean old = part.level() == Diagnostics.Level.OK && age > staleSeconds;
    List<Node> says = part.says().stream().map(saying -> saying(key, part, saying)).toList();
    String counts = part.restarts() + part.lost() == 0 ? ""
        : "  (" + part.restarts() + " restarts, " + part.lost() + " of " + (part.received() + part.lost()) + " lost)";
    return new Node(key, part.name() + (named ? "  " + source : ""),
        part.state() + (part.reason().isEmpty() ? "" : ": " + part.reason()) + counts, OptionalDouble.empty(), age,
        old ? Health.STALE : health(part.level()), says);
  }

  private static Health health(Diagnostics.Level level) {
    return switch (level) {
      case OK -> Health.OK;
      case WARNING -> Health.WARNING;
      case ERROR -> Health.BAD;
      case STALE -> Health.STALE;
    };
  }

  private Node saying(String before, BodyState.Part part, BodyState.Saying saying) {
    double age = saying.age() + older;
    Health health = age > staleSeconds || part.level() == Diagnostics.Level.STALE ? Health.STALE : Health.OK;
    String key = before + "/" + saying.name();
    return new Node(key, saying.name(), FieldWords.of(saying.content()), OptionalDouble.empty(), age, health,
        fields(key, saying.content(), age, health, 2));
  }

  private List<Node> fields(String before, DynamicRecord record, double age, Health health, int depth) {
    Map<String, FieldValue> all = new LinkedHashMap<>();
    record.fields().forEach(name -> record.field(name).ifPresent(value -> all.put(name, value)));
    return all.entrySet().stream()
        .map(e -> field(before + "/" + e.getKey(), e.getKey(), e.getValue(), age, health, depth)).toList();
  }

  private Node field(String key, String name, FieldValue value, double age, Health health, int depth) {
    List<Node> below = new ArrayList<>();
    if (value instanceof FieldValue.Nested nested && depth < DEEPEST) {
      below.addAll(fields(key, nested.value(), age, health, depth + 1));
    } else if (value instanceof FieldValue.Items items && depth < DEEPEST) {
      for (int i = 0; i < Math.min(MOST_ITEMS, items.values().size()); i++) {
        below.add(field(key + "/" + (i + 1), String.valueOf(i + 1), items.values().get(i), age, health, depth + 1));
      }
    }
    return new Node(key, name, FieldWords.of(value), FieldWords.number(value), age, health, below);
  }

  private void show(Node node, int depth, boolean openFirst) {
    String words = wish.search().strip().toLowerCase(Locale.ROOT);
    if (lines.size() >= MOST || !node.has(words)) {
      return;
    }
    boolean open = !words.isEmpty() || openFirst != wish.turned().contains(node.key());
    lines.add(new BodyLine(node.key(), depth, node.title(), node.value(), node.number(), node.age(), node.health(),
        node.below().size(), open));
    if (open) {
      node.below().forEach(below -> show(below, depth + 1, false));
    }
  }
}
