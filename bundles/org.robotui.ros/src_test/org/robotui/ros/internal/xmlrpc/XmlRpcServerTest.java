package org.robotui.ros.internal.xmlrpc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.net.socket.HostPort;
import org.robotui.net.thread.Workers;
import org.robotui.ros.Eventually;
import org.robotui.ros.TestThreads;
import org.robotui.ros.XmlRpcValue;

class XmlRpcServerTest {

  private static final XmlRpcLimits LIMITS =
      new XmlRpcLimits(Duration.ofSeconds(2), Duration.ofMillis(500), Duration.ofMillis(700), 200_000, 300_000, 8);

  private final TestThreads threads = new TestThreads();
  private final CountDownLatch release = new CountDownLatch(1);
  private XmlRpcServer server;
  private XmlRpcClient client;

  @BeforeEach
  void start() throws Exception {
    server = new XmlRpcServer(InetAddress.getByName("127.0.0.1"), 0, LIMITS, new Workers(threads), "test");
    server.start(new ApiMethods()
        .add("echo", call -> ApiMethods.success("", call.value(1)), XmlRpcValue.class)
        .add("hang", call -> hang())
        .add("crash", call -> {
          throw new IllegalStateException("on purpose");
        }));
    client = new XmlRpcClient(new HostPort("127.0.0.1", server.port()), XmlRpcLimits.standard());
  }

