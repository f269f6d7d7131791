package org.robotui.ros;

import org.robotui.net.call.Outcome;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.ros.LinkEvent.Kind;
import org.robotui.testkit.MachineLoad;

/**
 * Masters that answer what they should not: the node at it says why it has no master, and a node at another one goes
 * on.
 */
class HostileMasterTest {

  private static final String BOMB =
      "<?xml version='1.0'?><!DOCTYPE b [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY c \"&a;&a;&a;&a;&a;\">]>"
          + "<methodResponse><params><param><value>&c;&c;&c;</value></param></params></methodResponse>";
  private static final String HEAD = "HTTP/1.1 200 OK\r\nContent-Length: ";

  private final LinkLog links = new LinkLog();
  private final List<String> heard = new CopyOnWriteArrayList<>();
  private Graph graph;
  private Publisher<String> honest;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
    honest = graph.node("honest").publisher("chatter", new TextCodec(), PublisherOptions.standard());
    graph.node("listener").subscriber("chatter", new TextCodec(), SubscriberOptions.standard(),
        (text, reception) -> heard.add(text));
    Eventually.await("the honest link", () -> honest.numSubscribers() == 1);
  }

  @AfterEach
  void stop() {
    honest.publish("still here");
    Eventually.await("the honest link's message", () -> heard.contains("still here"));
    graph.close();
  }

  private RosNode nodeAt(ScriptedServer master) throws Exception {
    NodeOptions options = graph.options().withLinks(links);
    return graph.open(RosEnvironment.of(URI.create(master.uri("http"))), "victim", options);
  }

  static Stream<Arguments> answers() {
    return Stream.of(
        Arguments.of("garbage", ScriptedServer.answers("\u0000\u0001\u0002 what?\r\n\r\n"), "HTTP"),
        Arguments.of("nothing", ScriptedServer.answers(""), "closed"),
        Arguments.of("cut off in the header", ScriptedServer.answers("HTTP/1.1 200 OK\r\nConte"),
            "HTTP header cut off"),
        Arguments.of("cut off in the body", ScriptedServer.answers(HEAD + "500\r\n\r\n<methodResponse>"),
            "HTTP body cut off"),
        Arguments.of("a length that lies upwards", ScriptedServer.answers(HEAD + "2147483647\r\n\r\n"), "at most"),
        Arguments.of("a length that is negative", ScriptedServer.answers(HEAD + "-5\r\n\r\n"), "'-5'"),
        Arguments.of("no length", ScriptedServer.answers("HTTP/1.1 200 OK\r\n\r\n<a/>"), "without Content-Length"),
        Arguments.of("an error", ScriptedServer.answers("HTTP/1.1 500 No\r\nContent-Length: 0\r\n\r\n"), "500 No"),
        Arguments.of("a header without end", ScriptedServer.floods("HTTP/1.1 200 OK\r\n", "X-More: y\r\n"),
            "header longer than"),
        Arguments.of("an XML bomb", ScriptedServer.answers(ScriptedServer.http(BOMB)), "document types"),
        Arguments.of("endless nesting", ScriptedServer.answers(ScriptedServer.http("<methodResponse><params><param>"
            + "<value><array><data>".repeat(10_000))), "nested deeper"),
        Arguments.of("an element with an endless name", ScriptedServer.answers(ScriptedServer.http(
            "<methodResponse><params><param><value><" + "x".repeat(1 << 20) + ">")), "unknown type"),
        Arguments.of("a wrong shape", ScriptedServer.answers(ScriptedServer.http("<methodResponse><params><param>"
            + "<value><int>1</int></value></param></params></methodResponse>")),
            "did not answer [code, status, value]"),
        Arguments.of("a refusal without end",
            ScriptedServer.answers(ScriptedServer.http(refusal("no\n".repeat(1 << 18)))), "no no"));
  }

  private static String refusal(String status) {
    return "<methodResponse><params><param><value><array><data><value><int>-1</int></value><value>" + status
        + "</value><value><int>0</int></value></data></array></value></param></params></methodResponse>";
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("answers")
  void anAnswerThatIsNoneIsTheReasonOfAFailedLink(String name, ScriptedServer.Script script, String reason)
      throws Exception {
    try (ScriptedServer master = new ScriptedServer(graph, script)) {
      nodeAt(master);
      links.awaitReason(Kind.MASTER, "127.0.0.1:" + master.port(), reason);
      assertTrue(links.reasons(Kind.MASTER).stream().allMatch(r -> r.length() < 800), "reasons that nobody can read");
      assertTrue(links.reasons(Kind.MASTER).stream().noneMatch(r -> r.contains("\n")), "reasons of several lines");
    }
  }

  @Test
  void aMasterThatDripsBytesOrSaysNothingTimesOut() throws Exception {
    for (ScriptedServer.Script script : List.of(ScriptedServer.silence(),
        ScriptedServer.drips("HTTP/1.1 200 OK\r\n", "x"))) {
      try (ScriptedServer master = new ScriptedServer(graph, script)) {
        RosNode node = nodeAt(master);
        Eventually.await("a time-out", Duration.ofSeconds(20), () -> links.reasons(Kind.MASTER).stream().anyMatch(
            r -> r.contains("127.0.0.1:" + master.port()) && r.contains("timed out")));
        long start = System.nanoTime();
        node.close();
        assertTrue(System.nanoTime() - start < 2_000_000_000L * MachineLoad.factor(), "closing waits for the master");
      }
    }
  }

  @Test
  void parametersAndQuestionsFailWithTheMastersName() throws Exception {
    try (ScriptedServer master = new ScriptedServer(graph, ScriptedServer.answers(ScriptedServer.http(BOMB)))) {
      RosNode node = nodeAt(master);
      for (Outcome<?> outcome : List.of(node.parameters().get("/speed"), node.parameters().names(),
          node.master().systemState(),
          node.master().topicTypes())) {
        assertFalse(outcome instanceof Outcome.Done);
        assertTrue(
            outcome.reason().contains("127.0.0.1:" + master.port()) && outcome.reason().contains("document types"),
            outcome.reason());
      }
    }
  }

  @Test
  void valuesOfWrongTypesAreLeftOut() throws Exception {
    String odd =
        "<methodResponse><params><param><value><array><data><value><int>1</int></value><value/><value><array><data>"
            + "<value><int>7</int></value><value><array><data><value>/t</value></data></array></value>"
            + "<value><array><data><value>/a</value><value>b/C</value></data></array></value><value><struct/></value>"
            + "</data></array></value></data></array></value></param></params></methodResponse>";
    try (ScriptedServer master = new ScriptedServer(graph, ScriptedServer.answers(ScriptedServer.http(odd)))) {
      RosNode node = nodeAt(master);
      assertEquals(new Outcome.Done<>(List.of(new TopicInfo("/a", "b/C"))), node.master().topicTypes());
      assertTrue(node.master().systemState() instanceof Outcome.Done);
    }
  }
}
