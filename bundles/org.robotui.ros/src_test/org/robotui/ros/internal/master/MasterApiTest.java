package org.robotui.ros.internal.master;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.net.socket.HostPort;
import org.robotui.net.thread.Workers;
import org.robotui.ros.Eventually;
import org.robotui.ros.TestThreads;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.xmlrpc.ApiMethods;
import org.robotui.ros.internal.xmlrpc.XmlRpcClient;
import org.robotui.ros.internal.xmlrpc.XmlRpcLimits;
import org.robotui.ros.internal.xmlrpc.XmlRpcServer;
import org.robotui.ros.master.MasterOptions;
import org.robotui.ros.master.RosMaster;
import org.robotui.testkit.MachineLoad;

/** The master as seen over XML-RPC, with a scripted node that remembers what it is told. */
class MasterApiTest {

  private final TestThreads threads = new TestThreads();
  private final List<String> told = new CopyOnWriteArrayList<>();
  private RosMaster master;
  private XmlRpcClient client;
  private XmlRpcServer node;
  private String api;

  @BeforeEach
  void start() throws Exception {
    master = RosMaster.open(new MasterOptions(threads, java.util.Optional.empty(), 0, false));
    client = new XmlRpcClient(HostPort.ofUri(master.uri().toString(), "http"), XmlRpcLimits.standard());
    node =
        new XmlRpcServer(InetAddress.getByName("127.0.0.1"), 0, XmlRpcLimits.standard(), new Workers(threads), "node");
    node.start(call -> {
      told.add(call.method() + " " + text(new XmlRpcValue.Array(call.arguments().subList(1, call.arguments().size()))));
      return ApiMethods.success("", 0);
    });
    api = "http://127.0.0.1:" + node.port() + "/";
  }

  @AfterEach
  void stop() {
    client.close();
    node.close();
    master.close();
    threads.assertNoneLeft();
  }

  /** Lists as [a, b], everything else as it is. */
  private static String text(XmlRpcValue value) {
    return switch (value) {
      case XmlRpcValue.Array array -> array.items().stream().map(MasterApiTest::text).toList().toString();
      case XmlRpcValue.Struct struct -> struct.members().keySet().toString();
      case XmlRpcValue.Text text -> text.value();
      case XmlRpcValue.Int number -> Integer.toString(number.value());
      default -> value.toString();
    };
  }

  /** Calls as a node and answers [code, value]. */
  private String call(String caller, String method, String... arguments) throws Exception {
    List<XmlRpcValue> all = new java.util.ArrayList<>(List.of(XmlRpcValue.of(caller)));
    Arrays.stream(arguments).map(XmlRpcValue::of).forEach(all::add);
    List<XmlRpcValue> answer = ((XmlRpcValue.Array) client.call(method, all)).items();
    return text(answer.get(0)) + " " + text(answer.get(2));
  }

  private void awaitTold(String... messages) {
    Eventually.await(List.of(messages) + " among " + told, () -> told.containsAll(List.of(messages)));
  }

  @Test
  void subscribersHearOfPublishersThatComeAndGo() throws Exception {
    assertEquals("1 []", call("/s", "registerSubscriber", "/t", "a/T", api));
    assertEquals("1 [" + api + "]", call("/p", "registerPublisher", "t", "a/T", "http://p:1/"));
    awaitTold("publisherUpdate [/t, [http://p:1/]]");
    assertEquals("1 [http://p:1/]", call("/s2", "registerSubscriber", "/t", "*", "http://s2:1/"));
    assertEquals("1 1", call("/p", "unregisterPublisher", "/t", "http://p:1/"));
    awaitTold("publisherUpdate [/t, []]");
    assertEquals("1 0", call("/p", "unregisterPublisher", "/t", "http://p:1/"));
  }

  @Test
  void onlyTheNodeItselfUnregisters() throws Exception {
    call("/p", "registerPublisher", "/t", "a/T", "http://p:1/");
    assertEquals("1 0", call("/p", "unregisterPublisher", "/t", "http://other:1/"));
    assertEquals("1 0", call("/q", "unregisterPublisher", "/t", "http://p:1/"));
    assertEquals("1 [[[/t, [/p]]], [], []]", call("/x", "getSystemState"));
  }

  @Test
  void aNodeThatComesAgainElsewhereTakesItsNameOver() throws Exception {
    call("/n", "registerPublisher", "/t", "a/T", api);
    call("/n", "registerService", "/svc", "rosrpc://n:1", api);
    call("/n", "registerSubscriber", "/u", "a/T", "http://new:1/");
    awaitTold("shutdown [new node registered with same name]");
    assertEquals("1 http://new:1/", call("/x", "lookupNode", "/n"));
    assertEquals("1 [[], [[/u, [/n]]], []]", call("/x", "getSystemState"));
  }

