package org.robotui.script.internal.socket;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.script.Scripts.Door;
import org.robotui.script.internal.ScriptsComponent;
import org.robotui.testkit.host.FakeHost;
import org.robotui.testkit.host.FakeRuic;

@Timeout(180)
class ScriptSocketTest {
  @TempDir
  private Path folder;
  private final FakeRuic natalie = new FakeRuic("Natalie");
  private final ScriptsComponent scripts = new ScriptsComponent(new FakeHost().add(natalie));
  private Door door;

  @BeforeEach
  void open() {
    door = scripts.listen(folder.resolve("run")).orElseThrow();
  }

  @AfterEach
  void close() {
    door.close();
  }

  private static final class Client implements AutoCloseable {
    private final SocketChannel channel;
    private final BufferedReader answers;

    Client(Path file) throws IOException {
      channel = SocketChannel.open(UnixDomainSocketAddress.of(file));
      answers = new BufferedReader(new InputStreamReader(Channels.newInputStream(channel), StandardCharsets.UTF_8));
    }

    void say(String words) throws IOException {
      ByteBuffer bytes = ByteBuffer.wrap(words.getBytes(StandardCharsets.UTF_8));
      while (bytes.hasRemaining()) {
        channel.write(bytes);
      }
    }

    String ask(String words) throws IOException {
      say(words + "\n");
      return answers.readLine();
    }

    @Override
    public void close() throws IOException {
      channel.close();
    }
  }

  private Client client() throws IOException {
    return new Client(door.file());
  }

  @Test
  void runsScriptsAndTellsWhatTheyGive() throws IOException {
    try (Client client = client()) {
      assertEquals("{\"id\":7,\"value\":3.0,\"text\":\"3\"}", client.ask("{\"id\":7,\"run\":\"var a = 1; a + 2\"}"));
      assertEquals("{\"id\":8,\"value\":[1.0,null,{\"b\":\"c\"}],\"text\":\"[1, null, {b: \\\"c\\\"}]\"}",
          client.ask("{\"id\":8,\"run\":\"[a, null, {b: 'c'}]\"}"));
      assertEquals(
          "{\"id\":9,\"error\":\"ReferenceError: \\\"nothing\\\" is not defined.\",\"source\":\"cell\",\"line\":2}",
          client.ask("{\"id\":9,\"name\":\"cell\",\"run\":\"1\\nnothing\"}"));
      assertEquals("{\"id\":10,\"exit\":4}", client.ask("{\"id\":10,\"run\":\"exit(4)\"}"));
      assertTrue(client.ask("{\"id\":11,\"run\":\"print('hello')\"}").contains("\"print\":\"hello\""));
    }
  }

  @Test
  void stopsWhatRuns() throws IOException {
    try (Client client = client()) {
      client.say("{\"id\":1,\"run\":\"print('begun'); while (true) sleep(1)\"}\n");
      assertTrue(client.answers.readLine().contains("begun"));
      List<String> both = List.of(client.ask("{\"id\":2,\"stop\":true}"), client.answers.readLine());
      assertTrue(both.stream().anyMatch(l -> l.startsWith("{\"id\":1,\"stopped\":\"it was stopped")), both.toString());
    }
  }

  @Test
  void aStopWhileItPrintsLeavesTheProgramItsSession() throws IOException {
    try (Client client = client()) {
      for (int round = 0; round < 30; round++) {
        client.say("{\"id\":1,\"run\":\"while (true) print('on')\"}\n");
        assertTrue(client.answers.readLine().contains("on"), "round " + round);
        client.say("{\"id\":2,\"stop\":true}\n");
        List<String> both = new ArrayList<>(List.of("{\"id\":1,\"stopped\"", "{\"id\":2,\"stopping\""));
        String line = "";
        while (line != null && !both.isEmpty()) {
          line = client.answers.readLine();
          String answer = String.valueOf(line);
          both.removeIf(answer::startsWith);
        }
        assertNotNull(line, "the connection was closed in round " + round);
      }
    }
  }

  @Test
  void whoGoesGivesBackControl() throws IOException {
    try (Client client = client()) {
      client.ask("{\"id\":1,\"run\":\"takeControl()\"}");
      assertTrue(natalie.authority().holder().isPresent());
    }
    while (natalie.authority().holder().isPresent()) {
      Thread.onSpinWait();
    }
    assertEquals(Optional.empty(), natalie.authority().holder());
  }

  @Test
  void onlyItsUserMayOpenIt() throws IOException {
    assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(door.file())));
    assertEquals("rwx------", PosixFilePermissions.toString(Files.getPosixFilePermissions(door.file().getParent())));
    door.close();
    assertFalse(Files.exists(door.file()));
  }

  @Test
  void nonsenseIsAnsweredAndHarmsNobody() throws IOException {
    try (Client client = client()) {
      for (String nonsense : List.of("", "{", "[]", "7", "\u0000\u0001", "{\"id\":1}", "{\"run\":7}", "{\"stop\":1}",
          "[".repeat(50_000), "{\"id\":99999999999999999999,\"run\":[]}", "\ud83e")) {
        assertTrue(client.ask(nonsense).contains("\"error\""), nonsense);
      }
      assertTrue(client.ask("{\"id\":\"x\",\"run\":\"1\"}").startsWith("{\"id\":0,\"value\":1.0"));
    }
  }

  @Test
  void aLineWithoutEndClosesTheConnection() throws IOException {
    try (Client client = client()) {
      try {
        client.say("x".repeat(2 << 20));
      } catch (IOException e) {
        assertTrue(e.getMessage().contains("roken pipe") || e.getMessage().contains("reset"), e.getMessage());
      }
    }
    try (Client client = client()) {
      assertTrue(client.ask("{\"id\":1,\"run\":\"1\"}").contains("\"value\":1.0"), "others are served");
    }
  }

  @Test
  void whatCannotBeSentIsSaid() throws IOException {
    try (Client client = client()) {
      assertTrue(client.ask("{\"id\":1,\"run\":\"[() => 1]\"}").contains("cannot be sent"));
      assertTrue(client.ask("{\"id\":2,\"run\":\"let a = 'x'.repeat(1e7); [a, a, a, a]\"}").contains("cannot be sent"));
    }
  }

  @Test
  void manyScriptsAndManyProgramsAreBounded() throws IOException {
    try (Client client = client()) {
      client.say("{\"id\":1,\"run\":\"sleep(60)\"}\n".repeat(33));
      assertTrue(client.answers.readLine().contains("wait already"));
      List<Client> more = new ArrayList<>();
      for (int i = 0; i < 8; i++) {
        more.add(client());
      }
      assertTrue(firstAnswered(more).answers.readLine().contains("already 8 programs"));
      for (Client each : more) {
        each.close();
      }
    }
  }

  private static Client firstAnswered(List<Client> clients) throws IOException {
    for (int i = 0;; i++) {
      Client client = clients.get(i % clients.size());
      if (client.answers.ready()) {
        return client;
      }
    }
  }

  @Test
  void completesLines() throws IOException {
    try (Client client = client()) {
      assertEquals("{\"id\":1,\"start\":4,\"words\":[\"takeControl\"]}",
          sorted(client.ask("{\"id\":1,\"complete\":\"x = takeC\"}")));
    }
  }

  /** Maps of answers have no order. */
  private static String sorted(String answer) {
    String inner = answer.substring(1, answer.length() - 1);
    List<String> members = new ArrayList<>(List.of(inner.split(",(?=\"(id|start|words)\")")));
    members.sort(null);
    return "{" + String.join(",", members) + "}";
  }
}
