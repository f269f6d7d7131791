package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.headless.internal.StopClient.Result;

class StopClientTest {
  @TempDir
  private Path state;
  private Path run;
  private final List<ServerSocketChannel> servers = new ArrayList<>();
  private final ByteArrayOutputStream said = new ByteArrayOutputStream();

  @BeforeEach
  void folder() throws IOException {
    run = Files.createDirectories(state.resolve("run"));
  }

  @AfterEach
  void close() throws IOException {
    for (ServerSocketChannel server : servers) {
      server.close();
    }
  }

  private ServerSocketChannel listen(int process) throws IOException {
    ServerSocketChannel server = ServerSocketChannel.open(StandardProtocolFamily.UNIX);
    server.bind(UnixDomainSocketAddress.of(run.resolve("stop-" + process + ".sock")));
    servers.add(server);
    return server;
  }

  private void answering(int process, String answer) throws IOException {
    ServerSocketChannel server = listen(process);
    Thread.ofPlatform().daemon().start(() -> {
      try (SocketChannel client = server.accept()) {
        ByteBuffer word = ByteBuffer.allocate(5);
        while (word.hasRemaining() && client.read(word) >= 0) {
          Thread.onSpinWait();
        }
        if (new String(word.array(), StandardCharsets.UTF_8).equals("stop\n")) {
          client.write(ByteBuffer.wrap(answer.getBytes(StandardCharsets.UTF_8)));
        }
      } catch (IOException e) {
        throw new AssertionError(e);
      }
    });
  }

  private Result stop() {
    return new StopClient(state, new PrintStream(said, true, StandardCharsets.UTF_8)).stop();
  }

  private String said() {
    return said.toString(StandardCharsets.UTF_8);
  }

  @Test
  void allThatRunAreStopped() throws IOException {
    answering(17, "Keira is stopped\nRobby is stopped\ndone\n");
    answering(18, "Natalie is stopped\ndone\n");
    assertEquals(Result.STOPPED, stop());
    assertEquals(List.of("RobotUI (process 17): Keira is stopped", "RobotUI (process 17): Robby is stopped",
        "RobotUI (process 18): Natalie is stopped"), said().lines().sorted().toList());
  }

  @Test
  void oneThatHangsIsNamedAndHoldsTheOthersNotUp() throws IOException {
    listen(17); // the kernel takes the connection, nobody answers
    answering(18, "Natalie is stopped\ndone\n");
    assertEquals(Result.UNANSWERED, stop());
    assertTrue(said().contains("process 17) does not answer") && said().contains("kill -KILL 17"), said());
    assertTrue(said().contains("Natalie is stopped"), said());
  }

  @Test
  void anAnswerThatBreaksOffIsNone() throws IOException {
    answering(17, "Keira is sto");
    assertEquals(Result.UNANSWERED, stop());
  }

  @Test
  void whatAKilledProcessLeftIsForgotten() throws IOException {
    listen(17).close();
    assertEquals(Result.NONE, stop());
    assertFalse(Files.exists(run.resolve("stop-17.sock")));
    assertTrue(said().contains("No RobotUI of this user runs"), said());
  }

  @Test
  void withoutAFolderNoneRuns() throws IOException {
    Files.delete(run);
    assertEquals(Result.NONE, stop());
  }
}
