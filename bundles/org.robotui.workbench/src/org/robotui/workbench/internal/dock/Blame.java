package org.robotui.workbench.internal.dock;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.OptionalInt;
import java.util.Set;

/** Finds out whose code took part in a failure. */
final class Blame {
  private Blame() {}

  /**
   * How near to the failure a frame lies that is in the package of a class or below: 0 for the very place. Causes lie
   * nearer than what they caused; none where no frame does.
   */
  static OptionalInt distance(Class<?> component, Throwable failure) {
    String prefix = component.getPackageName() + ".";
    OptionalInt nearest = OptionalInt.empty();
    Set<Throwable> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    for (Throwable each = failure; each != null && seen.add(each); each = each.getCause()) {
      OptionalInt here = firstFrame(prefix, each.getStackTrace());
      nearest = here.isPresent() ? here : nearest;
    }
    return nearest;
  }

  private static OptionalInt firstFrame(String prefix, StackTraceElement... frames) {
    for (int i = 0; i < frames.length; i++) {
      if (frames[i].getClassName().startsWith(prefix)) {
        return OptionalInt.of(i);
      }
    }
    return OptionalInt.empty();
  }
}
