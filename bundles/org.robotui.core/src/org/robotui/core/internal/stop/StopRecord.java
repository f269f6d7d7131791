package org.robotui.core.internal.stop;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.time.format.DateTimeParseException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Supplier;
import org.robotui.api.config.AtomicFile;
import org.robotui.net.process.RunningProcess;
import org.robotui.net.socket.UserSocket;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What a process would leave behind if it ended now: stops that are latched, and a display that hangs. It stands in a
 * file as long as that is so, for the next start to tell. Any thread may call; files are written on the executor, never
 * by the caller.
 */
public final class StopRecord {
  private static final Logger LOG = LoggerFactory.getLogger(StopRecord.class);
  private static final String DISPLAY = "";
  private static final String PREFIX = "left-";
  private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss", Locale.ROOT);

  private final Path folder;
  private final Path file;
  private final Executor files;
  private final Supplier<Instant> wall;
  private final Map<String, String> lines = new LinkedHashMap<>();

  /**
   * A record without lines.
   *
   * @param folder of the records of all processes of this user; need not exist
   * @param files does what takes time
   * @param wall the time of this machine
   */
  public StopRecord(Path folder, Executor files, Supplier<Instant> wall) {
    this.folder = folder;
    this.file = folder.resolve(PREFIX + ProcessHandle.current().pid() + ".txt");
    this.files = files;
    this.wall = wall;
  }

  /** A stop was latched. */
  public void stopped(String robot, String by) {
    put(robot, robot + " was stopped by " + by);
  }

  /** A stop was released. */
  public void released(String robot) {
    remove(robot);
  }

  /** The display hangs; a sentence that tells more. */
  public void hangs(String message) {
    put(DISPLAY, message);
  }

  /** The display answers. */
  public void answers() {
    remove(DISPLAY);
  }

  private synchronized void put(String key, String line) {
    lines.put(key, TIME.format(LocalDateTime.ofInstant(wall.get(), ZoneId.systemDefault())) + "  " + line);
    save();
  }

  private synchronized void remove(String key) {
    if (lines.remove(key) != null) {
      save();
    }
  }

  private void save() {
    List<String> now = List.copyOf(lines.values());
    try {
      files.execute(() -> write(now));
    } catch (RejectedExecutionException e) {
      LOG.debug("{} is not written any more: the process ends", file);
    }
  }

  private void write(List<String> now) {
    try {
      if (now.isEmpty()) {
        Files.deleteIfExists(file);
      } else {
        UserSocket.privateFolder(file.getParent());
        AtomicFile.writePrivate(file, RunningProcess.current().started() + "\n" + String.join("\n", now) + "\n");
      }
    } catch (IOException | UnsupportedOperationException e) {
      LOG.warn("{} cannot be written: the next start will not know of {}", file, now, e);
    }
  }

  /** What processes that are no more have left, a sentence each; it is told once. Reads files. */
  public List<String> takeLeft() {
    List<String> all = new ArrayList<>();
    if (Files.isDirectory(folder)) {
      try (DirectoryStream<Path> left = Files.newDirectoryStream(folder, PREFIX + "*.txt")) {
        left.forEach(f -> take(f).ifPresent(all::add));
      } catch (IOException e) {
        LOG.warn("{} cannot be read: what the last start left is not known", folder, e);
      }
    }
    return List.copyOf(all);
  }

  private Optional<String> take(Path left) {
    try {
      List<String> all = Files.readAllLines(left);
      String pid = left.getFileName().toString().replace(PREFIX, "").replace(".txt", "");
      if (all.size() < 2 || runs(pid, all.getFirst())) {
        return Optional.empty();
      }
      Files.delete(left);
      return Optional.of("an earlier RobotUI (process " + pid + ") has ended, and its stops with it. Before that: "
          + String.join("; ", all.subList(1, all.size())));
    } catch (IOException e) {
      LOG.warn("{} cannot be read", left, e);
      return Optional.empty();
    }
  }

  /** A time that cannot be read is that of no process. */
  private static boolean runs(String pid, String started) {
    try {
      return new RunningProcess(Long.parseLong(pid), Instant.parse(started)).runs();
    } catch (NumberFormatException | DateTimeParseException e) {
      return false;
    }
  }
}
