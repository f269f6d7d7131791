package org.robotui.core.internal.watch;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Who holds a thread up.
 *
 * @param bundle symbolic name
 * @param frame the topmost line of the stack that is in it
 */
record Blame(String bundle, String frame) {
  /** Those that call views, or are called by all of them, are not to blame while a view is on the stack. */
  private static final List<String> CALLERS =
      List.of("org.robotui.core", "org.robotui.workbench", "org.robotui.ui", "org.robotui.gl", "org.robotui.api",
          "org.robotui.data", "org.robotui.geometry", "org.eclipse.", "org.apache.", "java.");

  /**
   * The first bundle from the top that is no common caller; else the first of ours. Asks for no more names than it
   * needs.
   */
  static Optional<Blame> of(StackTraceElement[] stack, BundleNames names) {
    return all(stack, names).filter(Blame::canBeLeftOut).findFirst()
        .or(() -> all(stack, names).filter(b -> b.bundle().startsWith("org.robotui.")).findFirst());
  }

  private static Stream<Blame> all(StackTraceElement[] stack, BundleNames names) {
    return Arrays.stream(stack)
        .flatMap(f -> names.bundleOf(f.getClassName()).map(b -> new Blame(b, f.toString())).stream());
  }

  /** Whether RobotUI can run without the bundle: one that calls all views is needed, whatever it did. */
  boolean canBeLeftOut() {
    return CALLERS.stream().noneMatch(caller -> isOf(bundle, caller));
  }

  private static boolean isOf(String bundle, String caller) {
    return caller.endsWith(".") ? bundle.startsWith(caller) : bundle.equals(caller);
  }
}
