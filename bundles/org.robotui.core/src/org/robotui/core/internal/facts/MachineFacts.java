package org.robotui.core.internal.facts;

import java.io.IOException;
import java.nio.file.FileStore;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The machine and the surroundings of the user, as far as robots and windows depend on them. */
final class MachineFacts {
  private static final Pattern VARIABLES = Pattern.compile(
      "(ROBOTUI|ROS|RMW|CYCLONEDDS|FASTRTPS|FASTDDS|IGN|GZ|PLAYER|LCM|GDK|GTK|SWT|XDG)_.*"
          + "|LANG|LC_.*|DISPLAY|WAYLAND_DISPLAY|JAVA_HOME|HOME|TMPDIR|SSH_CONNECTION|container");
  private static final List<Path> FILES = List.of(Path.of("/etc/os-release"), Path.of("/proc/version"),
      Path.of("/proc/meminfo"), Path.of("/proc/loadavg"), Path.of("/proc/cpuinfo"), Path.of("/proc/self/limits"),
      Path.of("/proc/self/cgroup"));
  private static final int MOST_LINES = 32;
  private static final int GIGA = 30;

  private MachineFacts() {}

  static String text(Path state) {
    List<String> lines = new ArrayList<>();
    lines.add(System.getProperty("os.name") + " " + System.getProperty("os.version") + " on "
        + System.getProperty("os.arch"));
    lines.add(space(state));
    FILES.forEach(file -> beginning(file, lines));
    lines.add("");
    lines.add("== Environment ==");
    Map<String, String> variables = new TreeMap<>(System.getenv());
    variables.forEach((name, value) -> {
      if (VARIABLES.matcher(name).matches()) {
        lines.add(name + "=" + value);
      }
    });
    return String.join("\n", lines);
  }

  private static String space(Path state) {
    try {
      Path there = Files.exists(state) ? state : state.toAbsolutePath().getRoot();
      FileStore store = Files.getFileStore(there);
      return there + " lies on " + store.type() + ", with " + (store.getUsableSpace() >> GIGA) + " GB free of "
          + (store.getTotalSpace() >> GIGA);
    } catch (IOException e) {
      return state + ": " + e;
    }
  }

  private static void beginning(Path file, List<String> lines) {
    if (!Files.isReadable(file)) {
      return;
    }
    lines.add("");
    lines.add("== " + file + " ==");
    try (Stream<String> content = Files.lines(file)) {
      content.limit(MOST_LINES).forEach(lines::add);
    } catch (IOException e) {
      lines.add(e.toString());
    }
  }
}
