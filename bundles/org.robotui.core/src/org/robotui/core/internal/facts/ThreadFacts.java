package org.robotui.core.internal.facts;

import java.lang.management.LockInfo;
import java.lang.management.ManagementFactory;
import java.lang.management.MonitorInfo;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/** What every thread of this process does, and which wait for each other. */
final class ThreadFacts {
  private static final int MOST_THREADS = 2000;
  private static final int MOST_FRAMES = 150;
  private static final long NANOS = 1_000_000L;

  private ThreadFacts() {}

  static List<String> lines() {
    ThreadMXBean bean = ManagementFactory.getThreadMXBean();
    List<String> lines = new ArrayList<>();
    Set<Long> locked = deadlocked(bean);
    lines.add(bean.getThreadCount() + " threads, at most " + bean.getPeakThreadCount() + " at a time"
        + (locked.isEmpty() ? "" : "; these wait for each other for ever: " + locked));
    Arrays.stream(bean.dumpAllThreads(bean.isObjectMonitorUsageSupported(), bean.isSynchronizerUsageSupported()))
        .sorted(Comparator.comparing(ThreadInfo::getThreadName)).limit(MOST_THREADS)
        .forEach(thread -> thread(thread, bean, lines));
    return lines;
  }

  private static Set<Long> deadlocked(ThreadMXBean bean) {
    Set<Long> found = new TreeSet<>();
    Optional.ofNullable(bean.findDeadlockedThreads()).ifPresent(ids -> Arrays.stream(ids).forEach(found::add));
    return found;
  }

  private static void thread(ThreadInfo thread, ThreadMXBean bean, List<String> lines) {
    long time = bean.isThreadCpuTimeSupported() ? bean.getThreadCpuTime(thread.getThreadId()) : -1;
    lines.add("");
    lines.add("\"" + thread.getThreadName() + "\" #" + thread.getThreadId() + " " + thread.getThreadState()
        + (thread.isDaemon() ? " daemon" : "") + (time < 0 ? "" : ", " + time / NANOS + " ms of a processor")
        + lock(thread));
    StackTraceElement[] stack = thread.getStackTrace();
    for (int i = 0; i < Math.min(stack.length, MOST_FRAMES); i++) {
      lines.add("    at " + stack[i]);
      held(thread, i, lines);
    }
    for (LockInfo held : thread.getLockedSynchronizers()) {
      lines.add("    holds " + held);
    }
  }

  private static String lock(ThreadInfo thread) {
    return Optional.ofNullable(thread.getLockInfo()).map(lock -> " on " + lock
        + (thread.getLockOwnerId() < 0 ? ""
            : ", which \"" + thread.getLockOwnerName() + "\" #"
                + thread.getLockOwnerId() + " holds"))
        .orElse("");
  }

  private static void held(ThreadInfo thread, int depth, List<String> lines) {
    for (MonitorInfo monitor : thread.getLockedMonitors()) {
      if (monitor.getLockedStackDepth() == depth) {
        lines.add("    holds " + monitor);
      }
    }
  }
}
