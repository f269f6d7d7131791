package org.robotui.core.internal.life;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.robotui.core.internal.watch.BundleNames;

/**
 * Finds threads that components started by themselves instead of taking them from their factory. A thread inherits the
 * group of the one that starts it; one that was started on the display thread is known by the code it runs. Looks at
 * all threads of the machine, which all wait for: only for the end of components, and once for all that end together.
 */
final class Strays {
  /** Threads that everybody shares, whoever happened to need them first. */
  private static final List<String> SHARED =
      List.of("ForkJoinPool.commonPool", "CompletableFutureDelayScheduler", "Common-Cleaner", "Attach Listener");
  private static final List<String> PLATFORM =
      List.of("com.sun.", "sun.", "jdk.", "javax.", "java.lang.", "org.eclipse.", "org.apache.", "ch.qos.");

  private Strays() {}

  /** Those of a group, without those that code of the platform runs. */
  static Stream<Thread> in(ThreadGroup group) {
    Thread[] threads = new Thread[group.activeCount() + 16]; // one too many is no harm, one too few would be left out
    int count = group.enumerate(threads);
    return Arrays.stream(threads, 0, count).filter(t -> !isPlatform(t, t.getStackTrace()));
  }

  private static boolean isPlatform(Thread thread, StackTraceElement[] stack) {
    return SHARED.stream().anyMatch(thread.getName()::startsWith)
        || entry(stack).filter(c -> PLATFORM.stream().anyMatch(c::startsWith)).isPresent();
  }

  /** The names of those that run the code of some bundles and are in no group of a component, by their bundle. */
  static Map<String, List<String>> of(Set<String> bundles, BundleNames names) {
    Map<String, List<String>> found = new HashMap<>();
    if (!bundles.isEmpty()) {
      Thread.getAllStackTraces().entrySet().stream() // all stacks at once: one by one each would halt its thread twice
          .filter(e -> isOutside(e.getKey()) && !isPlatform(e.getKey(), e.getValue()))
          .forEach(e -> own(e.getValue()).flatMap(names::bundleOf).filter(bundles::contains)
              .ifPresent(bundle -> found.computeIfAbsent(bundle, b -> new ArrayList<>()).add(e.getKey().getName())));
    }
    found.values().forEach(Collections::sort);
    return found;
  }

  /** In no group of a component; one that has ended meanwhile is in no group at all, whoever it was of. */
  private static boolean isOutside(Thread thread) {
    ThreadGroup group = thread.getThreadGroup();
    return group != null && !(group instanceof ComponentGroup);
  }

  /** The class whose method the thread was started with. */
  private static Optional<String> entry(StackTraceElement[] stack) {
    return fromBelow(stack).findFirst();
  }

  /** The first class that is not of the Java library. */
  private static Optional<String> own(StackTraceElement[] stack) {
    return fromBelow(stack).filter(c -> !c.startsWith("java.")).findFirst();
  }

  private static Stream<String> fromBelow(StackTraceElement[] stack) {
    return Arrays.asList(stack).reversed().stream().map(StackTraceElement::getClassName)
        .filter(c -> !c.equals("java.lang.Thread"));
  }
}
