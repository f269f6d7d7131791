package org.robotui.workbench.internal.pane;

import java.util.Arrays;
import java.util.Set;
import java.util.Collections;
import java.util.IdentityHashMap;

/** Finds out whose code took part in a failure. */
final class Blame {
  private Blame() {}

  /** Whether a frame of a failure, or of one of its causes, lies in the package of a class or below. */
  static boolean took(Class<?> component, Throwable failure) {
    String prefix = component.getPackageName() + ".";
    Set<Throwable> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    for (Throwable each = failure; each != null && seen.add(each); each = each.getCause()) {
      if (Arrays.stream(each.getStackTrace()).anyMatch(frame -> frame.getClassName().startsWith(prefix))) {
        return true;
      }
    }
    return false;
  }
}