  private XmlRpcValue hang() {
    try {
      release.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return ApiMethods.success("", 0);
  }

  @AfterEach
  void stop() {
    release.countDown();
    client.close();
    server.close();
    threads.assertNoneLeft();
  }

  private String raw(String request) throws IOException {
    try (Socket socket = new Socket("127.0.0.1", server.port())) {
      socket.setSoTimeout(5_000);
      socket.getOutputStream().write(request.getBytes(StandardCharsets.UTF_8));
      return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private static List<XmlRpcValue> arguments(XmlRpcValue... more) {
    List<XmlRpcValue> all = new java.util.ArrayList<>(List.of(XmlRpcValue.of("/test")));
    all.addAll(List.of(more));
    return all;
  }

  @Test
  void manyCallsShareOneConnection() throws Exception {
    for (int i = 0; i < 50; i++) {
      assertEquals(ApiMethods.success("", i), client.call("echo", arguments(XmlRpcValue.of(i))));
    }
    assertEquals(2, threads.alive().size(), "one acceptor and one connection: " + threads.alive());
  }

  @Test
  void aConnectionTheServerClosedIsReplacedSilently() throws Exception {
    client.call("echo", arguments(XmlRpcValue.of(1)));
    Eventually.await("the idle connection is closed", () -> threads.alive().size() == 1);
    assertEquals(ApiMethods.success("", 2), client.call("echo", arguments(XmlRpcValue.of(2))));
  }

  @Test
  void aCallThatHangsTimesOutAtTheClient() {
    assertThrows(SocketTimeoutException.class, () -> client.call("hang", arguments(), Duration.ofMillis(100)));
  }

  @Test
  void aMethodThatCrashesAnswersAFaultAndTheConnectionGoesOn() throws Exception {
    assertTrue(assertThrows(XmlRpcFault.class, () -> client.call("crash", arguments())).getMessage().contains("crash"));
    assertTrue(
        assertThrows(XmlRpcFault.class, () -> client.call("nothing", arguments())).getMessage().contains("'nothing'"));
    assertEquals(ApiMethods.success("", 3), client.call("echo", arguments(XmlRpcValue.of(3))));
  }

  @Test
  void wrongArgumentsAreAnsweredWithWhatIsExpected() throws Exception {
    assertEquals(ApiMethods.error("echo takes (Text, XmlRpcValue)", XmlRpcValue.of(0)),
        client.call("echo", arguments()));
  }

  @Test
  void callsInOneAreAnsweredInOne() throws Exception {
    XmlRpcValue one = new XmlRpcValue.Struct(java.util.Map.of("methodName", XmlRpcValue.of("echo"),
        "params", new XmlRpcValue.Array(arguments(XmlRpcValue.of(1)))));
    XmlRpcValue answer = client.call("system.multicall", List.of(XmlRpcValue.of(one, XmlRpcValue.of("junk"))));
    List<XmlRpcValue> answers = ((XmlRpcValue.Array) answer).items();
    assertEquals(XmlRpcValue.of(ApiMethods.success("", 1)), answers.get(0));
    assertTrue(answers.get(1).toString().contains("faultString"), answers.toString());
  }

  @Test
  void requestsThatAreNoneAreRefused() throws Exception {
    assertTrue(raw("GET / HTTP/1.1\r\n\r\n").startsWith("HTTP/1.1 405 "));
    assertTrue(raw("POST / HTTP/1.1\r\n\r\n").startsWith("HTTP/1.1 400 "));
    assertTrue(raw("POST / HTTP/1.1\r\nContent-Length: 5\r\n\r\n<a/>x").startsWith("HTTP/1.1 400 "));
    assertTrue(raw("POST / HTTP/1.1\r\nContent-Length: 200001\r\n\r\n").contains("at most 200000"));
    assertTrue(raw("POST / HTTP/1.1\r\nContent-Length: -1\r\n\r\n").contains("'-1'"));
    assertTrue(raw("POST / HTTP/1.1\r\nContent-Length: 99999999999999999999\r\n\r\n").startsWith("HTTP/1.1 400 "));
    assertTrue(raw("POST / HTTP/1.1\r\nno colon\r\n\r\n").startsWith("HTTP/1.1 400 "));
    assertEquals(ApiMethods.success("", 4), client.call("echo", arguments(XmlRpcValue.of(4))));
  }

  @Test
  void aHeaderWithoutEndIsCutOff() throws Exception {
    long start = System.nanoTime();
    raw("POST / HTTP/1.1\r\n" + "X: y\r\n".repeat(2_700));
    assertTrue(System.nanoTime() - start < 3_000_000_000L);
  }

  @Test
  void aClientThatDripsBytesIsCutOff() throws Exception {
    try (Socket socket = new Socket("127.0.0.1", server.port())) {
      socket.setSoTimeout(50);
      long start = System.nanoTime();
      boolean open = true;
      while (open && System.nanoTime() - start < 5_000_000_000L) {
        open = drip(socket);
      }
      assertTrue(!open, "the server keeps a connection that drips");
    }
  }

  private static boolean drip(Socket socket) {
    try {
      socket.getOutputStream().write('P');
      return socket.getInputStream().read() >= 0;
    } catch (SocketTimeoutException e) {
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  @Test
  void largeBodiesShareOneBudgetAndSmallOnesAreAlwaysAnswered() throws Exception {
    try (Socket first = half(); Socket second = half()) {
      Eventually.await("two halves of large bodies", () -> server.bodies() == 262_144);
      String refused = raw("POST / HTTP/1.1\r\nContent-Length: 150000\r\n\r\n" + " ".repeat(65_537));
      assertTrue(refused.startsWith("HTTP/1.1 503 "), refused);
      assertTrue(refused.contains("no room for a body of 131072 bytes: the bodies of all connections may take 300000"),
          refused);
      assertEquals(ApiMethods.success("", 5), client.call("echo", arguments(XmlRpcValue.of(5))));
    }
    Eventually.await("the memory is given back", () -> server.bodies() == 0);
    XmlRpcValue large = XmlRpcValue.of("x".repeat(150_000));
    assertEquals(ApiMethods.success("", large), client.call("echo", arguments(large)));
  }

  private Socket half() throws IOException {
    Socket socket = new Socket("127.0.0.1", server.port());
    socket.getOutputStream().write(
        ("POST / HTTP/1.1\r\nContent-Length: 150000\r\n\r\n" + " ".repeat(70_000)).getBytes(StandardCharsets.UTF_8));
    return socket;
  }

  @Test
  void connectionsAreBounded() throws Exception {
    List<Socket> sockets = new java.util.ArrayList<>();
    for (int i = 0; i < 12; i++) {
      sockets.add(new Socket("127.0.0.1", server.port()));
    }
    sockets.get(11).setSoTimeout(3_000);
    assertEquals(-1, sockets.get(11).getInputStream().read());
    assertTrue(threads.alive().size() <= 9, threads.alive().toString());
    for (Socket socket : sockets) {
      socket.close();
    }
  }
}
