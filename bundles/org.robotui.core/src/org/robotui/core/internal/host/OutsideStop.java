package org.robotui.core.internal.host;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.robotui.api.command.Principal;
import org.robotui.core.internal.command.StopListener;
import org.robotui.core.internal.stop.StopRecord;
import org.robotui.core.internal.stop.StopSocket;
import org.robotui.core.internal.time.WallClock;

/**
 * A stop that comes from outside of the process, and what the next start has to know of stops. What this process knows
 * of itself is asked for in the same way.
 */
final class OutsideStop implements StopListener, AutoCloseable {
  private static final Principal BY = new Principal("robotui-stop", "./robotui stop", Principal.Kind.SCRIPT);

  private final Path folder;
  private final Executor files;
  private final StopRecord record;
  private Optional<StopSocket> socket = Optional.empty();
  private boolean begun;

  OutsideStop(Path folder, Executor files, WallClock wall) {
    this.folder = folder;
    this.files = files;
    this.record = new StopRecord(folder, files, () -> Instant.ofEpochSecond(0, wall.nanos()));
  }

  /** Once there are robots to stop; whoever only checks a configuration leaves no trace. */
  synchronized void begin(Function<Principal, List<String>> stopAll, Supplier<List<String>> facts,
      Consumer<String> tell) {
    if (!begun) {
      begun = true;
      socket = Optional.of(new StopSocket(folder, Map.of("stop", () -> told(stopAll.apply(BY)), "facts", facts)));
      files.execute(() -> record.takeLeft().forEach(tell));
    }
  }

  private static List<String> told(List<String> stopped) {
    return stopped.isEmpty() ? List.of("it has no robot") : stopped;
  }

  /** What the watchdog says of the display, and whether it hangs at this moment. */
  void display(String message, boolean hangs) {
    if (hangs) {
      record.hangs(message);
    } else {
      record.answers();
    }
  }

  @Override
  public void stopped(String robot, Principal by) {
    record.stopped(robot, by.label());
  }

  @Override
  public void released(String robot) {
    record.released(robot);
  }

  @Override
  public synchronized void close() {
    begun = true;
    socket.ifPresent(StopSocket::close);
  }
}
