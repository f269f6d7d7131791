package org.robotui.rfic.smartsoft.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.api.Rfic;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.guard.Guards;
import org.robotui.testkit.FakeRficContext;

/** The robot interface with servers that say what recorded ones said. */
@Timeout(120)
class RecordedSmartTest {
  private static final String TIME = "exampleComponent10/TimeExample";

  private final FakeRficContext context = new FakeRficContext();
  private Rfic rfic;

  @AfterEach
  void close() {
    rfic.close();
  }

  private void start(RecordedServers servers) {
    rfic = SmartSessions.rfic(context,
        SmartPeer.settings(Map.of("host", "127.0.0.1", "port", (long) servers.port())), new Guards());
    rfic.start();
  }

  private static void await(String what, BooleanSupplier condition) throws InterruptedException {
    long end = System.nanoTime() + 60_000_000_000L;
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, what);
      Thread.sleep(10);
    }
  }

  private List<DynamicRecord> records(String port) {
    return context.published.getOrDefault(port, new ArrayDeque<>()).stream()
        .map(published -> (DynamicRecord) published.value()).toList();
  }

  private List<Double> numbers(String port, String field) {
    return records(port).stream().map(record -> ((FieldValue.Num) record.field(field).orElseThrow()).value()).toList();
  }

  @Test
  void updates_and_events_are_records() throws Exception {
    try (RecordedServers servers = new RecordedServers("ns_send_client.s2c",
        Map.of("TimeExample", "push", "eventInterval", "event_interval"))) {
      start(servers);
      await("it is connected", () -> context.links.peekLast() instanceof LinkState.Connected);
      context.demand(TIME, true);
      context.demand("exampleComponent40/eventInterval", true);
      await("updates come", () -> numbers(TIME, "seconds").size() == 5);
      assertEquals(1_795_236_128.0, numbers(TIME, "seconds").getFirst());
      await("an event comes", () -> !records("exampleComponent40/eventInterval").isEmpty());
      DynamicRecord event = records("exampleComponent40/eventInterval").getFirst();
      assertEquals(new FieldValue.Text("outside"), event.field("text").orElseThrow());
    }
  }

  @Test
  @SuppressWarnings("unchecked")
  void queries_are_answered_and_listed() throws Exception {
    try (RecordedServers servers = new RecordedServers("ns_query_server.s2c",
        Map.of("time-handler", "query_time", "calc-handler", "query_calc"))) {
      start(servers);
      await("it is connected", () -> context.links.peekLast() instanceof LinkState.Connected);
      ServiceReply reply = (ServiceReply) ((CallHandler<ServiceRequest, ?>) context.handlers.get("services"))
          .handle(SmartInvocation.of("exampleComponent1/calc-handler", Map.of("values", List.of(10, 11, 12))));
      assertEquals(33, assertInstanceOf(FieldValue.Num.class, reply.value().field("value").orElseThrow()).value());
      String listed = context.browsers.get("graph").list(Browser.Kind.SERVICE).stream().map(Browser.Item::name)
          .collect(Collectors.joining(" "));
      assertTrue(listed.contains("exampleComponent1/calc-handler"), listed);
    }
  }
}
