package org.robotui.core.internal.config;

import java.util.Collection;
import java.util.Optional;

/**
 * Components that may be named, as far as they are known.
 *
 * @param ids those that are known
 * @param all false where there may be more, since a type that brings some is not installed now
 */
record Known(Collection<String> ids, boolean all) {
  static Known all(Collection<String> ids) {
    return new Known(ids, true);
  }

  boolean mayHave(String id) {
    return !all || ids.contains(id);
  }

  /** One of them, for examples. */
  Optional<String> any() {
    return ids.stream().findFirst();
  }
}
