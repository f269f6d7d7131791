package org.robotui.core.internal.compose;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.SettingsGroup;

/**
 * Changes a value with all that is within it, item by item, so that what is the same stays as it is written. Which
 * items were renamed, moved or changed is found by comparing.
 *
 * @param path where the value stands
 */
record ValueEdit(List<String> path) {
  /** The text with another value; {@code before} is what it says. */
  String set(String text, Object before, Object after, ValueType type) throws PathEdit.Refusal {
    if (SettingsGroup.isSame(before, after)) {
      return text;
    }
    if (before instanceof Map<?, ?> old && after instanceof Map<?, ?> now && !old.isEmpty() && !now.isEmpty()) {
      return section(text, old, now, type);
    }
    if (before instanceof List<?> old && after instanceof List<?> now && !old.isEmpty() && !now.isEmpty()) {
      return list(text, old, now, type);
    }
    return PathEdit.set(text, path, after, type);
  }

  private String section(String text, Map<?, ?> old, Map<?, ?> now, ValueType type) throws PathEdit.Refusal {
    String changed = text;
    List<String> names = new ArrayList<>(old.keySet().stream().map(Object::toString).toList());
    List<String> wanted = now.keySet().stream().map(Object::toString).toList();
    for (String name : wanted) {
      Optional<String> former = former(old, now, name).filter(names::contains);
      if (former.isPresent()) {
        changed = ItemEdit.renamed(changed, path, former.get(), name);
        names.set(names.indexOf(former.get()), name);
        changed = within(name).set(changed, old.get(former.get()), now.get(name), YamlWords.member(type, name, now));
      } else if (names.contains(name)) {
        changed = within(name).set(changed, old.get(name), now.get(name), YamlWords.member(type, name, now));
      } else {
        changed = PathEdit.set(changed, within(name).path, now.get(name), YamlWords.member(type, name, now));
        names.add(name);
      }
    }
    for (String name : List.copyOf(names)) {
      if (!wanted.contains(name)) {
        changed = PathEdit.remove(changed, within(name).path);
        names.remove(name);
      }
    }
    return names.equals(wanted) ? changed
        : ItemEdit.arranged(changed, path, wanted.stream().map(names::indexOf).toList());
  }

  /** The name that was changed to a new one: that of the same value, else that in the same place. */
  private static Optional<String> former(Map<?, ?> old, Map<?, ?> now, String name) {
    if (old.containsKey(name)) {
      return Optional.empty();
    }
    List<?> before = List.copyOf(old.keySet());
    int place = List.copyOf(now.keySet()).indexOf(name);
    Stream<?> same = before.stream().filter(n -> SettingsGroup.isSame(old.get(n), now.get(name)));
    Stream<?> there = old.size() == now.size() ? Stream.of(before.get(place)) : Stream.empty();
    return Stream.concat(same, there).filter(n -> !now.containsKey(n)).map(Object::toString).findFirst();
  }

  private String list(String text, List<?> old, List<?> now, ValueType type) throws PathEdit.Refusal {
    ValueType element = YamlWords.element(type);
    List<Integer> places = new ArrayList<>(places(old, now));
    String changed = text;
    int size = old.size();
    for (int i = 0; i < now.size(); i++) {
      if (places.get(i) < 0) {
        changed = ItemEdit.appended(changed, path, YamlWords.value(now.get(i), element));
        places.set(i, size++);
      }
    }
    for (int gone = old.size() - 1; gone >= 0; gone--) {
      if (!places.contains(gone)) {
        changed = PathEdit.remove(changed, within(Integer.toString(gone)).path);
        int place = gone;
        places.replaceAll(p -> p > place ? p - 1 : p);
      }
    }
    if (!places.equals(IntStream.range(0, places.size()).boxed().toList())) {
      changed = ItemEdit.arranged(changed, path, places);
    }
    List<Integer> kept = places(old, now);
    for (int i = 0; i < now.size(); i++) {
      if (kept.get(i) >= 0) {
        changed = within(Integer.toString(i)).set(changed, old.get(kept.get(i)), now.get(i), element);
      }
    }
    return changed;
  }

  /** Which former item each is: the same one, else one that was changed; -1 for a new one. */
  private static List<Integer> places(List<?> old, List<?> now) {
    List<Integer> places = new ArrayList<>(Collections.nCopies(now.size(), -1));
    Set<Integer> free = new HashSet<>(IntStream.range(0, old.size()).boxed().toList());
    for (boolean same : List.of(true, false)) {
      for (int i = 0; i < now.size(); i++) {
        int at = i;
        if (places.get(i) < 0) {
          Stream.concat(Stream.of(i), free.stream().sorted()).filter(free::contains)
              .filter(p -> !same || SettingsGroup.isSame(old.get(p), now.get(at))).findFirst().ifPresent(p -> {
                free.remove(p);
                places.set(at, p);
              });
        }
      }
    }
    return places;
  }

  private ValueEdit within(String name) {
    return new ValueEdit(Stream.concat(path.stream(), Stream.of(name)).toList());
  }
}
