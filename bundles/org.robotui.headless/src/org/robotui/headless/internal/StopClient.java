package org.robotui.headless.internal;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.robotui.net.process.SocketAnswer;

/**
 * Tells all workbenches of this user to stop their robots, all at the same time, and says what came of it. Knows the
 * rest by its socket alone.
 */
final class StopClient {
  /** How it ended: the numbers that scripts may rely on. */
  enum Result {
    /** All have stopped their robots. */
    STOPPED(0),
    /** One that runs has not answered. */
    UNANSWERED(1),
    /** None runs. */
    NONE(4);

    private final int code;

    Result(int code) {
      this.code = code;
    }

    int code() {
      return code;
    }
  }

  private static final Duration LIMIT = Duration.ofSeconds(2);
  private static final String DONE = "done";

  private final Path folder;
  private final PrintStream out;

  /** Looks for sockets under the state folder. */
  StopClient(Path state, PrintStream out) {
    this.folder = state.resolve("run");
    this.out = out;
  }

  Result stop() {
    List<SocketAnswer> answers = ask();
    answers.forEach(this::tell);
    if (answers.isEmpty()) {
      out.println("No RobotUI of this user runs (none listens in " + folder + ").");
      return Result.NONE;
    }
    return answers.stream().allMatch(StopClient::isDone) ? Result.STOPPED : Result.UNANSWERED;
  }

  private List<SocketAnswer> ask() {
    try {
      return SocketAnswer.ask(folder, "stop-*.sock", "stop", LIMIT);
    } catch (IOException e) {
      out.println(folder + " cannot be read: " + e.getMessage());
      return List.of();
    }
  }

  private static boolean isDone(SocketAnswer answer) {
    return answer.text().endsWith(DONE + "\n");
  }

  private void tell(SocketAnswer answer) {
    String name = "RobotUI (process " + answer.process() + ")";
    if (isDone(answer)) {
      answer.text().lines().filter(l -> !l.equals(DONE)).forEach(l -> out.println(name + ": " + l));
    } else {
      out.println(name
          + " does not answer: it hangs as a whole, and whether its robots stand is not known. Stop them by their own means;\n"
          + "  a robot that has a time-out on commands stands by now. This ends the process:  kill -KILL "
          + answer.process());
    }
  }
}
