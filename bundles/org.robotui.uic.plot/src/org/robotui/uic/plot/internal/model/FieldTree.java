package org.robotui.uic.plot.internal.model;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.robotui.api.port.Input;
import org.robotui.api.port.NumberField;
import org.robotui.api.port.SourceId;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/**
 * All that could be plotted, as the rows of a tree: the sources, and below those that were opened, their fields. One
 * thread.
 */
public final class FieldTree {
  /**
   * A row.
   *
   * @param depth 0 for sources
   * @param key tells rows apart
   * @param name what it is called
   * @param detail its type or its value
   * @param opens whether there is something below it
   * @param open whether that is shown
   * @param signals what choosing it plots: one for a number, several for a short list, none for what is no number
   */
  public record Row(int depth, String key, String name, String detail, boolean opens, boolean open,
      List<String> signals) {}

  /** What a source was seen to have: by the names of our data records, and by the robot's own where these differ. */
  public record Learned(DynamicRecord data, Optional<DynamicRecord> own) {}

  /** The longest list of which all elements are plotted at once. */
  public static final int SHORT_LIST = 12;

  private static final int MOST_ELEMENTS = 256;
  private static final int DEEPEST = 12;
  private static final String OWN = "names of the robot";

  private final Set<String> open = new HashSet<>();
  private Set<SourceId> openSources = Set.of();

  /** Opens what is closed, and closes what is open. */
  public void toggle(Row row) {
    if (row.opens() && !open.remove(row.key())) {
      open.add(row.key());
    }
  }

  /** Opens a source, whether it is there already or not. */
  public void open(SourceId source) {
    open.add(source.toString());
  }

  /** The sources whose fields are to be learned. */
  public Set<SourceId> openSources() {
    return openSources;
  }

  /**
   * The rows to show; with a filter only those that have it in their source, type or path, opened where that is below.
   */
  public List<Row> rows(List<Input.Candidate> candidates, Function<SourceId, Optional<Learned>> learned,
      String filter) {
    String words = filter.strip().toLowerCase(Locale.ROOT);
    Set<SourceId> opened = new HashSet<>();
    List<Row> rows = new ArrayList<>();
    for (Input.Candidate candidate : candidates) {
      String key = candidate.id().toString();
      boolean isOpen = open.contains(key);
      if (isOpen) {
        opened.add(candidate.id());
      }
      boolean named = (key + " " + candidate.typeName()).toLowerCase(Locale.ROOT).contains(words);
      List<Row> below = learned.apply(candidate.id()).filter(l -> isOpen || !named)
          .map(l -> fields(key, l, named ? "" : words)).orElse(List.of());
      if (named || !below.isEmpty()) {
        rows.add(new Row(0, key, key, candidate.typeName(), true, isOpen || !named, List.of()));
        rows.addAll(isOpen && below.isEmpty() ? List.of(waiting(key)) : below);
      }
    }
    openSources = Set.copyOf(opened);
    return rows;
  }

  private static Row waiting(String key) {
    return new Row(1, key + "?", "waiting for a value\u2026", "", false, false, List.of());
  }

  private List<Row> fields(String source, Learned learned, String filter) {
    Walk walk = new Walk(source, filter);
    walk.record(learned.data(), "", source + ":", 1);
    learned.own().ifPresent(own -> {
      String key = source + "!";
      boolean isOpen = !filter.isEmpty() || open.contains(key);
      int before = walk.rows.size();
      walk.rows.add(new Row(1, key, OWN, own.schema(), true, isOpen, List.of()));
      if (isOpen) {
        walk.record(own, "", key, 2);
      }
      if (!filter.isEmpty() && walk.rows.size() == before + 1) {
        walk.rows.removeLast();
      }
    });
    return walk.rows;
  }

  /** One way through the fields of a source. */
  private final class Walk {
    private final String source;
    private final String filter;
    private final List<Row> rows = new ArrayList<>();

    Walk(String source, String filter) {
      this.source = source;
      this.filter = filter;
    }

    void record(DynamicRecord record, String prefix, String keys, int depth) {
      for (String name : record.fields()) {
        String path = prefix.isEmpty() ? name : prefix + "." + name;
        record.field(name).ifPresent(value -> value(name, path, keys, value, depth));
      }
    }

    private void value(String name, String path, String keys, FieldValue value, int depth) {
      boolean opens = opens(value) && depth < DEEPEST;
      boolean isOpen =
          opens && (open.contains(keys + path) || !filter.isEmpty() && !(value instanceof FieldValue.Numbers));
      boolean seen = filter.isEmpty() || path.toLowerCase(Locale.ROOT).contains(filter);
      int before = rows.size();
      rows.add(new Row(depth, keys + path, name, detail(value), opens, isOpen, signals(path, value)));
      if (isOpen) {
        below(path, keys, value, depth + 1);
      }
      if (!seen && rows.size() == before + 1) {
        rows.removeLast();
      }
    }

    private void below(String path, String keys, FieldValue value, int depth) {
      switch (value) {
        case FieldValue.Nested n -> record(n.value(), path, keys, depth);
        case FieldValue.Numbers n -> IntStream.range(0, Math.min(MOST_ELEMENTS, n.values().size())).forEach(
            i -> value("[" + i + "]", path + "[" + i + "]", keys, new FieldValue.Num(n.values().get(i), ""), depth));
        case FieldValue.Items n -> IntStream.range(0, Math.min(MOST_ELEMENTS, n.values().size()))
            .forEach(i -> value("[" + i + "]" + called(n.values().get(i)), path + "[" + i + "]", keys,
                n.values().get(i), depth));
        default -> {}
      }
    }

    private List<String> signals(String path, FieldValue value) {
      if (NumberField.number(value).isPresent()) {
        return List.of(source + ":" + path);
      }
      if (value instanceof FieldValue.Numbers n && n.values().size() <= SHORT_LIST) {
        return IntStream.range(0, n.values().size()).mapToObj(i -> source + ":" + path + "[" + i + "]").toList();
      }
      return List.of();
    }
  }

  private static boolean opens(FieldValue value) {
    return switch (value) {
      case FieldValue.Nested n -> !n.value().fields().isEmpty();
      case FieldValue.Numbers n -> n.values().size() > 0;
      case FieldValue.Items n -> !n.values().isEmpty();
      default -> false;
    };
  }

  private static String detail(FieldValue value) {
    return switch (value) {
      case FieldValue.Text t -> t.value().lines().findFirst().orElse("");
      case FieldValue.Nested n -> n.value().schema();
      case FieldValue.Numbers n -> n.values().size() + " numbers";
      case FieldValue.Items n -> n.values().size() + " elements";
      case FieldValue.Flag f -> Boolean.toString(f.value());
      default -> NumberField.number(value).map(Readout::of).orElse("");
    };
  }

  /** The name that an element gives to itself, as joints do. */
  private static String called(FieldValue element) {
    return element instanceof FieldValue.Nested n
        && n.value().field("name").orElse(element) instanceof FieldValue.Text t
            ? " " + t.value()
            : "";
  }
}
