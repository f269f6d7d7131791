package org.robotui.uic.topics.internal.model;

import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.api.port.Browser.Kind;

/**
 * All that the robots have, as they last said.
 *
 * @param robots who was asked
 * @param entries by kind, in the order of the robots and sorted by name
 * @param index by key
 */
public record Catalog(List<Answered> robots, Map<Kind, List<Entry>> entries, Map<Key, Entry> index) {
  /** The kinds that the view lists, in order. */
  public static final List<Kind> KINDS = List.of(Kind.TOPIC, Kind.NODE, Kind.SERVICE, Kind.ACTION);

  /** Nobody was asked. */
  public static final Catalog NOTHING = Catalog.of(List.of(), Map.of());

  /**
   * A robot that was asked.
   *
   * @param robot the component that offers to be browsed
   * @param known whether it has ever answered
   * @param failure why it did not answer now, where it did not
   */
  public record Answered(String robot, boolean known, Optional<String> failure) {}

  static Catalog of(List<Answered> robots, Map<Kind, List<Entry>> entries) {
    Map<Kind, List<Entry>> all = new EnumMap<>(Kind.class);
    Map<Key, Entry> index = new HashMap<>();
    KINDS.forEach(kind -> all.put(kind, List.copyOf(entries.getOrDefault(kind, List.of()))));
    all.values().forEach(list -> list.forEach(entry -> index.put(entry.key(), entry)));
    return new Catalog(List.copyOf(robots), Map.copyOf(all), Map.copyOf(index));
  }

  /** The robots that have answered. */
  Set<String> known() {
    return robots.stream().filter(Answered::known).map(Answered::robot).collect(Collectors.toSet());
  }

  /** Why robots do not answer now. */
  Map<String, String> failures() {
    Map<String, String> failures = new HashMap<>();
    robots.forEach(a -> a.failure().ifPresent(why -> failures.put(a.robot(), why)));
    return failures;
  }

  /** The things of a kind. */
  public List<Entry> of(Kind kind) {
    return entries.getOrDefault(kind, List.of());
  }

  /** A thing, where it is there. */
  public Optional<Entry> find(Key key) {
    return Optional.ofNullable(index.get(key));
  }

  /** Whether it says the same, so that nothing has to be shown anew. */
  boolean same(Catalog other) {
    return robots.equals(other.robots) && entries.equals(other.entries);
  }
}
