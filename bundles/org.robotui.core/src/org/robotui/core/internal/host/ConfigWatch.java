package org.robotui.core.internal.host;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Looks again and again whether files have changed. Asking is used, not being notified: that also works on network
 * drives, and for editors that put a new file in the place of the old one. A change is told when the file was the same
 * on two looks, so that it is not read while it is being written.
 */
final class ConfigWatch {
  /** Two looks, and the time to read, are less than two seconds. */
  private static final long PERIOD_MILLIS = 600;
  private static final Logger LOG = LoggerFactory.getLogger(ConfigWatch.class);
  private static final Mark ABSENT = new Mark(FileTime.fromMillis(0), -1, "");

  /** What a file looks like from outside. */
  private record Mark(FileTime time, long size, String key) {}

  /** What was told of last, and what was seen last. */
  private record Seen(Mark told, Mark last) {}

  private final Map<Path, Seen> files = new ConcurrentHashMap<>();
  private final ScheduledExecutorService worker;
  private final Consumer<Path> changed;
  private boolean begun;

  /**
   * Watches nothing yet.
   *
   * @param worker looks, and runs what is told
   * @param changed is told of changes
   */
  ConfigWatch(ScheduledExecutorService worker, Consumer<Path> changed) {
    this.worker = worker;
    this.changed = changed;
  }

  /** How a file looks is taken before it is read: what is written while it is read counts as a change. */
  synchronized void add(Path file) {
    Mark now = mark(file);
    files.put(file, new Seen(now, now));
    if (!begun) {
      begun = true;
      worker.scheduleWithFixedDelay(this::look, PERIOD_MILLIS, PERIOD_MILLIS, TimeUnit.MILLISECONDS);
    }
  }

  /** The files that are watched. */
  List<Path> files() {
    return files.keySet().stream().sorted().toList();
  }

  private void look() {
    files.keySet().forEach(this::look);
  }

  private void look(Path file) {
    Mark now = mark(file);
    Seen seen = files.get(file);
    boolean calm = now.equals(seen.last());
    boolean news = calm && !now.equals(seen.told());
    files.put(file, new Seen(news ? now : seen.told(), now));
    if (news) {
      tell(file);
    }
  }

  private void tell(Path file) {
    try {
      changed.accept(file);
    } catch (RuntimeException e) { // else nothing would be looked at any more
      LOG.error("The change of {} could not be taken up", file, e);
    }
  }

  private static Mark mark(Path file) {
    try {
      BasicFileAttributes a = Files.readAttributes(file, BasicFileAttributes.class);
      return new Mark(a.lastModifiedTime(), a.size(), String.valueOf(a.fileKey()));
    } catch (NoSuchFileException e) {
      return ABSENT;
    } catch (IOException e) {
      LOG.debug("{} cannot be looked at", file, e);
      return ABSENT;
    }
  }
}