  @Test
  void servicesHaveOneProviderTheLast() throws Exception {
    call("/a", "registerService", "svc", "rosrpc://a:1", "http://a:1/");
    call("/b", "registerService", "/svc", "rosrpc://b:1", "http://b:1/");
    assertEquals("1 rosrpc://b:1", call("/x", "lookupService", "svc"));
    assertEquals("1 0", call("/a", "unregisterService", "/svc", "rosrpc://a:1"));
    assertEquals("1 1", call("/b", "unregisterService", "/svc", "rosrpc://b:1"));
    assertEquals("-1 ", call("/x", "lookupService", "/svc"));
    assertEquals("-1 ", call("/x", "lookupNode", "/b"));
  }

  @Test
  void topicsAreListedWithTheirTypes() throws Exception {
    call("/p", "registerPublisher", "/a/t", "a/T", api);
    call("/p", "registerPublisher", "/b/t", "*", api);
    call("/s", "registerSubscriber", "/b/t", "b/T", api);
    call("/s", "registerSubscriber", "/c/t", "c/T", api);
    assertEquals("1 [[/a/t, a/T], [/b/t, *]]", call("/x", "getPublishedTopics", ""));
    assertEquals("1 [[/a/t, a/T]]", call("/x", "getPublishedTopics", "/a"));
    assertEquals("1 [[/a/t, a/T], [/b/t, *], [/c/t, c/T]]", call("/x", "getTopicTypes"));
    assertEquals("1 " + master.uri(), call("/x", "getUri"));
  }

  @Test
  void aTypeIsLearnedFromWhoKnowsIt() throws Exception {
    call("/s", "registerSubscriber", "/t", "*", api);
    call("/p", "registerPublisher", "/t", "a/T", api);
    call("/s", "registerSubscriber", "/t", "b/T", api);
    assertEquals("1 [[/t, a/T]]", call("/x", "getTopicTypes"));
  }

  @Test
  void watchersOfParametersAreTold() throws Exception {
    assertEquals("1 []", call("/ns/w", "subscribeParam", api, "p"));
    call("/x", "setParam", "/ns/p", "new");
    awaitTold("paramUpdate [/ns/p, new]");
    call("/x", "setParam", "/ns/p/q", "below");
    awaitTold("paramUpdate [/ns/p/q, below]");
    call("/x", "deleteParam", "/ns");
    awaitTold("paramUpdate [/ns/p, []]");
    assertEquals("1 1", call("/ns/w", "unsubscribeParam", api, "/ns/p"));
    assertEquals("1 0", call("/ns/w", "unsubscribeParam", api, "/ns/p"));
  }

  @Test
  void aNodeThatHangsHoldsUpNoOther() throws Exception {
    try (java.net.ServerSocket silent = new java.net.ServerSocket(0, 10, InetAddress.getByName("127.0.0.1"))) {
      call("/hangs", "registerSubscriber", "/t", "a/T", "http://127.0.0.1:" + silent.getLocalPort() + "/");
      call("/s", "registerSubscriber", "/t", "a/T", api);
      long start = System.nanoTime();
      for (int i = 0; i < 50; i++) {
        call("/p" + i, "registerPublisher", "/t", "a/T", "http://p" + i + ":1/");
      }
      Eventually.await("the last update", () -> told.stream().anyMatch(message -> message.contains("http://p49:1/")));
      assertTrue(System.nanoTime() - start < Duration.ofSeconds(5).toNanos() * MachineLoad.factor());
    }
  }

  @Test
  void aCrowdOfNodesThatHangTakesFewThreadsAndHoldsUpNoneThatAnswers() throws Exception {
    call("/s", "registerSubscriber", "/t", "a/T", api);
    call("/first", "registerPublisher", "/t", "a/T", "http://first:1/");
    awaitTold("publisherUpdate [/t, [http://first:1/]]");
    try (java.net.ServerSocket silent = new java.net.ServerSocket(0, 400, InetAddress.getByName("127.0.0.1"))) {
      for (int i = 0; i < 300; i++) {
        call("/hangs" + i, "registerSubscriber", "/t", "a/T", "http://127.0.0.1:" + silent.getLocalPort() + "/" + i);
      }
      for (int i = 0; i < 20; i++) {
        long start = System.nanoTime();
        String publisher = "http://p" + i + ":1/";
        call("/p" + i, "registerPublisher", "/t", "a/T", publisher);
        Eventually.await("the update", () -> told.stream().anyMatch(message -> message.contains(publisher)));
        assertTrue(System.nanoTime() - start < Duration.ofSeconds(1).toNanos() * MachineLoad.factor(), "held up");
        int most = Notifier.PROVEN_THREADS + Notifier.OTHER_THREADS;
        assertTrue(threads.alive().stream().filter(name -> name.contains(" to ")).count() <= most,
            threads.alive().toString());
      }
    }
  }
}
