package org.robotui.testkit.rfic;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * What this process holds: threads, but for those of robots and of Java itself, and open sockets, pipes and selectors.
 *
 * @param threads those that run
 * @param handles as the kernel names them; empty where it does not tell
 */
record Resources(Set<Thread> threads, Set<String> handles) {
  private static final ThreadGroup ROBOTS =
      Optional.ofNullable(Peer.THREADS.newThread(() -> {}).getThreadGroup()).orElseThrow();
  private static final Path OPEN = Path.of("/proc/self/fd");
  private static final List<String> KINDS = List.of("socket:", "pipe:", "anon_inode:[event");
  /** One for all, that come when first used and stay. */
  private static final List<String> SHARED =
      List.of("ForkJoinPool", "CompletableFutureDelayScheduler", "process reaper", "Cleaner", "Common-Cleaner",
          "Attach Listener", "surefire", "junit");

  static Resources now() throws IOException {
    Set<Thread> threads = new HashSet<>(Thread.getAllStackTraces().keySet());
    threads.removeIf(thread -> !thread.isAlive() || thread.getThreadGroup() == ROBOTS
        || SHARED.stream().anyMatch(thread.getName()::startsWith));
    return new Resources(threads, handlesNow());
  }

  private static Set<String> handlesNow() throws IOException {
    Set<String> handles = new TreeSet<>();
    if (!Files.isDirectory(OPEN)) {
      return handles;
    }
    try (DirectoryStream<Path> all = Files.newDirectoryStream(OPEN)) {
      for (Path each : all) {
        String target = target(each);
        if (KINDS.stream().anyMatch(target::startsWith)) {
          handles.add(target.startsWith("anon") ? each.getFileName() + " " + target : target);
        }
      }
    } catch (DirectoryIteratorException e) {
      throw e.getCause();
    }
    return handles;
  }

  /** A handle may be closed while we look. */
  private static String target(Path handle) {
    try {
      return Files.readSymbolicLink(handle).toString();
    } catch (IOException e) {
      return "";
    }
  }

  /** What is here and was not there. */
  Resources beyond(Resources before) {
    Set<Thread> threadsMore = new HashSet<>(threads);
    threadsMore.removeAll(before.threads);
    Set<String> handlesMore = new TreeSet<>(handles);
    handlesMore.removeAll(before.handles);
    return new Resources(threadsMore, handlesMore);
  }

  boolean isEmpty() {
    return threads.isEmpty() && handles.isEmpty();
  }
}
