package org.robotui.ros;

import org.robotui.net.call.Outcome;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.message.MessageWriter;
import org.robotui.message.ServiceCodec;
import org.robotui.net.socket.HostPort;
import org.robotui.ros.internal.tcpros.ConnectionHeader;
import org.robotui.ros.internal.xmlrpc.XmlRpcClient;
import org.robotui.ros.internal.xmlrpc.XmlRpcLimits;
import org.robotui.testkit.MachineLoad;

/**
 * Servers of services that answer what they should not: the call fails with a reason, in time, and other calls do not.
 */
class HostileServiceServerTest {

  private static final ServiceCodec<String, String> ECHO =
      new ServiceCodec<>("test/Echo", "0123456789abcdef0123456789abcdef",
          new TextCodec(), new TextCodec());

  /** What a server sends after it read the client's header. */
  private interface Bytes {

    byte[] of(MessageWriter out);
  }

  private Graph graph;
  private RosNode client;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
    RosNode honest = graph.node("honest");
    honest.serviceServer("honest", ECHO, (request, caller) -> request);
    assertTrue(honest.awaitRegistered(Duration.ofSeconds(30)));
    client =
        graph.open(RosEnvironment.of(graph.master().uri()), "client", graph.options().withMaxMessageBytes(1_000_000));
  }

  @AfterEach
  void stop() {
    try (ServiceClient<String, String> echo = client.serviceClient("/honest", ECHO, false)) {
      assertEquals(new Outcome.Done<>("still here"), echo.call("still here", Duration.ofSeconds(5)));
    }
    graph.close();
  }

  private void register(String uri) throws Exception {
    try (XmlRpcClient master =
        new XmlRpcClient(HostPort.ofUri(graph.master().uri().toString(), "http"), XmlRpcLimits.standard())) {
      master.call("registerService", List.of(XmlRpcValue.of("/liar"), XmlRpcValue.of("/lies"), XmlRpcValue.of(uri),
          XmlRpcValue.of("http://127.0.0.1:1/")));
    }
  }

  private Outcome<String> call(ScriptedServer.Script script, Duration time) throws Exception {
    try (ScriptedServer server = new ScriptedServer(graph, script);
        ServiceClient<String, String> lies = client.serviceClient("/lies", ECHO, true)) {
      register(server.uri("rosrpc"));
      long start = System.nanoTime();
      Outcome<String> outcome = lies.call("question", time);
      assertTrue(System.nanoTime() - start < time.toNanos() + 1_000_000_000L * MachineLoad.factor(),
          "the call took too long");
      return outcome;
    }
  }

  private static byte[] header() {
    return ConnectionHeader.of("/liar").with("type", ECHO.type()).with("md5sum", ECHO.md5()).encode();
  }

  private static void frame(InputStream in) throws IOException {
    byte[] length = in.readNBytes(4);
    in.readNBytes(length[0] & 0xff | (length[1] & 0xff) << 8);
  }

  static Stream<Arguments> lies() {
    return Stream.of(
        lie("a header that is too long", out -> out.i32(-1).toByteArray(), "connection header of 4294967295 bytes"),
        lie("a header that is cut off", out -> out.i32(100).i32(1).toByteArray(),
            "connection header cut off: 4 of 100"),
        lie("a refusal as long as a book", out -> ConnectionHeader.error("/liar", "no\n".repeat(100_000)).encode(),
            "refused: no no"),
        lie("nothing", out -> new byte[0], "closed by the peer"));
  }

  private static Arguments lie(String name, Bytes bytes, String reason) {
    return Arguments.of(name, (ScriptedServer.Script) (in, out) -> {
      frame(in);
      out.write(bytes.of(new MessageWriter()));
    }, reason);
  }

  static Stream<Arguments> liesAfterTheHeader() {
    return Stream.of(
        after("an answer of another kind", out -> out.u8(7).i32(0).toByteArray(), "answer that starts with 7"),
        after("an answer that is too long", out -> out.u8(1).i32(-1).toByteArray(), "response of 4294967295 bytes"),
        after("an answer that is cut off", out -> out.u8(1).i32(900_000).i32(1).toByteArray(),
            "response cut off: 4 of 900000"),
        after("an answer without its length", out -> out.u8(1).u8(1).toByteArray(),
            "cut off in the length of response"),
        after("an answer that is none", out -> out.u8(1).i32(8).i32(77).i32(0).toByteArray(), "data"),
        after("no answer", out -> new byte[0], "closed by the peer before its answer"));
  }

  private static Arguments after(String name, Bytes bytes, String reason) {
    return Arguments.of(name, (ScriptedServer.Script) (in, out) -> {
      frame(in);
      out.write(header());
      frame(in);
      out.write(bytes.of(new MessageWriter()));
    }, reason);
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource({"lies", "liesAfterTheHeader"})
  void aLieIsTheReasonOfAFailedCall(String name, ScriptedServer.Script script, String reason) throws Exception {
    Outcome<?> outcome = assertInstanceOf(Outcome.Failed.class, call(script, Duration.ofSeconds(5)));
    assertTrue(outcome.reason().contains("/lies") && outcome.reason().contains(reason), outcome.reason());
    assertTrue(outcome.reason().length() < 800, "a reason that nobody can read");
  }

  @Test
  void silenceAndDripsTimeOut() throws Exception {
    String start =
        new String(new MessageWriter().i32(1000).toByteArray(), java.nio.charset.StandardCharsets.ISO_8859_1);
    for (ScriptedServer.Script script : List.of(ScriptedServer.silence(), ScriptedServer.drips(start, "x"))) {
      Outcome<?> outcome = assertInstanceOf(Outcome.TimedOut.class, call(script, Duration.ofMillis(700)));
      assertTrue(outcome.reason().contains("/lies"), outcome.reason());
    }
  }

  @Test
  void anAddressThatIsNoneIsNamed() throws Exception {
    for (String uri : List.of("http://127.0.0.1:80", "rosrpc://", "rosrpc://127.0.0.1", "")) {
      register(uri);
      try (ServiceClient<String, String> lies = client.serviceClient("/lies", ECHO, false)) {
        Outcome<?> outcome = assertInstanceOf(Outcome.Failed.class, lies.call("question", Duration.ofSeconds(2)));
        assertTrue(outcome.reason().contains("/lies") && outcome.reason().contains("'" + uri), outcome.reason());
      }
    }
  }

  @Test
  void aProbeOfALiarFailsToo() throws Exception {
    try (ScriptedServer server = new ScriptedServer(graph, (in, out) -> {
      frame(in);
      out.write(ConnectionHeader.of("/liar").encode());
    })) {
      register(server.uri("rosrpc"));
      Outcome<?> outcome = assertInstanceOf(Outcome.Failed.class, client.probeService("/lies", Duration.ofSeconds(2)));
      assertTrue(outcome.reason().contains("/lies") && outcome.reason().contains("without field 'type'"),
          outcome.reason());
    }
  }
}
