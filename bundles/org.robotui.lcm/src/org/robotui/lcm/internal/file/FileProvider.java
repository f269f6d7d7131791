package org.robotui.lcm.internal.file;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.OptionalLong;
import java.util.Set;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmUrl;
import org.robotui.lcm.internal.client.Inlet;
import org.robotui.lcm.internal.client.Link;
import org.robotui.lcm.internal.client.Provider;
import org.robotui.lcm.log.EventLogReader;
import org.robotui.lcm.log.EventLogWriter;

/** An event log, as a URL describes it. */
public final class FileProvider implements Provider {

  /** What a URL may say. */
  public static final Set<String> OPTIONS = Set.of("mode", "speed", "start_timestamp");

  private static final Set<String> MODES = Set.of("r", "w", "a");

  private final Path path;
  private final String mode;
  private final double speed;
  private final OptionalLong start;
  private final LcmOptions options;
  private final Inlet inlet;

  private FileProvider(LcmUrl url, LcmOptions options, Inlet inlet) {
    this.path = path(url);
    this.mode = url.options().getOrDefault("mode", "r");
    if (!MODES.contains(mode)) {
      throw wrong(url, "mode=" + mode + " is none of r, w, a");
    }
    this.speed = speed(url);
    this.start = start(url);
    this.options = options;
    this.inlet = inlet;
  }

  public static FileProvider of(LcmUrl url, LcmOptions options, Inlet inlet) {
    return new FileProvider(url, options, inlet);
  }

  private static Path path(LcmUrl url) {
    if (url.network().isBlank()) {
      throw wrong(url, "no file is named");
    }
    try {
      return Path.of(url.network());
    } catch (InvalidPathException e) {
      throw wrong(url, e.getMessage());
    }
  }

  private static double speed(LcmUrl url) {
    String text = url.options().getOrDefault("speed", "1");
    if (!text.matches("\\d{1,6}(\\.\\d{1,6})?|\\.\\d{1,6}")) {
      throw wrong(url, "speed=" + text + " is no factor such as 0.5, 1 or 10; 0 is as fast as possible");
    }
    return Double.parseDouble(text);
  }

  private static OptionalLong start(LcmUrl url) {
    String text = url.options().get("start_timestamp");
    if (text == null) {
      return OptionalLong.empty();
    }
    if (!text.matches("\\d{1,18}")) {
      throw wrong(url, "start_timestamp=" + text + " is no number of microseconds since 1970");
    }
    return OptionalLong.of(Long.parseLong(text));
  }

  private static IllegalArgumentException wrong(LcmUrl url, String problem) {
    return new IllegalArgumentException(
        "'" + url + "': " + problem + "; write for example file:///tmp/drive.lcmlog?speed=2");
  }

  @Override
  public Link open() throws IOException {
    return switch (mode) {
      case "w" -> new WriteLink(path, EventLogWriter.create(path));
      case "a" -> new WriteLink(path, EventLogWriter.append(path));
      default -> new ReadLink(path, EventLogReader.open(path), speed, start, options.maxMessageBytes(), inlet);
    };
  }
}
