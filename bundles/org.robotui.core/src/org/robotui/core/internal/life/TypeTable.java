package org.robotui.core.internal.life;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.ComponentType;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The types of one kind. Where two bundles bring the same id, the first is used; the second steps in when it goes. */
final class TypeTable<T extends ComponentType> {
  private static final Logger LOG = LoggerFactory.getLogger(TypeTable.class);

  private record Entry<T>(T type, String id, String bundle) {}

  /**
   * A type that may have gone. Compared by identity: what types say of their equality is foreign code, and may change.
   */
  private record Known(WeakReference<ComponentType> type, String bundle) {}

  private final List<Entry<T>> entries = new ArrayList<>();
  private final Map<String, String> bundles = new HashMap<>();
  private final List<Known> known = new ArrayList<>();

  synchronized void add(T type, String bundle) {
    String id = type.id();
    entries.stream().filter(e -> e.id().equals(id)).findFirst().ifPresent(first -> LOG
        .warn("The type '{}' of bundle {} is not used: bundle {} has brought it already", id, bundle, first.bundle()));
    entries.add(new Entry<>(type, id, bundle));
    bundles.put(id, bundle);
    known.removeIf(k -> k.type().refersTo(null));
    known.add(new Known(new WeakReference<>(type), bundle));
  }

  synchronized void remove(ComponentType type) {
    entries.removeIf(e -> e.type() == type);
  }

  synchronized Optional<T> find(String id) {
    return entries.stream().filter(e -> e.id().equals(id)).map(Entry::type).findFirst();
  }

  /** The bundle of a type, also of one that has just been taken away. */
  synchronized Optional<String> bundle(ComponentType type) {
    return known.stream().filter(k -> k.type().refersTo(type)).map(Known::bundle).findFirst();
  }

  /** The bundle that brought a type which may be gone by now. */
  synchronized Optional<String> formerBundle(String id) {
    return Optional.ofNullable(bundles.get(id));
  }

  synchronized List<String> ids() {
    return entries.stream().map(Entry::id).distinct().sorted().toList();
  }
}
