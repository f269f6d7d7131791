package org.robotui.net.process;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;

/**
 * A process that runs, or ran, on this machine, so that it is not mistaken for a later one of the same number.
 *
 * @param pid its number
 * @param started when it began; the epoch if the system does not tell
 */
public record RunningProcess(long pid, Instant started) {

  /** Systems derive the start from a clock that is corrected meanwhile. */
  private static final Duration TOLERANCE = Duration.ofSeconds(10);

  /**
   * The process that asks.
   *
   * @return this one
   */
  public static RunningProcess current() {
    ProcessHandle self = ProcessHandle.current();
    return new RunningProcess(self.pid(), started(self));
  }

  private static Instant started(ProcessHandle process) {
    return process.info().startInstant().orElse(Instant.EPOCH);
  }

  /**
   * Whether it runs. One that was killed stays in the table of the system until its parent asks for its end, which may
   * take any time; {@link ProcessHandle#isAlive} counts it as alive, this method does not.
   *
   * @return false as soon as it has ended
   */
  public boolean runs() {
    return ProcessHandle.of(pid).filter(ProcessHandle::isAlive)
        .map(process -> Duration.between(started(process), started).abs().compareTo(TOLERANCE) < 0).orElse(false)
        && !hasEnded(pid);
  }

  /** Only Linux tells; its line holds the name of the program, which may contain anything, before the state. */
  private static boolean hasEnded(long pid) {
    try {
      String line = Files.readString(Path.of("/proc", Long.toString(pid), "stat"), StandardCharsets.ISO_8859_1);
      String state = line.substring(line.lastIndexOf(')') + 1).strip();
      return state.startsWith("Z") || state.startsWith("X");
    } catch (IOException e) {
      return false;
    }
  }
}
