package org.robotui.headless.internal;

import java.io.IOException;
import java.io.PrintStream;
import java.net.ConnectException;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

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

  private record Answer(String process, boolean runs, String text) {
    boolean isDone() {
      return text.endsWith("done\n");
    }
  }

  private static final long LIMIT_SECONDS = 2;

  private final Path folder;
  private final PrintStream out;

  /** Looks for sockets under the state folder. */
  StopClient(Path state, PrintStream out) {
    this.folder = state.resolve("run");
    this.out = out;
  }

  Result stop() {
    List<CompletableFuture<Answer>> asked = sockets().stream().map(StopClient::ask).toList();
    List<Answer> answers = asked.stream().map(CompletableFuture::join).filter(Answer::runs).toList();
    answers.forEach(this::tell);
    if (answers.isEmpty()) {
      out.println("No RobotUI of this user runs (none listens in " + folder + ").");
      return Result.NONE;
    }
    return answers.stream().allMatch(Answer::isDone) ? Result.STOPPED : Result.UNANSWERED;
  }

  private List<Path> sockets() {
    List<Path> all = new ArrayList<>();
    if (Files.isDirectory(folder)) {
      try (DirectoryStream<Path> found = Files.newDirectoryStream(folder, "stop-*.sock")) {
        found.forEach(all::add);
      } catch (IOException e) {
        out.println(folder + " cannot be read: " + e.getMessage());
      }
    }
    return all;
  }

  /** One that hangs as a whole takes the connection, since the kernel does, but never answers. */
  private static CompletableFuture<Answer> ask(Path socket) {
    String process = socket.getFileName().toString().replaceAll("\\D", "");
    CompletableFuture<Answer> answer = new CompletableFuture<>();
    Thread.ofPlatform().daemon().start(() -> answer.complete(talk(socket, process)));
    return answer.completeOnTimeout(new Answer(process, true, ""), LIMIT_SECONDS, TimeUnit.SECONDS);
  }

  private static Answer talk(Path socket, String process) {
    try (SocketChannel channel = SocketChannel.open(UnixDomainSocketAddress.of(socket))) {
      Channels.newOutputStream(channel).write("stop\n".getBytes(StandardCharsets.UTF_8));
      return new Answer(process, true,
          new String(Channels.newInputStream(channel).readAllBytes(), StandardCharsets.UTF_8));
    } catch (ConnectException e) {
      forget(socket);
      return new Answer(process, false, "");
    } catch (IOException e) {
      return new Answer(process, true, "");
    }
  }

  /** Its process was killed. */
  private static void forget(Path socket) {
    try {
      Files.deleteIfExists(socket);
    } catch (IOException e) {
      socket.toFile().deleteOnExit();
    }
  }

  private void tell(Answer answer) {
    String name = "RobotUI (process " + answer.process() + ")";
    if (answer.isDone()) {
      answer.text().lines().filter(l -> !l.equals("done")).forEach(l -> out.println(name + ": " + l));
    } else {
      out.println(name
          + " does not answer: it hangs as a whole, and whether its robots stand is not known. Stop them by their own means;\n"
          + "  a robot that has a time-out on commands stands by now. This ends the process:  kill -KILL "
          + answer.process());
    }
  }
}
