package org.robotui.ros;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.net.socket.HostPort;
import org.robotui.ros.LinkEvent.Kind;
import org.robotui.ros.internal.xmlrpc.XmlRpcClient;
import org.robotui.ros.internal.xmlrpc.XmlRpcLimits;

/** Callers of a node's own API that want to do harm. */
class HostileSlaveCallsTest {

  /** A busy machine takes its time to start a thousand threads. */
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  private final LinkLog links = new LinkLog();
  private final List<String> heard = new CopyOnWriteArrayList<>();
  private final List<String> parameters = new CopyOnWriteArrayList<>();
  private Graph graph;
  private RosNode victim;
  private Publisher<String> honest;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
    honest = graph.node("honest").publisher("chatter", new TextCodec(), PublisherOptions.standard());
    victim = graph.node("victim", links);
    victim.subscriber("chatter", new TextCodec(), SubscriberOptions.standard(), (text, reception) -> heard.add(text));
    victim.parameters().subscribe("/speed", (key, value) -> parameters.add(value.toString()));
    Eventually.await("the honest link", () -> honest.numSubscribers() == 1);
  }

  @AfterEach
  void stop() {
    honest.publish("still here");
    Eventually.await("the honest link's message", () -> heard.contains("still here"));
    graph.close();
  }

  private XmlRpcValue call(String method, XmlRpcValue... arguments) throws Exception {
    List<XmlRpcValue> all = new ArrayList<>(List.of(XmlRpcValue.of("/liar")));
    all.addAll(List.of(arguments));
    try (XmlRpcClient client = new XmlRpcClient(HostPort.ofUri(victim.uri(), "http"), XmlRpcLimits.standard())) {
      return client.call(method, all, PATIENCE);
    }
  }

  @Test
  void publishersWithoutEndMakeNoThreadsWithoutEnd() throws Exception {
    int before = graph.threads().alive().size();
    List<String> uris = IntStream.range(0, 20_000).mapToObj(i -> "http://127.0.0.1:1/" + i).toList();
    call("publisherUpdate", XmlRpcValue.of("/chatter"), XmlRpcValue.ofTexts(uris));
    links.awaitReason(Kind.SUBSCRIPTION, "/chatter", "more than 1024 publishers");
    assertTrue(graph.threads().alive().size() < before + 1_200, graph.threads().alive().size() + " threads");
    call("publisherUpdate", XmlRpcValue.of("/chatter"), XmlRpcValue.ofTexts(List.of()));
  }

  @Test
  void publishersThatAreNoAddressesFailWithTheirText() throws Exception {
    call("publisherUpdate", XmlRpcValue.of("/chatter"),
        XmlRpcValue.ofTexts(List.of("file:///etc/passwd", "http://", "x".repeat(100_000), "")));
    links.awaitReason(Kind.SUBSCRIPTION, "/chatter", "'file:///etc/passwd' is no http://host:port URI");
    assertTrue(links.events().stream().allMatch(event -> event.peer().length() < 600), "peers that nobody can read");
    call("publisherUpdate", XmlRpcValue.of("/chatter"), XmlRpcValue.ofTexts(List.of()));
  }

  @Test
  void argumentsOfWrongTypesAreAnsweredAndChangeNothing() throws Exception {
    for (String method : List.of("publisherUpdate", "paramUpdate", "requestTopic", "getBusInfo", "shutdown")) {
      String answer = call(method, XmlRpcValue.of(1), XmlRpcValue.of(true), XmlRpcValue.of(2.5)).toString();
      assertTrue(answer.contains(method + " takes"), answer);
    }
    assertTrue(
        call("paramUpdate", XmlRpcValue.of("not a name!"), XmlRpcValue.of(1)).toString().contains("not a name!"));
    assertTrue(parameters.stream().noneMatch(value -> value.contains("2.5")), parameters.toString());
  }

  @Test
  void aTopicThatIsNotPublishedIsNotOffered() throws Exception {
    String answer =
        call("requestTopic", XmlRpcValue.of("/secret"), XmlRpcValue.of(XmlRpcValue.ofTexts(List.of("TCPROS"))))
            .toString();
    assertTrue(answer.contains("does not publish /secret"), answer);
  }

  @Test
  void manyWhoHoldTheirConnectionsOpenAreBounded() throws Exception {
    HostPort http = HostPort.ofUri(victim.uri(), "http");
    List<Socket> sockets = new ArrayList<>();
    try {
      for (int i = 0; i < 600; i++) {
        Socket socket = new Socket(http.host(), http.port());
        socket.getOutputStream().write("POST / HTTP/1.1\r\n".getBytes(StandardCharsets.ISO_8859_1));
        sockets.add(socket);
      }
      Eventually.await("the bound", () -> graph.threads().alive().size() < 600);
    } finally {
      for (Socket socket : sockets) {
        closeQuietly(socket);
      }
    }
    Eventually.await("an answer to others", () -> answers("getPid"));
  }

  private boolean answers(String method) {
    try {
      return call(method).toString().contains("Int");
    } catch (Exception e) {
      return false;
    }
  }

  private static void closeQuietly(Socket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      // refused before
    }
  }
}
