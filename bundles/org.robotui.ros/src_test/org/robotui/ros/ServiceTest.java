package org.robotui.ros;

import org.robotui.net.call.Outcome;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.ServiceCodec;
import org.robotui.testkit.MachineLoad;

class ServiceTest {

  private static final ServiceCodec<String, String> ECHO =
      new ServiceCodec<>("test/Echo", "0123456789abcdef0123456789abcdef",
          new TextCodec(), new TextCodec());
  private static final Duration TIME = Duration.ofSeconds(30);

  private Graph graph;
  private RosNode server;
  private RosNode client;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
    server = graph.node("server");
    client = graph.node("client");
  }

  @AfterEach
  void stop() {
    graph.close();
  }

  private ServiceServer offer(ServiceHandler<String, String> handler) {
    ServiceServer offered = server.serviceServer("echo", ECHO, handler);
    assertTrue(server.awaitRegistered(TIME));
    return offered;
  }

  @Test
  void aCallIsAnswered() {
    offer((request, caller) -> request + " from " + caller);
    try (ServiceClient<String, String> echo = client.serviceClient("/echo", ECHO, false)) {
      assertEquals(new Outcome.Done<>("a from /client"), echo.call("a", TIME));
      assertEquals(new Outcome.Done<>("b from /client"), echo.call("b", TIME));
    }
  }

  @Test
  void aPersistentClientSurvivesARestartOfTheServer() {
    ServiceServer first = offer((request, caller) -> "first");
    try (ServiceClient<String, String> echo = client.serviceClient("echo", ECHO, true)) {
      assertEquals(new Outcome.Done<>("first"), echo.call("a", TIME));
      first.close();
      offer((request, caller) -> "second");
      Eventually.await("the new server", () -> echo.call("b", TIME).equals(new Outcome.Done<>("second")));
    }
  }

  @Test
  void aRefusalCarriesTheServersWords() {
    offer((request, caller) -> {
      throw new ServiceException("not " + request);
    });
    try (ServiceClient<String, String> echo = client.serviceClient("echo", ECHO, false)) {
      assertEquals(new Outcome.Refused<>("not today"), echo.call("today", TIME));
    }
  }

  @Test
  void aHandlerThatThrowsRefusesTheCall() {
    offer((request, caller) -> {
      throw new IllegalStateException("on purpose");
    });
    try (ServiceClient<String, String> echo = client.serviceClient("echo", ECHO, true)) {
      Outcome<?> outcome = assertInstanceOf(Outcome.Refused.class, echo.call("a", TIME));
      assertTrue(outcome.reason().contains("on purpose"), outcome.reason());
    }
  }

  @Test
  void aServiceThatDoesNotExistFailsWithItsName() {
    try (ServiceClient<String, String> echo = client.serviceClient("nowhere", ECHO, false)) {
      Outcome<?> outcome = assertInstanceOf(Outcome.Failed.class, echo.call("a", TIME));
      assertTrue(outcome.reason().contains("/nowhere"), outcome.reason());
    }
  }

  @Test
  void aServerThatIsTooSlowTimesOut() {
    CountDownLatch release = new CountDownLatch(1);
    offer((request, caller) -> {
      await(release);
      return request;
    });
    try (ServiceClient<String, String> echo = client.serviceClient("echo", ECHO, true)) {
      long start = System.nanoTime();
      assertInstanceOf(Outcome.TimedOut.class, echo.call("a", Duration.ofMillis(200)));
      assertTrue(System.nanoTime() - start < 1_000_000_000L * MachineLoad.factor());
      release.countDown();
      assertEquals(new Outcome.Done<>("b"), echo.call("b", TIME));
    }
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Test
  void closingTheClientEndsARunningCall() throws Exception {
    CountDownLatch called = new CountDownLatch(1);
    CountDownLatch release = new CountDownLatch(1);
    offer((request, caller) -> {
      called.countDown();
      await(release);
      return request;
    });
    ServiceClient<String, String> echo = client.serviceClient("echo", ECHO, false);
    Thread closer = new Thread(() -> {
      await(called);
      echo.close();
    });
    closer.start();
    assertInstanceOf(Outcome.Failed.class, echo.call("a", Duration.ofSeconds(20)));
    release.countDown();
    closer.join();
  }

  @Test
  void anotherTypeIsRefusedWithBothSums() {
    offer((request, caller) -> request);
    ServiceCodec<String, String> other =
        new ServiceCodec<>("test/Other", "ffffffffffffffffffffffffffffffff", new TextCodec(), new TextCodec());
    try (ServiceClient<String, String> echo = client.serviceClient("echo", other, false)) {
      Outcome<?> outcome = assertInstanceOf(Outcome.Failed.class, echo.call("a", TIME));
      assertTrue(outcome.reason().contains(ECHO.md5()) && outcome.reason().contains(other.md5()), outcome.reason());
    }
  }

  @Test
  void aProbeTellsTheType() {
    offer((request, caller) -> request);
    assertEquals(
        new Outcome.Done<>(
            new ServiceIdentity("test/Echo", ECHO.md5(), "std_msgs/String", "std_msgs/String", "/server")),
        client.probeService("echo", TIME));
  }
}
