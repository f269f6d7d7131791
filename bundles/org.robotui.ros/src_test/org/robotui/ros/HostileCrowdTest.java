package org.robotui.ros;

import org.robotui.net.call.Outcome;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.MessageWriter;
import org.robotui.net.socket.HostPort;
import org.robotui.ros.internal.xmlrpc.XmlRpcClient;
import org.robotui.ros.internal.xmlrpc.XmlRpcFault;
import org.robotui.ros.internal.xmlrpc.XmlRpcLimits;
import org.robotui.testkit.MachineLoad;

/** Many liars at once, at a node's links and at our own master, while two honest nodes talk. */
class HostileCrowdTest {

  private final List<String> heard = new CopyOnWriteArrayList<>();
  private final List<Socket> sockets = new ArrayList<>();
  private Graph graph;
  private RosNode talker;
  private Publisher<String> honest;
  private HostPort tcp;
  private HostPort master;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
    talker = graph.node("talker");
    honest = talker.publisher("chatter", new TextCodec(), PublisherOptions.standard());
    graph.node("listener").subscriber("chatter", new TextCodec(), SubscriberOptions.standard(),
        (text, reception) -> heard.add(text));
    Eventually.await("the honest link", () -> honest.numSubscribers() == 1);
    talker.serviceServer("door", HostileCrowdTest.echo(), (request, caller) -> request);
    assertTrue(talker.awaitRegistered(Duration.ofSeconds(30)));
    tcp = HostPort.ofUri(talker.master().lookupService("/door").toOptional().orElseThrow(), "rosrpc");
    master = HostPort.ofUri(graph.master().uri().toString(), "http");
  }

  private static org.robotui.message.ServiceCodec<String, String> echo() {
    return new org.robotui.message.ServiceCodec<>("test/Echo", "0123456789abcdef0123456789abcdef", new TextCodec(),
        new TextCodec());
  }

  @AfterEach
  void stop() throws Exception {
    honest.publish("still here");
    Eventually.await("the honest link's message", () -> heard.contains("still here"));
    for (Socket socket : sockets) {
      socket.close();
    }
    graph.close();
  }

  private Socket connect(HostPort to, byte[] bytes) throws IOException {
    Socket socket = new Socket(to.host(), to.port());
    sockets.add(socket);
    socket.setSoTimeout(5_000);
    socket.getOutputStream().write(bytes);
    return socket;
  }

  private static boolean isOpen(Socket socket) {
    try {
      socket.setSoTimeout(1);
      return socket.getInputStream().read() >= 0;
    } catch (java.net.SocketTimeoutException e) {
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  @Test
  void halfOpenConnectionsAreEndedAfterTheHandshakeTime() throws Exception {
    for (int i = 0; i < 100; i++) {
      connect(tcp, new byte[]{(byte) 0xff, (byte) 0xff, 0x0f});
    }
    honest.publish("meanwhile");
    Eventually.await("a message meanwhile", () -> heard.contains("meanwhile"));
    Eventually.await("the end of all", () -> sockets.stream().noneMatch(HostileCrowdTest::isOpen));
  }

  @Test
  void announcedHeadersCostNoMemory() throws Exception {
    long before = used();
    for (int i = 0; i < 300; i++) {
      connect(tcp, new MessageWriter().i32(1 << 20).toByteArray());
    }
    honest.publish("meanwhile");
    Eventually.await("a message meanwhile", () -> heard.contains("meanwhile"));
    assertTrue(used() - before < 100L << 20, "300 announcements of 1 MiB cost " + ((used() - before) >> 20) + " MiB");
  }

  private static long used() {
    System.gc();
    return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
  }

  @Test
  void aHeaderThatDripsIsCutOffInTime() throws Exception {
    Socket socket = connect(tcp, new MessageWriter().i32(1000).toByteArray());
    long start = System.nanoTime();
    Eventually.await("the end of the connection", () -> {
      try {
        socket.getOutputStream().write('x');
        return !isOpen(socket);
      } catch (IOException e) {
        return true;
      }
    });
    assertTrue(System.nanoTime() - start < 5_000_000_000L * MachineLoad.factor());
  }

  @Test
  void aSubscriberThatNeverReadsHoldsUpNobody() throws Exception {
    connect(tcp, ConnectionHeaders.subscriber("/chatter", "*"));
    Eventually.await("its link", () -> honest.numSubscribers() == 2);
    String large = "x".repeat(1 << 20);
    long start = System.nanoTime();
    for (int i = 0; honest.dropped() == 0 && i < 2_000; i++) {
      honest.publish(large);
    }
    assertTrue(honest.dropped() > 0, "its queue has no bound");
    assertTrue(System.nanoTime() - start < 8_000_000_000L * MachineLoad.factor(), "publishing waits for it");
  }

  @Test
  void garbageAtOurMasterIsRefusedAndOthersAreServed() throws Exception {
    for (String garbage : List.of("\u0000\u0001\u0002\r\n\r\n", "GET / HTTP/1.1\r\n\r\n",
        "POST / HTTP/1.1\r\nContent-Length: 99999999\r\n\r\n",
        "POST / HTTP/1.1\r\nContent-Length: 60\r\n\r\n<?xml version='1.0'?><!DOCTYPE a [<!ENTITY b 'c'>]><methodCall/>",
        "POST / HTTP/1.1\r\n" + "X: y\r\n".repeat(4_000))) {
      connect(master, garbage.getBytes(StandardCharsets.ISO_8859_1));
    }
    assertTrue(talker.parameters().set("/speed", XmlRpcValue.of(1)) instanceof Outcome.Done);
    assertEquals(new Outcome.Done<>(XmlRpcValue.of(1)), talker.parameters().get("/speed"));
  }

  @Test
  void parametersInEndlessNamespacesAreRefused() throws Exception {
    try (XmlRpcClient liar = new XmlRpcClient(master, XmlRpcLimits.standard())) {
      for (String key : List.of("/a".repeat(1_000_000), "/a".repeat(100), "x".repeat(5_000))) {
        for (String method : List.of("getParam", "hasParam", "deleteParam")) {
          assertTrue(fault(liar, method, XmlRpcValue.of(key)).contains("a parameter's name of"), method);
        }
        assertTrue(fault(liar, "setParam", XmlRpcValue.of(key), XmlRpcValue.of(1)).contains("a parameter's name of"));
      }
    }
    assertTrue(talker.parameters().set("/a/b/c/d", XmlRpcValue.of(1)) instanceof Outcome.Done);
  }

  private static String fault(XmlRpcClient client, String method, XmlRpcValue... arguments) throws IOException {
    List<XmlRpcValue> all = new ArrayList<>(List.of(XmlRpcValue.of("/liar")));
    all.addAll(List.of(arguments));
    try {
      return client.call(method, all).toString();
    } catch (XmlRpcFault e) {
      return e.getMessage();
    }
  }

  @Test
  void wrongArgumentsAtOurMasterChangeNothing() throws Exception {
    try (XmlRpcClient liar = new XmlRpcClient(master, XmlRpcLimits.standard())) {
      for (String method : List.of("registerPublisher", "registerSubscriber", "registerService", "unregisterPublisher",
          "lookupNode",
          "getPublishedTopics", "setParam", "subscribeParam")) {
        assertTrue(fault(liar, method, XmlRpcValue.of(1), XmlRpcValue.of(true), XmlRpcValue.of(2), XmlRpcValue.of(3))
            .contains(" takes "), method);
      }
      fault(liar, "unregisterPublisher", XmlRpcValue.of("/chatter"), XmlRpcValue.of("http://127.0.0.1:1/"));
    }
    assertTrue(
        talker.master().systemState().toOptional().orElseThrow().publishers().get("/chatter").contains("/talker"));
  }
}
