package org.robotui.uic.topics.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.robotui.api.port.Browser.Kind;
import org.robotui.uic.topics.internal.model.TopicRow.Counts;

/** The facts of a description as lines, with names of things as links. Pure. */
final class Facts {
  private static final String SEPARATOR = ", ";
  private static final String NONE = "none";

  private Facts() {}

  static List<Fact> of(Key about, Map<String, String> facts, Catalog catalog) {
    List<Fact> lines = new ArrayList<>();
    facts.forEach((label, value) -> {
      String shown = label;
      for (String part : parts(value)) {
        lines.add(new Fact(lines.size(), shown, part, target(about, label, part, catalog)));
        shown = "";
      }
    });
    return List.copyOf(lines);
  }

  /** How many use the thing, as its facts list them. */
  static Counts counts(Kind kind, Map<String, String> facts) {
    return switch (kind) {
      case TOPIC -> new Counts(count(facts, "publishers"), count(facts, "subscribers"));
      case NODE -> new Counts(count(facts, "publishes"), count(facts, "subscribes"));
      case ACTION -> new Counts(count(facts, "servers"), count(facts, "clients"));
      default -> Counts.UNKNOWN;
    };
  }

  private static OptionalInt count(Map<String, String> facts, String label) {
    return Optional.ofNullable(facts.get(label))
        .map(value -> OptionalInt.of(value.equals(NONE) || value.isBlank() ? 0 : parts(value).size()))
        .orElseGet(OptionalInt::empty);
  }

  /** Only lists of names are taken apart, not sentences with a comma. */
  private static List<String> parts(String value) {
    List<String> parts = List.of(value.split(SEPARATOR));
    return parts.size() > 1 && parts.stream().allMatch(part -> part.startsWith("/")) ? parts : List.of(value);
  }

  private static Optional<Key> target(Key about, String label, String name, Catalog catalog) {
    return likely(about.kind(), label)
        .map(kind -> new Key(about.robot(), kind, name))
        .filter(key -> !key.equals(about) && catalog.find(key).isPresent())
        .findFirst();
  }

  private static Stream<Kind> likely(Kind about, String label) {
    if (label.startsWith("service")) {
      return Stream.of(Kind.SERVICE, Kind.NODE, Kind.TOPIC);
    }
    return about == Kind.NODE ? Stream.of(Kind.TOPIC, Kind.SERVICE) : Stream.of(Kind.NODE, Kind.TOPIC, Kind.SERVICE);
  }
}
